"""Forms of calibrated inference, from the cheapest to the whole: joint error one step ahead on a real take."""

from unittest import mock

import torch
import torch.nn.functional as F
from torch import Tensor

from experiments.one_step import Start, Store, Style, Take
from experiments.tables import Result
from toolkit import published
from toolkit.cli import verbs
from toolkit.io import bvh
from toolkit.networks.experts import BlendedLinear
from toolkit.networks.film import EPSILON, Film


def run(
    clip: Take,
    style: Style,
    parameters: verbs.Published = None,
    model: verbs.TrainedRun = None,
    start: Start = 0,
    store: Store = False,
) -> None:
    """Errors of predicted next frames without calibration, with two cheaper forms of it, and with the whole."""
    net, bank = published.either(model, parameters)
    motion, rows = bvh.load(clip), []
    for form, (what, name, instead) in FORMS.items():
        net.calibrated = form != "none"
        with mock.patch.object(what, name, instead or getattr(what, name)):
            rows.append({"form": form, "error": published.one_step(net, bank, motion, style, (start, None))["joint_mse"]})
        print(f"{rows[-1]['error']:.4f}  {form}", flush=True)
    if store:
        Result("calibration", f"Published parameters one step ahead on {motion.name}, in the model's normalised units",
               "python -m experiments calibration --published DATA/lpn_film_100style --clip DATA/100style/Neutral_FW.bvh "
               "--style Neutral --start 327 --store", {"form": ["form of calibration"], "error": ["joint error", 3]},
               rows).save()


def deviation_only(film: Film, layer: int, f: Tensor, style: Tensor, variance: Tensor) -> Tensor:
    """`Film.expected` with its deviation s, but with ELU(u) in place of the mean over ε."""
    gamma, beta = film._part(layer, style)
    deviation = (f.var(-1, keepdim=True) + variance.mean(-1, keepdim=True)).sqrt() + EPSILON
    return F.elu(gamma * (f - f.mean(-1, keepdim=True)) / deviation + beta)


def squares_of_experts(linear: BlendedLinear, x: Tensor, gates: Tensor) -> Tensor:
    """`BlendedLinear.scatter` with Σₖ αₖ Wₖ² in place of (Σₖ αₖ Wₖ)²."""
    return torch.einsum("bk,bi,kij->bj", gates, x.square(), linear.weight.square())


#: Of each form, what it puts in place of what.
FORMS = {
    "none": (Film, "expected", None),
    "only the deviation s, which needs 36 vectors of precomputed products of experts": (Film, "expected", deviation_only),
    "ν from the squares of the experts, Σₖ αₖ Wₖᵢⱼ², which needs one more product": (BlendedLinear, "scatter",
                                                                                    squares_of_experts),
    "the whole form, which blends the weights for every character": (Film, "expected", None),
}
