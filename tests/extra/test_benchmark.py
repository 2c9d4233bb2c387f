"""StyleWalk: the plan, judges that see style and not place or size, scores that repeat."""

import json
import math

import pytest
import torch
from refusal import refusal

import toolkit as tk
from experiments.stylewalk import train
from toolkit.extra.benchmark import PLAN, Judges, commands, score, tracks, walk
from toolkit.extra.benchmark.judges import CHANNELS, KINDS, WINDOW, windows


@pytest.fixture(scope="module")
def clips():
    made = tk.datasets.procedural.load(["Neutral", "Zombie"], "FW", 4.0)
    return {f"straight_normal_{seed}": clip for seed, clip in enumerate(made)}


def test_a_track_is_walked_at_the_pace_of_the_style_and_mirrored_by_odd_seeds():
    for track, parts in PLAN["tracks"].items():
        orders = commands(track, 1.2, seed=2)
        seconds = PLAN["warm_up"] + sum(part["seconds"] for part in parts)
        assert len(orders) == round(60 * seconds)
        assert math.hypot(*orders[0].velocity) == pytest.approx(1.2, rel=tracks.VARIED)
    corner, other = (commands("corner", 1.0, seed)[-1].facing for seed in (0, 1))
    assert corner == pytest.approx((1.0, 0.0), abs=1e-6)
    assert other == pytest.approx((-1.0, 0.0), abs=1e-6)
    assert math.hypot(*commands("stop", 1.0)[-1].velocity) == 0


def test_a_judge_sees_neither_place_nor_heading_nor_size(clips):
    clip = clips["straight_normal_0"]
    seen = windows(clip)
    assert seen.shape[1:] == (WINDOW, CHANNELS)
    moved = clip.moved(turn=1.0, shift=(3.0, 0.4, -2.0))
    torch.testing.assert_close(windows(moved), seen, atol=1e-3, rtol=0)
    old = clip.skeleton
    larger = tk.Skeleton(old.names, old.parents, old.offsets * 1.3, old.roles, old.ends)
    scaled = clip.replace(skeleton=larger, root_positions=clip.root_positions * 1.3)
    torch.testing.assert_close(windows(scaled), seen, atol=1e-3, rtol=0)
    with refusal("needs more than a second"):
        windows(clip.cut(0, 50))


def test_judges_learn_and_are_stored(clips, tmp_path, monkeypatch):
    monkeypatch.setattr("experiments.stylewalk.STEPS", 30)
    own = [*clips.values()]
    judges = train([own, own, own])
    for name in KINDS:
        assert [judges.style(name, clip) for clip in own] == ["Neutral", "Zombie"]
    judges.save(tmp_path / "judges.safetensors")
    again = Judges.load(tmp_path / "judges.safetensors")
    assert all(torch.equal(a, b) for a, b in zip(judges.state_dict().values(),
                                                 again.state_dict().values(), strict=True))
    with refusal("not in the installed package"):
        Judges.load(tmp_path / "none")


def test_scores_repeat_and_name_what_they_were_measured_with(clips, tmp_path, command):
    folder, out = tmp_path / "walks", tmp_path / "scores.json"
    folder.mkdir()
    for name, clip in clips.items():
        tk.bvh.save(clip, folder / f"{name}.bvh")
    command(f"benchmark score {folder} --out {out}")
    held = json.loads(out.read_text())
    assert {"plan sha256", "judges sha256", "machine", "torch"} <= held["about"].keys()
    read = {path.stem: tk.load(path) for path in sorted(folder.iterdir())}
    again = score(read, Judges.load(), "")
    for row, values in again.rows.items():
        assert [v if math.isfinite(v) else None for v in values] == held["rows"][row]
    other = tmp_path / "old.json"
    other.write_text(out.read_text().replace('"judges sha256": "', '"judges sha256": "0'))
    said = command(f"benchmark table {out} {other} --out x.tex", status=2).err
    assert "judges sha256 differ" in said
    for change, said in (({"rows": {}}, "rows differ"), ({"rows": {"jerk": [1.0]}}, "damaged"),
                         ({"about": {}}, "damaged")):
        other.write_text(json.dumps(held | change))
        assert said in command(f"benchmark table {out} {other} --out x.tex", status=2).err
    said = command(f"benchmark table {out} {out} --out x.tex", status=2).err
    assert "two methods have the name scores" in said
    table = out.with_suffix(".tex")
    command(f"benchmark table {out} --out {table}")
    assert f"jerk & {held['rows']['jerk'][0]:.3g} & " in table.read_text()
    with refusal("no clips to score"):
        score({}, Judges.load(), "none")


def test_a_model_walks_the_plan_in_the_styles_that_it_knows(fast, monkeypatch):
    monkeypatch.setitem(PLAN, "tracks", {"stop": PLAN["tracks"]["stop"]})
    monkeypatch.setitem(PLAN, "seeds", [0])
    model, bank = fast
    made = walk(model, bank)
    assert list(made) == ["stop_normal_0"]
    rows = score(made, Judges.load(), "procedural").rows
    assert rows["direction"][0] < 10
    assert rows["stop"][0] < 0.1
    with refusal("none of the styles"):
        walk(model, bank.select(["Zombie"]))
