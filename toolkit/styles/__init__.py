"""Styles: the bank of vectors, blends and transitions, new styles.

Mason et al. 2022, sections 4.4 (blends) and 5.3.2 (new styles).
"""

from toolkit.networks.bank import StyleBank
from toolkit.styles.comparison import Comparison, compare, not_a_walk
from toolkit.styles.fine_tuning import METHODS, NewStyles, fine_tune
from toolkit.styles.learning import Learnt, choose, learn
from toolkit.styles.transitions import EASINGS, transition

__all__ = ["EASINGS", "METHODS", "Comparison", "Learnt", "NewStyles", "StyleBank", "choose",
           "compare", "fine_tune", "learn", "not_a_walk", "transition"]
