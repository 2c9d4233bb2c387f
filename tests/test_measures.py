"""The field's measures against plain loops over their definitions, and against motions whose answer is computed by hand."""

import cmath
import json
import math
from itertools import pairwise
from types import SimpleNamespace

import pytest
import torch

import toolkit as tk
from toolkit.__main__ import main
from toolkit.evaluation import MEASURES, measures, recognition
from toolkit.motion import contacts
from toolkit.motion import rotations as R

NAMES = ["hips", "chest", "left_foot", "left_toe", "right_foot", "right_toe", "left_shoulder", "right_shoulder"]
PARENTS = [-1, 0, 0, 2, 0, 4, 1, 1]
OFFSETS = [[0, 1, 0], [0, 0.4, 0], [0.1, -0.9, 0], [0, -0.1, 0.1], [-0.1, -0.9, 0], [0, -0.1, 0.1],
           [0.1, 0.1, 0], [-0.1, 0.1, 0]]


def stick(frames=41, speed=0.0, fps=20.0, lift=0.0):
    """A figure that slides along +X without moving a joint; its left toe is lifted by some metres."""
    offsets = torch.tensor(OFFSETS)
    offsets[3, 1] += lift
    roles = {name: name for name in NAMES} | {"left_hip": "left_foot", "right_hip": "right_foot"}
    skeleton = tk.Skeleton(NAMES, PARENTS, offsets, roles)
    positions = torch.zeros(frames, 3)
    positions[:, 0], positions[:, 1] = torch.arange(frames) * speed / fps, 1.0
    return tk.Clip(skeleton, R.identity(frames, len(NAMES)), positions, fps)


def turned(clip, joint, angles):
    """The clip with a joint turned about its X axis by an angle per frame."""
    q = clip.rotations.clone()
    q[:, joint] = R.from_axis_angle(torch.tensor([1.0, 0.0, 0.0]).expand(len(clip), 3), torch.as_tensor(angles))
    return clip.replace(rotations=q)


@pytest.fixture(scope="module")
def walks():
    """A walk whose feet slide and that slowly rises, and the original."""
    real = tk.datasets.load("procedural", styles=["Zombie"], gaits=["FW"], seconds=4.0)[0]
    time = torch.arange(len(real))[:, None] / real.fps
    moved = real.root_positions + time * torch.tensor([0.25, 0.004, -0.1]) * (1 + torch.sin(3 * time))
    return real.replace(root_positions=moved).moved(turn=0.4), real


def toes(clip):
    where = clip.global_positions.tolist()
    floor = float(contacts.standing_height(clip))
    return [[(p[j][0], p[j][1] - floor, p[j][2]) for j in (clip.skeleton.role("left_toe"), clip.skeleton.role("right_toe"))]
            for p in where], floor


def slow_smoodi(clip):
    _, floor = toes(clip)
    every = clip.resample(20.0)
    place = [[every.global_positions[f, every.skeleton.role(f"{side}_toe")].tolist() for f in range(len(every))]
             for side in ("left", "right")]
    skating = set()
    for path in place:
        speeds = [20 * math.hypot(b[0] - a[0], b[2] - a[2]) for a, b in pairwise(path)]
        for f, speed in enumerate(speeds):
            around = [speeds[g] if 0 <= g < len(speeds) else 0.0 for g in range(f - 2, f + 3)]
            low = path[f][1] - floor < 0.05 and path[f + 1][1] - floor < 0.05
            if low and speed > 0.5 and sum(around) / 5 > 0.5:
                skating.add(f)
    return len(skating) / (len(every) - 1)


def slow_kimodo(clip):
    path, _ = toes(clip)
    on = off = 0
    for a, b in pairwise(path):
        for i in range(2):
            if a[i][1] < 0.05 and b[i][1] < 0.05:
                on += 1
                off += math.dist(a[i], b[i]) * clip.fps > 0.2
    return off / on


