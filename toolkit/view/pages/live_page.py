"""A character under control in one HTML file.

Network, runtime and scene run in the browser, without server or Python.
"""

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import torch
from torch import Tensor

from toolkit import registry, runtime
from toolkit.evaluation import findings
from toolkit.features import CHANNELS, FRAME_KINDS, Layout
from toolkit.io import bvh
from toolkit.io.save import figure_of
from toolkit.motion import Clip, Skeleton, clearance
from toolkit.networks import Predictor
from toolkit.networks.film import EPSILON
from toolkit.runtime import rules
from toolkit.runtime.life import PERIOD
from toolkit.view.pages import page
from toolkit.view.render import mannequin as body
from toolkit.view.render.skin import Character, Figure, encoded

#: Styles that differ, if the bank has them: of the procedural and the published model, or recorded.
CORNERS = "Neutral", "Zombie", "Aeroplane", "normal", "old", "musical"
VERTICES = 900  # of each body in a crowd
PANEL = 8  # outputs whose weights are stored together, see ``scene/network.js``
TURN = 2.0  # radians per second while a turn key is held
RUN = 2.2  # speed of a run, relative to walking
RECORDED, SECONDS = 9, 6.0  # walks of a model that does not run in a page, and their length
KEPT = 8  # walks that measure a body
EASE = 0.12  # share of the difference to the marker's blend that a frame removes

_WALKS: dict[bytes, Clip] = {}  # by model and style


def example(model, bank) -> Clip:
    """A walk on a model's skeleton; the last ones are kept.

    Its steps show the height of toes above the soles, and where a character's floor is.
    """
    commands, vector = runtime.straight(1.0, 1.2), bank.vectors[0]
    if not isinstance(model, Predictor):
        return runtime.rollout(model, commands, vector)
    if (key := model.fingerprint(vector)) not in _WALKS:
        _WALKS[key] = runtime.rollout(model, commands, vector)
        if len(_WALKS) > KEPT:
            del _WALKS[next(iter(_WALKS))]
    return _WALKS[key]


def ordered(bank) -> list[str]:
    """Names of all styles, first those of a triangle's first corners."""
    return list(dict.fromkeys([*(name for name in CORNERS if name in bank.names), *bank.names]))


def web(model, bank, path: str | os.PathLike, *, title: str = "A character under control",
        styles: Sequence[str] | None = None, half: bool = False,
        character: Character = None, characters: int = 1) -> Path:
    """Write a page with a character that keyboard, touch, gamepad and a style triangle steer;
    opened by a double click.

    The whole runtime is in the page: features, network, trajectory, foot and arm IK, 60 frames a
    second. ``docs/runtime.md`` says how large the file is, how long a frame takes and how equal it
    is to `toolkit.runtime`.

    Parameters
    ----------
    model, bank
        A model and its style bank. Only LPN-FiLM runs in a page. Of another model, the page plays
        recorded walks of the first nine styles, and says so.
    styles
        The styles to include, first the triangle's corners; by default all of the bank.
    half
        Store the experts' weights as float16, rounded to 3 decimal digits: half the file. The
        embedded model's are float16 already.
    character
        As in `toolkit.view.play`, but it follows the model's joints without foot IK of its own.
    characters
        Number of characters. All but the first, which the user steers, walk on rings around the
        start, each in the next style of the bank at its natural speed.

    Raises
    ------
    ValueError
        If weights are not finite or too large for float16, or a style is unknown.
    """
    if styles is not None and (not styles or isinstance(styles, str)):
        raise ValueError(f"styles must be a list of one name or more, got {styles!r}")
    if characters < 1 or (characters > 1 and character is not None):
        raise ValueError("characters must be 1 or more, and 1 with a character of your own; got "
                         f"{characters}")
    bank = bank.select(dict.fromkeys(ordered(bank) if styles is None else styles))
    if not runs(model):
        names = bank.names[:RECORDED]
        walks = [runtime.rollout(model, runtime.straight(bank.speed(name), SECONDS), bank[name])
                 for name in names]
        caption = f"Recorded walks: the model {model.name} cannot run in a page."
        return page.html(walks, path, title=title, caption=caption, labels=names,
                         character=character)
    data = pack(model, bank, half, figure_of(character), characters)
    size = sum(layer.weight.numel() for layer in model.experts.layers) / 1e6
    caption = (f"A neural network of {size:.1f} million weights makes every frame in this page: "
               "no server, no installation.")
    start = "globalThis.view = toolkitScene.character(stage, data);"
    return page.write(path, title, caption, data, start)


def runs(model) -> bool:
    """Whether a page can compute the model: ``scene/network.js`` is an LPN-FiLM."""
    return model.name == "lpn-film"


