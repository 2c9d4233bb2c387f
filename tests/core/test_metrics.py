"""Measures against plain loops over their definitions, and motions whose answer is known."""

import dataclasses
import json
import math
import sys
from types import SimpleNamespace

import damages
import pytest
import torch
import unchanged
from refusal import refusal
from strategies import human, human_clip

import toolkit as tk
from toolkit import metrics
from toolkit.evaluation import MEASURES, defects, findings, table
from toolkit.motion import rotations as R

ALWAYS = [measure for name, measure in table.PAIR.items() if name != "stop"]
HUMAN = human()


def stick(frames=41, speed=0.0, fps=20.0, lift=0.0):
    """A figure that slides along +X without moving a joint; its left toe may be lifted."""
    offsets = HUMAN.offsets.clone()
    offsets[HUMAN.role("left_toe"), 1] += lift
    positions = torch.zeros(frames, 3)
    positions[:, 0], positions[:, 1] = torch.arange(frames) * speed / fps, 0.9
    skeleton = dataclasses.replace(HUMAN, offsets=offsets)
    return tk.Clip(skeleton, R.identity(frames, len(HUMAN)), positions, fps)


def turned(clip, joint, angles):
    """The clip with a joint turned about the X axis by an angle per frame."""
    vectors = torch.tensor(angles)[:, None, None] * torch.tensor([1.0, 0.0, 0.0])
    return damages.turned(clip, [joint], vectors)


@pytest.fixture(scope="module")
def walks():
    """A walk whose feet slide and that slowly rises, and the original."""
    real = tk.datasets.procedural.generate("Zombie", seconds=4.0)
    time = torch.arange(len(real))[:, None] / real.fps
    moved = time * torch.tensor([0.25, 0.004, -0.1]) * (1 + torch.sin(3 * time))
    return real.replace(root_positions=real.root_positions + moved).moved(turn=0.4), real


def test_skate_of_a_sliding_figure_computed_by_hand():
    skates = [table.CLIP[f"skate-{paper}"] for paper in ("smoodi", "kimodo", "camdm", "rsmt")]
    assert [f(stick()) for f in skates] == [0, 0, 0, 0]
    # the mean over five frames begins at 3/5 and 4/5 of the speed
    for speed, smoodi in ((0.45, 0.0), (0.6, 36 / 40), (1.0, 1.0)):
        found = [f(stick(speed=speed)) for f in skates]
        assert found == pytest.approx([smoodi, 1.0, 40 / 41, speed], abs=1e-5)
    half = stick(speed=0.3, lift=0.025 * math.log2(1.5))  # the left toe has the weight 0.5
    assert metrics.skate_rsmt(half) == pytest.approx(0.3 * (1 + 0.5) / 2, rel=1e-4)
    step = stick(speed=0.3, lift=0.05).cut(0, 2)  # of one toe, once
    assert metrics.skate_rsmt(step) == pytest.approx(0.3, rel=1e-4)
    assert metrics.skate_kimodo(stick(speed=0.15)) == 0.0


def test_pairs_computed_by_hand():
    n, angle, toe, joints = 8, 0.5, HUMAN.role("left_toe"), len(HUMAN)
    real = turned(stick(n, speed=1.0), toe, [angle if f % 2 else -angle for f in range(n)])
    still = turned(stick(n, speed=1.0), toe, [angle] * n)
    # power at frequency 0, the real clip's at n / 2
    power = n / 2 * math.sin(angle / 2) ** 2 / joints
    assert metrics.npss(still, real) == pytest.approx(power, rel=1e-5)
    turning = joints - len(HUMAN.ends)
    assert metrics.geodesic(still, real) == pytest.approx(2 * angle / 2 / turning, rel=1e-5)
    assert all(f(real, real) == pytest.approx(0, abs=1e-6) for f in ALWAYS)
    ahead = stick(speed=1.0)
    aside = ahead.moved(turn=0.4, shift=(0.0, 0.0, 0.0))
    for turn in (0.0, 0.7):
        both = (clip.moved(turn=turn) for clip in (aside, ahead))
        assert metrics.trajectory_error(*both) == pytest.approx(0.4, rel=1e-4)
    assert metrics.geodesic(aside, ahead) == pytest.approx(0.4 / turning, rel=1e-4)
    far = stick().moved(shift=(3.0, 0.0, 4.0))
    assert metrics.global_position(far, stick()) == pytest.approx(5.0)
    slow, fast = stick(speed=0.11), stick(speed=0.09)  # about the least speed with a direction
    assert metrics.trajectory_error(slow, slow) == pytest.approx(0, abs=1e-6)
    assert math.isnan(metrics.trajectory_error(slow, fast))


