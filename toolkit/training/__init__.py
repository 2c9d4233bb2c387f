"""Training (Mason et al. 2022, section 4.3): config, minibatches, loss, loop, a run as one file."""

from toolkit.features.splits import split
from toolkit.training import published
from toolkit.training.loop import fit
from toolkit.training.loss import baselines, evaluate, loss_terms, make_bank, refit
from toolkit.training.minibatches import Minibatches
from toolkit.training.run import Config, Run, load, pretrained

__all__ = ["Config", "Minibatches", "Run", "baselines", "evaluate", "fit", "load", "loss_terms",
           "make_bank", "pretrained", "published", "refit", "split"]
