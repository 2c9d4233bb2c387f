"""Diverse motion stylisation (Park, Jang and Lee 2021): a GAN that gives a clip another style.

The style comes from a reference clip or from noise.

>>> old = tk.stylization.stylize(tk.stylization.pretrained(), clip, domain="Old", seed=3)
>>> motions = tk.stylization.build(tk.datasets.load("bandai", dataset=2), mirror=True)
>>> run = tk.stylization.fit(motions, tk.stylization.Config.quick())
>>> tired = tk.stylization.stylize(run.stylizer, clip, domain="exhausted", seed=3)
"""

from toolkit.stylization.data import Motions, Statistics, build
from toolkit.stylization.graph import SkeletonGraph
from toolkit.stylization.networks import Discriminator, Sizes, Stylizer, pretrained
from toolkit.stylization.restyling import stylize
from toolkit.stylization.training import Config, Run, fit

__all__ = ["Config", "Discriminator", "Motions", "Run", "Sizes", "SkeletonGraph", "Statistics",
           "Stylizer", "build", "fit", "pretrained", "stylize"]