def test_each_measure_of_a_damaged_walk_is_what_it_was(walks):
    clip, real = walks
    clip = damages.through(damages.leg(damages.noise(clip, 0.5), 0.03), 0.9)
    found = {name: measure(clip) for name, measure in table.CLIP.items()}
    found |= {name: measure(clip, real) for name, measure in table.PAIR.items()}
    found |= {f"{kind} {part}": (values, limit)
              for kind, part, values, limit in findings.measured(damages.leg(real, 0.012))}
    beside = clip.moved(turn=0.3, shift=(0.3, 0.0, 0.1))
    phases = torch.stack([clip.root_positions[:, 0], real.root_positions[:, 2]], 1)
    found |= {"defects": defects([clip, beside], apart=0.5), "feet": metrics.feet(clip),
              "lag": metrics.phase_error(phases, phases.roll(3, 0)),
              "path": metrics.path_error(clip, real.root_positions[::30, [0, 2]])}
    for name, value in found.items():
        unchanged.check(f"measures: {name}", value, near=1e-3)


def test_measures_of_odd_clips_are_what_they_were(walks):
    """Stands, flies, runs, lies, hops, turns, shakes, other rates and bodies; against the walk."""
    walk, real = (clip.cut(0, 120) for clip in walks)
    lying = damages.turned(walk, [0], torch.tensor([[[1.4, 0.0, 0.0]]]).expand(len(walk), 1, 3))
    spun = damages.turned(walk, [0], torch.linspace(0, 6, 120)[:, None, None] * torch.eye(3)[1])
    odd = {
        "stands": stick(30), "slides": stick(60, 0.43, 60.0),
        "flies": walk.moved(shift=(0, 0.5, 0)),
        "runs": tk.datasets.procedural.generate("Neutral", "FR", seconds=1.5), "lies": lying,
        "hops": tk.datasets.procedural.generate("HopLeft", seconds=1.5),
        "spins": spun, "shakes": damages.noise(walk, 4.0), "at 30 Hz": walk.resample(30),
        "at 120 Hz": walk.cut(0, 50).resample(120), "short": walk.cut(0, 5), "one": walk.cut(7, 8),
        "bent": damages.leg(damages.leg(walk, 0.06), 0.05), "sinks": walk.moved(shift=(0, -0.1, 0)),
    }
    for name, clip in odd.items():
        pair = clip, real.resample(clip.fps).cut(0, len(clip))
        found = [said(measure, *pair[:n]) for n, group in ((1, table.CLIP), (2, table.PAIR))
                 for measure in group.values()]
        near = clip.moved(shift=(0.4, 0.0, 0.1))
        found += [said(defects, [clip, near], apart=0.5), said(metrics.feet, clip)]
        unchanged.check(f"measures of an odd clip: {name}", found, near=1e-4)
        found = said(lambda clip: list(findings.measured(clip)), clip)
        unchanged.check(f"findings in an odd clip: {name}", found, near=3e-4)


def said(call, *given, **options):
    """What a call returns, or the words of its refusal."""
    try:
        return call(*given, **options)
    except ValueError as error:
        return str(error)


def test_constants_of_measures_are_what_they_were():
    for module in (findings, metrics.pairs, metrics.quality):
        unchanged.constants(module)


