"""Motion files of other programs, where they are at hand, compared with a key made by hand."""

import pytest

import toolkit as tk
from experiments import foreign


@pytest.mark.parametrize("name", foreign.KEY)
def test_a_foreign_file_is_understood_or_refused_or_doubted(shared, name):
    path = shared / "foreign" / name
    if not path.exists():
        pytest.skip(f"{name} is not at hand")
    row = foreign.judge(path, foreign.KEY[name])
    assert row.wrong == []
    assert row.verdict == foreign.KEY[name].verdict, row.said
    assert "\n" not in row.said


def test_the_table_says_when_something_is_wrong(shared, monkeypatch, capsys):
    name = "bvh-toolbox__walk01.bvh"
    right = foreign.KEY[name]
    wrong = foreign.Answer("Spine", right.parts.replace("Arm", "Paw"), unit=1.0, up="z")
    monkeypatch.setattr(foreign, "KEY", {name: wrong})
    foreign.run(shared / "foreign")
    said = capsys.readouterr().out
    for what in ("hips: Hips instead of Spine", "left_shoulder: LeftArm instead of LeftPaw",
                 "unit 0.01", "up y",
                 f"silently wrong: {name}", "| 1 | 1 | 0 | 0 | 1 |"):
        assert what in said


def test_a_walk_that_faces_backwards_is_noticed(shared):
    clip = tk.load(shared / "foreign" / "bvh-toolbox__walk01.bvh")
    assert foreign.facing(clip) > 0.95
    back = clip.replace(rotations=clip.rotations.flip(0),
                        root_positions=clip.root_positions.flip(0))
    assert foreign.facing(back) < -0.95