def slow_camdm(clip):
    path, _ = toes(clip)
    hips = clip.global_positions[:, clip.skeleton.role("hips")].tolist()
    way = sum(math.hypot(b[0] - a[0], b[2] - a[2]) for a, b in pairwise(hips)) / (len(hips) - 1)
    slid = []
    for f, pair in enumerate(path):
        after = path[min(f + 1, len(path) - 1)]
        slid += [math.hypot(after[i][0] - pair[i][0], after[i][2] - pair[i][2]) for i in range(2) if pair[i][1] < 0.01]
    return sum(slid) / len(slid) / way


def slow_rsmt(clip):
    path, _ = toes(clip)
    found = []
    for a, b in pairwise(path):
        for i in range(2):
            if (weight := min(1.0, max(0.0, 2 - 2 ** (100 * b[i][1] / 2.5)))) > 0:
                found.append(math.dist(a[i], b[i]) * clip.fps * weight)
    return sum(found) / len(found)


def slow_npss(clip, real):
    n, joints, weighted, weights = len(clip), len(clip.skeleton), 0.0, 0.0
    made, truth = (R.unroll(c.global_rotations.double()) for c in (clip, real))
    for j in range(joints):
        sign = -1 if float((made[:, j] * truth[:, j]).sum()) < 0 else 1
        for c in range(4):
            shares, totals = [], []
            for x in ((sign * made[:, j, c]).tolist(), truth[:, j, c].tolist()):
                power = [abs(sum(v * cmath.exp(-2j * math.pi * k * t / n) for t, v in enumerate(x))) ** 2 for k in range(n)]
                totals.append(sum(power))
                shares.append([sum(power[: k + 1]) / (totals[-1] or 1.0) for k in range(n)])
            weighted += totals[1] * sum(abs(a - b) for a, b in zip(*shares, strict=True))
            weights += totals[1]
    return weighted / weights


def slow_geodesic(clip, real):
    a, b = (R.to_matrix(R.normalize(c.rotations.double())) for c in (clip, real))
    angles = [math.acos(max(-1.0, min(1.0, (float((p @ q.T).trace()) - 1) / 2)))
              for x, y in zip(a, b, strict=True) for p, q in zip(x, y, strict=True)]
    return sum(angles) / len(angles)


@pytest.mark.parametrize(("name", "slow"), [("skate-smoodi", slow_smoodi), ("skate-kimodo", slow_kimodo),
                                            ("skate-camdm", slow_camdm), ("skate-rsmt", slow_rsmt)])
def test_skate_is_what_a_plain_loop_over_its_definition_finds(walks, name, slow):
    found = [MEASURES[name](clip) for clip in walks]
    assert found == pytest.approx([slow(clip) for clip in walks], rel=1e-4)
    assert found[0] > found[1] > 0  # sliding is worse than the original, and a walk whose feet stand does not score 0


def test_pairs_are_what_plain_loops_over_their_definitions_find(walks):
    clip, real = (c.cut(0, 24) for c in walks)
    clip = turned(clip, 3, 0.3 * torch.sin(torch.arange(24.0)))
    assert MEASURES["npss"](clip, real) == pytest.approx(slow_npss(clip, real), rel=1e-6)
    assert MEASURES["geodesic"](clip, real) == pytest.approx(slow_geodesic(clip, real), rel=1e-4)
    apart = [math.dist(p, q) for x, y in zip(clip.global_positions.tolist(), real.global_positions.tolist(), strict=True)
             for p, q in zip(x, y, strict=True)]
    assert MEASURES["global-position"](clip, real) == pytest.approx(sum(apart) / len(apart), rel=1e-4)


def test_skate_of_a_sliding_figure_computed_by_hand():
    assert [f(stick()) for f in measures.CLIP.values()] == [0, 0, 0, 0]
    for speed, smoodi in ((0.45, 0.0), (0.6, 36 / 40), (1.0, 1.0)):  # the mean over five frames begins at 3/5 and 4/5 of it
        found = [f(stick(speed=speed)) for f in measures.CLIP.values()]
        assert found == pytest.approx([smoodi, 1.0, 40 / 41, speed], abs=1e-5)
    half = stick(speed=0.3, lift=0.025 * math.log2(1.5))  # the left toe has the weight 0.5
    assert measures.skate_rsmt(half) == pytest.approx(0.3 * (1 + 0.5) / 2, rel=1e-4)
    assert measures.skate_kimodo(stick(speed=0.15)) == 0.0


