"""Where swing clearance is lost: a real walk, predicted with more and more of the input taken from the predictions."""

from itertools import pairwise

import torch
from torch import Tensor

from experiments import closed_loop
from experiments.one_step import Start, Store, Style, Take
from experiments.tables import Result
from toolkit import datasets, features, phases, published, runtime, training
from toolkit.cli import verbs
from toolkit.evaluation import metrics
from toolkit.features import pack_joints, split_joints
from toolkit.io import bvh
from toolkit.motion import Clip, root_frames
from toolkit.motion import rotations as R
from toolkit.motion.clip import FEET
from toolkit.networks import Model
from toolkit.networks.bank import StyleBank
from toolkit.networks.phase import advance
from toolkit.styles import fine_tune

#: Of what the predictions give: whether the pose, whether the phases.
FED = {"nothing: one step ahead": (False, False), "phases": (False, True), "pose": (True, False),
       "pose and phases": (True, True)}
WHOLE, LEARNT = "all, at the take's speed, after foot IK", "learnt from the take"
COLUMNS = {"fed": ["from the predictions"], "own": ["clearance, cm", 1, 100], "calibrated": ["calibrated", 1, 100],
           "learnt": ["vector learnt from the take", 1, 100], "height": ["highest, cm", 1, 100],
           "speed": ["fastest up, m/s", 2], "embedded": ["embedded model, procedural walk: clearance, cm", 1, 100]}


def run(
    clip: Take,
    style: Style,
    parameters: verbs.Published = None,
    model: verbs.TrainedRun = None,
    start: Start = 0,
    store: Store = False,
) -> None:
    """Swing clearance of a real walk, and of predictions of it whose input is real but for the pose or the phases.

    The trajectory is always that of the take; a last row is the closed loop. Beside the style's own vector: calibrated
    inference, a vector that is learnt from the take itself, and the embedded model with a procedural walk of the style.
    """
    net, bank = published.either(model, parameters)
    motion, rows, speeds = bvh.load(clip).resample(runtime.FPS), {}, {}
    learnt = fine_tune(net, motion.cut(start).replace(style=LEARNT), bank=bank, method="vector").bank[LEARNT]
    other, others = training.pretrained()
    walk = datasets.load("procedural", styles=[style], gaits=["FW"], seconds=12.0)[0]
    for form, used, vector, real, first in (
        ("own", net, bank[style], motion, start), ("calibrated", net, bank[style], motion, start),
        ("learnt", net, learnt, motion, start), ("embedded", other, others[style], walk, 0),
    ):
        net.calibrated = form == "calibrated"
        level, found = feedback(used, vector, real, first)
        speeds[real.name] = metrics.speed(real.cut(first))
        walked = closed_loop.walk(used, StyleBank((style,), vector[None]), [speeds[real.name]], 10.0)[0]
        for name, row in {"the real take": level, **found, WHOLE: {"clearance": walked["clearance"]}}.items():
            of_own = {key: row[key] for key in ("height", "speed") if key in row}
            rows.setdefault(name, {"fed": name, **of_own})[form] = row["clearance"]
            print(f"{form:<12}{name:<42}" + "  ".join(f"{key} {value:.3f}" for key, value in row.items()), flush=True)
    if store:
        Result("swing", f"Toes of the published network in the take {motion.name}: clearance over the standing height, mean "
               "of the swings; 99 % of the height and of the vertical speed with the style's own vector",
               "python -m experiments swing --published DATA/lpn_film_100style --clip DATA/100style/Neutral_FW.bvh "
               "--style Neutral --start 327 --store", COLUMNS, list(rows.values()), numbers={"speeds, m/s": speeds}).save()


def feedback(net: Model, style: Tensor, clip: Clip, start: int) -> tuple[dict[str, float], dict[str, dict[str, float]]]:
    """Measures of both toes of the real frames of a clip at 60 Hz, and of the predictions for each case of `FED`."""
    layout, rows = net.layout, features.frames(clip, phases.extract(clip), start, None, net.layout.samples)
    real_phase, target = net.observe(rows.phases, rows.outputs)
    roots, block = root_frames(clip), layout.inputs["joints"]
    ahead = R.rotate(roots.rotations, roots.positions.new_tensor([0.0, 0.0, 1.0]))
    world = torch.cat((roots.positions[:, [0, 2]], ahead[:, [0, 2]]), -1)
    pose, phase = (torch.tensor(kind)[:, None] for kind in zip(*FED.values(), strict=True))
    joints, p = (rows.inputs[:1, block].expand(len(FED), -1), real_phase[:1].expand(len(FED), -1))
    toes, contacts = [], []
    with torch.no_grad():
        for i, frame in enumerate(rows.index):
            x = rows.inputs[i].repeat(len(FED), 1)
            x[:, block] = joints = torch.where(pose, joints, x[:, block])
            p = torch.where(phase, p, real_phase[i])
            out = layout.unpack_output(net.predict(x, p, style))
            was, now = split_joints(joints), split_joints(out["joints"])
            place = torch.lerp(was["position"] + now["velocity"] / runtime.FPS, now["position"], 0.5)
            joints = pack_joints(**now | {"position": place})
            joints = runtime.frame._to_frame(runtime.frame._orthonormal(joints), *world[frame : frame + 2, None].expand(
                2, len(FED), -1))
            p = advance(layout, p, out)
            toes.append(joints)
            contacts.append(out["contacts"])
    ends = [layout.names.index(layout.skeleton.roles[f"{side}_toe"]) for side in FEET]
    heights = split_joints(torch.stack(toes, 1))["position"][..., ends, 1]
    true = layout.unpack_output(target)
    level = split_joints(true["joints"])["position"][:, ends, 1]
    seen = torch.stack(contacts, 1)
    return swing(level, true["contacts"]), {name: swing(heights[i], seen[i]) for i, name in enumerate(FED)}


def swing(heights: Tensor, contacts: Tensor) -> dict[str, float]:
    """Measures of the heights ``[F, 2]`` of two toes with contacts ``[F, 2]``, over the heights at which they stand.

    ``clearance``: mean over the swings of the greatest height, metres. ``height`` and ``speed``: 99 % of the heights,
    metres, and of the upward speed, m/s.
    """
    on = contacts > 0.5
    heights = heights - torch.stack([h[c].median() for h, c in zip(heights.T, on.T, strict=True)])
    swings = []
    for h, c in zip(heights.T, on.T, strict=True):
        stand = c.nonzero()[:, 0].tolist()
        swings += [float(h[a + 1 : b].max()) for a, b in pairwise(stand) if b > a + 1]
    return {"clearance": sum(swings) / max(1, len(swings)), "height": float(heights.quantile(0.99)),
            "speed": float((heights.diff(dim=0) * runtime.FPS).quantile(0.99)), "swings": len(swings)}