def pack(model, bank, half: bool = False, character: Figure | None = None,
         characters: int = 1) -> dict[str, Any]:
    """The data of ``scene/character.js``, which describes the format.

    Of a model that does not run in a page, weights, rules and the first state are left out.
    """
    layout: Layout = model.layout
    walk = example(model, bank)
    lines, joints = bvh.header(layout.skeleton)
    corners = (list(bank.names) * 3)[:3]
    return (_network(model, bank, half) if runs(model) else {}) | {
        "body": _plain(rules.Body.of(layout.skeleton)._asdict()),
        "skeleton": page.skeleton_data(walk, character),
        "styles": list(bank.names),
        "labels": bank.labels(),
        "speeds": [round(bank.speed(name), 2) for name in bank.names],
        "vectors": numbers(bank.vectors),
        "turn": TURN,
        "run": RUN,
        "ease": EASE,
        "others": _others(bank, characters - 1),
        "crowd": page.skeleton_data(walk, vertices=VERTICES) if characters > 1 else None,
        "bvh": {"header": "\n".join([*lines, ""]), "joints": joints,
                "centimetre": bvh.CENTIMETRE},
        "gate": gate(layout.skeleton),
        "traits": {"names": corners, "weights": [1.0, 0.0, 0.0],
                   "speed": round(bank.speed(corners[0]), 2)},
    }


def _network(model, bank, half: bool) -> dict[str, Any]:
    """Weights and rules of an LPN-FiLM, and its state in the first frame."""
    state = runtime.start(model, bank.vectors[0])
    gating = [(layer.weight.T[None], layer.bias[None]) for layer in model.gating.layers]
    experts = [(layer.weight, layer.bias) for layer in model.experts.layers]
    kinds = [model.normaliser(kind) for kind in FRAME_KINDS]
    channels = {name: 3 * i for i, name in enumerate(CHANNELS)} | {"width": 3 * len(CHANNELS)}
    return {
        "network": {
            "means": [numbers(kind.mean) for kind in kinds],
            "deviations": [numbers(kind.std) for kind in kinds],
            "gating": dense(gating, False),
            "experts": {"count": model.sizes.experts} | dense(experts, half),
            "epsilon": EPSILON,
            "dropped": model.dropped if model.calibrated else 0.0,
        },
        "rules": _plain(rules.rules_of(model)._asdict() | channels),
        "start": {name: value[0].flatten().tolist() for name, value in vars(state).items()
                  if name != "style"},
        "life": {"amount": model.life, "period": PERIOD},
    }


def gate(skeleton: Skeleton) -> dict[str, Any]:
    """The rules of `toolkit.evaluation.defects`, for ``scene/findings.js``; none without roles."""
    if not set(findings.ROLES) <= set(skeleton.roles or ()):
        return {}
    return constants(findings) | {
        "POINTS": clearance.POINTS,
        "limits": findings.LIMITS, "units": findings.UNITS, "least": findings.LEAST,
        "others": {" ".join(pair): least for pair, least in findings.OTHERS.items()},
        "roles": {role: skeleton.role(role) for role in findings.ROLES},
        "chest": skeleton.trunk[0],
    }


def constants(module) -> dict[str, float]:
    """The numbers of a module by name."""
    values = vars(module).items()
    return {name: v for name, v in values if name.isupper() and isinstance(v, int | float)}


def _others(bank, count: int) -> list[dict[str, Any]]:
    """Characters on rings, each in another style than its neighbours."""
    if not count:
        return []
    middle = body.rgb(body.COLORS["middle"]) ** 2.2  # linear light
    tints = [(0.6 * (body.rgb(color) ** 2.2 - middle)).round(4).tolist() for color in body.PALETTE]
    made = []
    for i, place in enumerate(torch.stack(registry.find("crowd.places")(count), 1).tolist()):
        style = (i + 1) % len(bank.names)
        made.append(dict(zip(("radius", "angle", "way"), place, strict=True)) | {
            "style": style, "tint": tints[i % len(tints)], "speed": bank.speed(bank.names[style])})
    return made


def numbers(values: Tensor, half: bool = False) -> dict[str, str]:
    """Numbers in a page: little-endian float32 or float16, base64.

    A ValueError if one is not finite or too large.
    """
    kind = np.dtype("<f2" if half else "<f4")
    with np.errstate(over="ignore"):
        array = values.detach().numpy().astype(kind)
    if not np.isfinite(array).all():
        worst = float(values.detach().abs().max())
        raise ValueError(f"weights must be finite and at most {float(np.finfo(kind).max):g} in "
                         f"{kind.name}, got {worst:g}")
    return {"type": kind.name, "data": encoded(array, kind)}


def dense(layers: Sequence[tuple[Tensor, Tensor]], half: bool) -> dict[str, Any]:
    """Dense layers, each of weights ``[K, in, out]`` and biases ``[K, out]``."""
    return {"widths": [layers[0][0].shape[1], *(bias.shape[1] for _, bias in layers)],
            "layers": [numbers(panels(*layer), half) for layer in layers]}


def panels(weight: Tensor, bias: Tensor) -> Tensor:
    """Weights ``[K, in, out]`` and biases ``[K, out]`` as read: ``[panels, K, in + 1, PANEL]``."""
    whole = torch.cat((weight, bias[:, None]), 1)
    whole = torch.nn.functional.pad(whole, (0, -whole.shape[-1] % PANEL))
    return whole.unflatten(-1, (-1, PANEL)).permute(2, 0, 1, 3).contiguous()


def _plain(fields: dict[str, Any]) -> dict[str, Any]:
    return {name: np.asarray(value).tolist() for name, value in fields.items()}