def test_skate_does_not_depend_on_where_the_floor_is(walks):
    for clip in walks:
        there = clip.moved(shift=(5.0, 0.7, -2.0))
        for f in measures.CLIP.values():
            assert f(there) == pytest.approx(f(clip), rel=2e-2)


def test_pairs_computed_by_hand():
    n, angle, joints = 8, 0.5, len(NAMES)
    real = turned(stick(n, speed=1.0), 3, [angle if f % 2 else -angle for f in range(n)])
    still = turned(stick(n, speed=1.0), 3, [angle] * n)  # its power is at frequency 0, the real clip's at n / 2
    assert measures.npss(still, real) == pytest.approx(n / 2 * math.sin(angle / 2) ** 2 / joints, rel=1e-5)
    assert measures.geodesic(still, real) == pytest.approx(2 * angle / 2 / joints, rel=1e-5)
    assert all(f(real, real) == pytest.approx(0, abs=1e-6) for f in measures.PAIR.values())
    aside = stick(speed=1.0).moved(turn=0.4, shift=(0.0, 0.0, 0.0))
    assert measures.trajectory_error(aside, stick(speed=1.0)) == pytest.approx(0.4, rel=1e-4)
    assert measures.orientation_error(aside, stick(speed=1.0)) == pytest.approx(0.4, rel=1e-4)
    assert measures.geodesic(aside, stick(speed=1.0)) == pytest.approx(0.4 / joints, rel=1e-4)
    assert measures.global_quaternion(aside, stick(speed=1.0)) == pytest.approx(math.sqrt(joints * (2 - 2 * math.cos(0.2))),
                                                                               rel=1e-4)
    assert measures.global_position(stick().moved(shift=(3.0, 0.0, 4.0)), stick()) == pytest.approx(5.0)
    assert math.isnan(measures.trajectory_error(stick(), stick()))


def test_a_quaternion_and_its_negative_are_one_rotation(walks):
    clip, real = walks
    flipped = clip.replace(rotations=-clip.rotations)
    for f in measures.PAIR.values():
        assert f(flipped, real) == pytest.approx(f(clip, real), rel=1e-5)


def test_clips_that_are_no_pair_are_refused(walks):
    clip, real = walks
    with pytest.raises(ValueError, match="expected the same frames, got 100 at 60 Hz and 240 at 60 Hz"):
        measures.npss(clip.cut(0, 100), real)
    with pytest.raises(ValueError, match="the joints differ; retarget"):
        measures.geodesic(stick(), real)
    with pytest.raises(ValueError, match="foot skate needs two frames"):
        measures.skate_kimodo(clip.cut(0, 1))


class Judge:
    """A recogniser whose features and probabilities are known."""

    styles = ("A", "B", "C", "D", "E", "F")

    def embed(self, clip):
        return torch.tensor(clip.rows)

    def of_clip(self, clip):
        return torch.tensor(clip.odds)


def seen(style, rows, odds=(0.3, 0.2, 0.2, 0.1, 0.1, 0.1)):
    return SimpleNamespace(style=style, rows=[[float(v) for v in row] for row in rows], odds=odds)


def test_measures_of_sets_computed_by_hand():
    odds = (0.35, 0.25, 0.2, 0.1, 0.06, 0.04)
    clips = [seen("A", [[0, 0], [0, 2]], odds), seen("A", [[3, 5]], odds), seen("B", [[0, 1], [0, 1]], odds),
             seen("D", [[3, 1]], odds), seen("F", [[0, 1]], odds), seen("unknown", [[0, 1]], odds)]
    top = {k: MEASURES[f"recognition-top{k}"](Judge(), clips) for k in (1, 3, 5)}
    assert top == pytest.approx({1: 2 / 5, 3: 3 / 5, 5: 4 / 5})
    assert measures.multimodality(Judge(), clips) == pytest.approx(5.0)  # (0, 1) and (3, 5)
    assert measures.diversity(Judge(), clips[:4]) == pytest.approx((5 + 0 + 3 + 5 + 4 + 3) / 6)
    assert math.isnan(measures.diversity(Judge(), clips[:1]))
    assert math.isnan(measures.multimodality(Judge(), clips[2:]))
    shifted = [seen("A", [[3, 4], [3, 6]])]
    assert measures.fmd(Judge(), clips[:1], shifted) == pytest.approx(25.0)


