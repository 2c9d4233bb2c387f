"""Styles: the bank of vectors, blends and transitions, new styles and the space that styles span.

Mason et al. 2022, sections 4.4 (blends), 5.3.2 (new styles) and Figure 11 (the space).
"""

from toolkit.networks.bank import StyleBank
from toolkit.styles.comparison import Comparison, Learnt, choose, compare, learn, not_a_walk
from toolkit.styles.fine_tuning import METHODS, NewStyles, fine_tune
from toolkit.styles.space import clip_vectors, separation
from toolkit.styles.transitions import EASINGS, transition

__all__ = ["EASINGS", "METHODS", "Comparison", "Learnt", "NewStyles", "StyleBank", "choose",
           "clip_vectors", "compare", "fine_tune", "learn", "not_a_walk", "separation",
           "transition"]
