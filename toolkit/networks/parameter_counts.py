"""How many parameters the networks have: Table 2 of Mason et al. 2022, counted from modules."""

from dataclasses import dataclass

import torch
from torch import nn

from toolkit.datasets.procedural import SKELETON
from toolkit.features import Layout
from toolkit.networks.model import MODELS, Model
from toolkit.networks.predictor import Sizes

N_STYLES = 95  # training styles of 100STYLE
#: Table 2 as printed: animation synthesis network, style modulation network, per style at run time.
PRINTED = {
    "pfnn-onehot": (2_436_380, 194_560, 2_048),
    "lpn-onehot": (4_935_928, 389_120, 4_096),
    "pfnn-resad": (2_436_380, 2_978_440, 31_352),
    "lpn-resad": (4_935_928, 24_952_320, 262_656),
    "pfnn-film": (2_436_380, 35_668_530, 2_048),
    "mann-film": (4_870_392, 35_668_530, 2_048),
    "lpn-film": (4_935_928, 35_668_530, 2_048),
}
WHY = ("the printed number counts each convolution as filters × width weights and as many biases "
       "as it is wide, without its input channels")


@dataclass(frozen=True)
class Row:
    """A row of Table 2: numbers of parameters of a model."""

    name: str  # the model
    synthesis: int  # of the synthesis network with its gating, the paper's A.S.N.
    style: int  # of the style modulation network for all styles, S.M.N.
    per_style: int  # of one style at run time, P.S.R.
    printed: tuple[int, int, int]  # the same three in the paper
    style_as_printed: int  # of the style modulation network, as the paper seems to count them
    note: str  # why a printed number differs from the counted one; empty where none does


def counts(model: Model) -> dict[str, int]:
    """Parameters as Table 2 counts them; ``synthesis`` is experts and gating."""

    def total(*modules: nn.Module) -> int:
        return sum(p.numel() for m in modules for p in m.parameters())

    return {"synthesis": total(model.experts, model.gating), "style": total(model.modulation),
            "per_style": model.style_size}


def table2() -> list[Row]:
    """Table 2, counted from the seven models at the paper's sizes: 25 joints, 95 styles.

    All numbers but one equal the paper's: a FiLM generator has 39,214,592 parameters, the paper
    prints 35,668,530.
    """
    layout, rows = Layout(SKELETON), []
    for name in MODELS:
        with torch.device("meta"):
            model = Model(name, layout, N_STYLES, Sizes())
        counted = counts(model)
        # each convolution counted as in the printed number, see `WHY`
        short = counted["style"]
        for layer in model.modulation.modules():
            if isinstance(layer, nn.Conv1d):
                filters, _, width = layer.weight.shape
                short -= layer.weight.numel() + layer.bias.numel()
                short += filters * width + width
        differs = tuple(counted.values()) != PRINTED[name]
        rows.append(Row(name, **counted, printed=PRINTED[name], style_as_printed=short,
                        note=WHY if differs else ""))
    return rows