def test_every_measure_names_its_source_unit_and_direction():
    assert {"skate-smoodi", "skate-kimodo", "skate-camdm", "skate-rsmt", "npss", "geodesic"} <= MEASURES.keys()
    for name, f in MEASURES.items():
        assert "20" in f.__doc__, name  # the year of a source
        assert "is better" in f.__doc__ or "is best" in f.__doc__, name
    assert measures.UNITS.keys() < MEASURES.keys() == measures.BEST.keys()


def test_a_report_has_a_row_of_the_real_data(walks):
    clip, real = walks
    table = tk.evaluation.report([clip, real], real=[real, real])
    made, truth = table.rows
    assert (made["data"], made["n"], truth["data"], truth["n"]) == ("clips", 2, "real", 2)
    assert made["skate-rsmt"] == pytest.approx((measures.skate_rsmt(clip) + measures.skate_rsmt(real)) / 2)
    assert truth["skate-kimodo"] == pytest.approx(measures.skate_kimodo(real))
    assert made["geodesic"] == pytest.approx(measures.geodesic(clip, real) / 2)
    assert truth["npss"] == 0.0
    for text in ("skate-smoodi", "real (2)", "they need a recogniser"):
        assert text in repr(table)


def test_a_report_says_what_is_missing(walks):
    clip, real = walks
    alone = tk.evaluation.report(clip)
    assert len(alone.rows) == 1
    assert "npss" not in alone.columns
    assert "they need real clips" in alone.notes[0]
    odd = tk.evaluation.report([clip, clip], real)
    assert "npss" not in odd.rows[0]
    assert "2 clips and 1 real ones are not pairs" in odd.notes[0]
    with pytest.raises(ValueError, match="real: no clips to measure"):
        tk.evaluation.report(clip, real=[])


def test_a_report_with_a_recogniser_tells_styles_from_others():
    styles = ("Crouch", "Neutral", "Zombie")
    real, others = (tk.datasets.load("procedural", styles=styles, gaits=("FW", "TR1"), seconds=6.0, seed=s) for s in (0, 1))
    judge = recognition.train(tk.features.build(real), steps=40)
    table = tk.evaluation.report(others, real=real, recogniser=judge)
    made, truth = table.rows
    assert made["recognition-top1"] == made["recognition-top5"] == 1.0
    wrong = tk.evaluation.report([clip for clip in others if clip.style == "Crouch"], real, judge)
    assert made["fmd"] < wrong.rows[0]["fmd"]
    assert truth["diversity"] > truth["multimodality"] > 0
    assert math.isfinite(truth["fmd"])


def test_the_verb_measures_anybodys_files(tmp_path, capsys, walks):
    for folder, clip in zip(("made", "real"), walks, strict=True):
        (tmp_path / folder).mkdir()
        tk.bvh.save(clip, tmp_path / folder / "walk.bvh")
    (tmp_path / "made" / "broken.bvh").write_text("no motion")
    tk.bvh.save(walks[0].cut(0, 3), tmp_path / "made" / "short.bvh")
    out = tmp_path / "table.json"
    with pytest.raises(SystemExit, match="0"):
        main(["evaluate", str(tmp_path / "made"), "--real", str(tmp_path / "real"), "--out", str(out)])
    shown = capsys.readouterr()
    assert "left out: broken.bvh: " in shown.out
    assert "left out: short.bvh: foot skate needs two frames at 20 Hz, the clip lasts 0.05 s" in shown.out
    assert "skate-smoodi" in shown.out
    made, truth = json.loads(out.read_text())["rows"]
    assert made["skate-rsmt"] == pytest.approx(measures.skate_rsmt(walks[0]), rel=0.02)
    assert made["geodesic"] == pytest.approx(measures.geodesic(*walks), rel=0.02)
    assert truth["geodesic"] == pytest.approx(0.0, abs=1e-6)
    assert main(["evaluate", str(tmp_path / "none")]) == 2
    assert "no such file or folder" in capsys.readouterr().err