def test_what_cannot_be_measured_is_refused(walks):
    clip, real = walks
    for measure, given, reason in (
        (metrics.npss, (clip.cut(0, 100), real), "got 100 at 60 Hz and 240 at 60 Hz"),
        (metrics.geodesic, (stick(), real), "the joints differ; retarget"),
        (metrics.skate_kimodo, (clip.cut(0, 1),), "foot skate needs two frames"),
        (metrics.foot_skate, (real, torch.zeros(3, 2)), r"shape \[240, 2\], got \[3, 2\]"),
        (metrics.feet, (clip.cut(0, 2),), "acceleration needs three frames, got 2"),
        (metrics.frechet_distance, (torch.zeros(5, 4), torch.zeros(5, 3)), "expected features"),
    ):
        with refusal(reason):
            measure(*given)
    with pytest.raises(KeyError, match="unknown measure 'skates'; known: skate"):
        MEASURES["skates"]


class Judge:
    """A recogniser whose features and probabilities are known."""

    styles = ("A", "B", "C")

    def embed(self, clip):
        return torch.tensor(clip.rows)

    def of_clip(self, clip):
        return torch.tensor([0.5, 0.3, 0.2])


def seen(style, rows):
    return SimpleNamespace(style=style, rows=[[float(v) for v in row] for row in rows])


def test_measures_of_sets_computed_by_hand():
    clips = [
        seen("A", [[0, 0], [0, 2]]),
        seen("A", [[3, 5]]),
        seen("B", [[0, 1], [0, 1]]),
        seen("C", [[3, 1]]),
        seen("unknown", [[0, 1]]),
    ]
    assert metrics.recognition(Judge(), clips) == pytest.approx(2 / 4)
    assert math.isnan(metrics.recognition(Judge(), clips[4:]))
    assert metrics.multimodality(Judge(), clips) == pytest.approx(5.0)  # (0, 1) and (3, 5)
    more = [*clips, *(seen("D", [[x, 0]]) for x in (0, 1))]
    assert metrics.multimodality(Judge(), more) == pytest.approx((5 + 1) / 2)
    assert metrics.diversity(Judge(), clips[:4]) == pytest.approx((5 + 0 + 3 + 5 + 4 + 3) / 6)
    assert math.isnan(metrics.diversity(Judge(), clips[:1]))
    assert math.isnan(metrics.multimodality(Judge(), clips[2:]))
    assert metrics.fmd(Judge(), clips[:1], [seen("A", [[3, 4], [3, 6]])]) == pytest.approx(25.0)


def test_frechet_distance_equals_the_closed_form_of_gaussians():
    """Of samples whose mean and covariance are exact."""
    draw = torch.Generator().manual_seed(0)

    def exact(mean, root, rows):
        x = torch.randn(rows, len(mean), dtype=torch.float64, generator=draw)
        x = torch.linalg.qr(x - x.mean(0)).Q * math.sqrt(rows - 1)
        return mean + (x - x.mean(0)) @ root

    mean = torch.tensor([1.0, -2.0, 0.5]).double()
    root = torch.tensor([1.0, 2.0, 3.0]).double().diag()
    a, b = exact(torch.zeros(3).double(), torch.eye(3).double(), 40), exact(mean, root, 70)
    closed = mean.square().sum() + (root.diag() - 1).square().sum()  # of covariances that commute
    assert metrics.frechet_distance(a, b) == pytest.approx(float(closed), rel=1e-6)
    assert metrics.frechet_distance(a, a) == pytest.approx(0.0, abs=1e-9)
    few = torch.randn(3, 50, generator=draw)  # fewer rows than columns
    assert metrics.frechet_distance(few, few + 2.0) == pytest.approx(200.0, rel=1e-5)


def test_a_report_has_a_row_of_the_real_data_and_says_what_is_missing(walks):
    clip, real = walks
    found = tk.evaluation.report([clip, real], real=[real, real])
    made, truth = found.rows
    assert (made["data"], made["n"], truth["data"], truth["n"]) == ("clips", 2, "real", 2)
    mean = (metrics.skate_rsmt(clip) + metrics.skate_rsmt(real)) / 2
    assert made["skate-rsmt"] == pytest.approx(mean)
    assert made["geodesic"] == pytest.approx(metrics.geodesic(clip, real) / 2)
    assert truth["npss"] == 0.0
    assert "they need a recogniser" in " ".join(found.notes)
    assert "they need real clips" in tk.evaluation.report(clip).notes[0]
    odd = tk.evaluation.report([clip, clip], real)
    assert "npss" not in odd.rows[0]
    assert "2 clips and 1 real ones are not pairs" in odd.notes[0]
    with refusal("real: no clips to measure"):
        tk.evaluation.report(clip, real=[])


def test_the_verb_measures_anybodys_files(tmp_path, command, walks, monkeypatch):
    made, real = (tmp_path / name for name in ("made", "real"))
    for folder, clip in zip((made, real), walks, strict=True):
        folder.mkdir()
        tk.bvh.save(clip, folder / "walk.bvh")
    (made / "broken.bvh").write_text("no motion")
    tk.bvh.save(walks[0].cut(0, 3), made / "short.bvh")
    out = tmp_path / "table.json"
    shown = command(f"evaluate {made} --real {real} --out {out}").out
    assert "left out: broken.bvh: " in shown
    assert "left out: short.bvh: foot skate needs two frames at 20 Hz" in shown
    found, truth = json.loads(out.read_text())["rows"]
    assert found["geodesic"] == pytest.approx(metrics.geodesic(*walks), rel=0.02)
    assert truth["geodesic"] == pytest.approx(0.0, abs=1e-6)
    command(f"evaluate {made} {real} --out {tmp_path}/table.csv")
    assert (tmp_path / "table.csv").read_text().startswith(",made,made,made,real")
    said = command(f"evaluate {made} {real} {made}", status=2).err
    assert said.startswith("error: two methods have the name made")
    said = command(f"evaluate {made} {real} --real {made}", status=2).err
    assert said.splitlines()[-1].startswith("error: no method can have the name real")
    monkeypatch.setitem(sys.modules, "pandas", None)  # as if it were not installed
    said = command(f"evaluate {tmp_path}/none --out {tmp_path}/new.tex", status=2).err
    assert said == "error: tables as CSV or LaTeX need pandas: pip install pandas\n"


def test_feet_of_a_figure_computed_by_hand():
    """The hips rise by 10 cm in a hop of nine frames, and the toes with them."""
    hop = torch.zeros(41)
    hop[15:24] = 0.1 * torch.sin(torch.linspace(0, math.pi, 11)[1:-1])
    still = stick()
    root = still.root_positions + hop[:, None] * torch.tensor([0.0, 1.0, 0.0])
    on = (hop == 0).float()[:, None].expand(-1, 2)
    found = metrics.feet(still.replace(root_positions=root), on)
    assert found["clearance"] == pytest.approx(0.1, abs=1e-5)
    assert found["skate"] == 0.0
    assert math.isnan(metrics.shake(human_clip(1, frames=10, fps=60.0)))
    assert all(map(math.isnan, metrics.foot_skate(still, torch.zeros(41, 2)).values()))
    assert found["steps"] == pytest.approx(2 * 20 / 41)
    rise = hop.diff() * 20.0
    assert found["acceleration"] == pytest.approx(float(rise.diff().abs().max() * 20), rel=0.1)


def test_speed_height_and_uprightness(walk_clip):
    assert metrics.speed(stick(speed=1.5).moved(turn=1.0)) == pytest.approx(1.5, abs=1e-3)
    low, high = metrics.hips_height(walk_clip)
    assert 0.85 < low < high < 1.05
    assert metrics.upright(walk_clip)
    fallen = [0.0] * (len(walk_clip) - 1) + [math.pi / 2]  # in one frame
    assert not metrics.upright(turned(walk_clip, 0, fallen))
    height = stick().global_positions[0, :, 1].clone()
    chest, spine = HUMAN.trunk[:2]
    height[chest], height[spine] = 0.8, 1.5  # it is the chest that is above the hips
    assert not metrics.on_feet(HUMAN, height)


def test_distance_from_a_path(walk_clip):
    hips = walk_clip.root_positions[:, [0, 2]]
    assert metrics.path_error(walk_clip, hips) < 1e-4
    far = torch.tensor([[0.0, 1000.0], [1.0, 1000.0]])
    away = float((hips - far[0]).norm(dim=-1).mean())
    assert metrics.path_error(walk_clip, far) == pytest.approx(away, rel=0.01)
