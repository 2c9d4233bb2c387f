import os
import shutil
import subprocess
import sys

import pytest
import torch
from strategies import human_clip

from experiments import table1
from toolkit import datasets, published
from toolkit.datasets import style100, xia
from toolkit.io import bvh
from toolkit.motion import root_frames
from toolkit.motion import rotations as R

TABLE1 = """Backwards Run|434,329|120|10.7
Backwards Walk|768,574|213|19.0
Forwards Run|414,911|115|10.2
Forwards Walk|777,640|216|19.2
Sidestep Run|250,980|70|6.2
Sidestep Walk|541,041|150|13.3
Idling|81,685|23|2.0
Transitions|786,818|218|19.4
Total|4,055,978|1125|100.0"""  # as the paper prints it

CUTS = "STYLE_NAME," + ",".join(f"{g}_{e}" for g in style100.GAITS for e in ("START", "STOP"))
LATE = "\n".join(f"{style}," + ",".join(["500", "900"] * 10) for style in ("Old", "Zombie"))
STYLES = "Style Name,Description,Stochastic,Symmetric,Notes"


@pytest.fixture(scope="session")
def recordings(shared):
    """Some clips of each of the four kinds of file."""
    return {
        "100style": datasets.load("100style", shared / "100style"),
        "bandai-1": datasets.load("bandai", shared / "bandai", dataset=1)[::3],
        "bandai-2": datasets.load("bandai", shared / "bandai", dataset=2)[::20],
        "xia": datasets.load("xia", shared / "xia"),
    }


@pytest.fixture
def small(tmp_path):
    """A folder in the layout of 100STYLE: two styles, each in its folder, of 20 frames."""
    for style, gait in (("Old", "FW"), ("Old", "BR"), ("Zombie", "FW")):
        bvh.save(human_clip(1, frames=20, fps=60.0), tmp_path / style / f"{style}_{gait}.bvh")
    cuts = {"FW": "5,15", "BR": "4,999"}
    row = [cuts.get(g, "N/A,N/A") for g in style100.GAITS]
    (tmp_path / "Frame_Cuts.csv").write_text("\n".join([CUTS, *(",".join([s, *row]) for s in ("Old", "Zombie"))]))
    (tmp_path / "Dataset_List.csv").write_text(f"{STYLES}\nOld,Bent – slow,No,Yes,\nZombie,Stiff,Yes,No,Slow\n", "utf-8")
    return tmp_path


def test_takes_are_found_cut_and_labelled(small):
    clips = datasets.load("100style", small)
    assert [(c.style, c.gait, len(c)) for c in clips] == [("Old", "BR", 16), ("Old", "FW", 10), ("Zombie", "FW", 10)]
    whole = datasets.load("100style", small, styles="Old", gaits="FW", cut=False)[0]
    torch.testing.assert_close(whole.root_positions[5:15], clips[1].root_positions)
    for path in small.glob("*/*.bvh"):  # the same files without a folder per style
        path.rename(small / path.name)
    assert [c.name for c in datasets.load("100style", small)] == [c.name for c in clips]
    assert datasets.contents("100style", small) == {"Old": {"BR": 1, "FW": 1}, "Zombie": {"FW": 1}}


def test_style_info(small):
    infos = style100.styles(small)
    assert infos["Old"] == style100.StyleInfo("Old", "Bent – slow", symmetric=True, stochastic=False, notes="")
    assert (infos["Zombie"].symmetric, infos["Zombie"].stochastic, infos["Zombie"].notes) == (False, True, "Slow")


def test_files_with_other_names_are_no_takes(small):
    shutil.copy(small / "Old" / "Old_FW.bvh", small / "Old" / "Old_FW copy.bvh")
    (small / "notes.bvh").write_text("not a take")
    assert len(datasets.load("100style", small)) == 3


def test_a_malformed_take_is_named(small):
    path = small / "Zombie" / "Zombie_FW.bvh"
    path.write_text(path.read_text().replace("Frames: 20", "Frames: 21"))
    with pytest.raises(bvh.BVHError, match=r"Zombie_FW\.bvh, line \d+: header says 21 frames"):
        datasets.load("100style", small)


def test_the_folder_from_the_environment(small, monkeypatch):
    (small / "data").mkdir()
    for name in ("Old", "Zombie", "Frame_Cuts.csv", "Dataset_List.csv"):
        (small / "data" / "100style").mkdir(exist_ok=True)
        shutil.move(small / name, small / "data" / "100style" / name)
    monkeypatch.setenv("TOOLKIT_DATA", str(small / "data"))
    assert len(datasets.load("100style")) == 3
    monkeypatch.delenv("TOOLKIT_DATA")
    monkeypatch.setenv("XDG_DATA_HOME", str(small / "empty"))
    with pytest.raises(ValueError, match=r"100style: nothing at .*data fetch 100style.*zenodo.*give root=.*TOOLKIT_DATA"):
        datasets.load("100style")


def test_other_datasets_read_names(tmp_path):
    clip = human_clip(0)
    for name in ("dataset-1_walk-left_not-confident_1", "dataset-2_walk-turn-left_active_013", "angry_13_000", "old_99_001"):
        bvh.save(clip, tmp_path / "data" / f"{name}.bvh")
    found = datasets.load("bandai", tmp_path)
    assert [(c.style, c.gait) for c in found] == [("not-confident", "walk-left"), ("active", "walk-turn-left")]
    assert [c.style for c in datasets.load("bandai", tmp_path, dataset=2)] == ["active"]
    assert [(c.style, c.gait) for c in datasets.load("xia", tmp_path)] == [("angry", "run"), ("old", "99")]
    angry = datasets.load("xia", tmp_path, gaits=["run"])[0]
    torch.testing.assert_close(angry.global_positions, clip.global_positions * xia.UNIT / 0.01, atol=1e-4, rtol=1e-4)


def test_the_procedural_dataset_is_listed_like_the_others():
    listed = datasets.contents("procedural")
    clips = datasets.load("procedural", styles=["Neutral"], gaits=["FW", "ID"], seconds=1.0)
    assert [(c.style, c.gait) for c in clips] == [("Neutral", "FW"), ("Neutral", "ID")]
    assert {"FW", "ID"} <= set(listed["Neutral"])


@pytest.mark.parametrize(
    ("arguments", "match"),
    [
        ({"name": "100styles"}, "unknown dataset '100styles'; did you mean '100style'.*procedural, 100style, bandai, xia"),
        ({"name": "procedural", "root": "."}, "reads no folder"),
        ({"styles": "Zombi"}, "unknown style 'Zombi'; did you mean Zombie"),
        ({"styles": ["Old", "zzz"]}, "unknown style 'zzz'; it has Old, Zombie"),
        ({"styles": []}, "empty list of styles"),
        ({"gaits": ["walk"]}, "unknown gait 'walk'; it has BR, BW"),
        ({"gaits": ["FW", "TR1"]}, "no file of TR1 in"),
        ({"styles": ["Zombie"], "gaits": ["BR"]}, "no file of Zombie, BR with gait BR in"),
        ({"name": "bandai"}, "bandai: no matching BVH file in .*github.com/BandaiNamcoResearchInc"),
        ({"name": "bandai", "dataset": 3}, "dataset must be 1, 2 or None for both, got 3"),
        ({"name": "xia", "root": "/nonexistent"}, "/nonexistent does not exist; expected a folder with"),
        ({"root": __file__}, "is not a folder"),
    ],
)
def test_bad_arguments_in_one_line(small, arguments, match):
    with pytest.raises(ValueError, match=match) as caught:
        datasets.load(**({"name": "100style", "root": small} | arguments))
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("table", "text", "match"),
    [
        ("Frame_Cuts.csv", None, "no Frame_Cuts.csv in .*zenodo"),
        ("Frame_Cuts.csv", "", r"line 1: expected the columns STYLE_NAME"),
        ("Frame_Cuts.csv", "STYLE_NAME,BR_START\nOld,1\n", r"line 1: .*missing: BR_STOP"),
        ("Frame_Cuts.csv", CUTS, "no row"),
        ("Frame_Cuts.csv", CUTS + "\nOld," + ",".join(["N/A"] * 19 + ["x"]), "line 2: TR3 needs two frame numbers"),
        ("Frame_Cuts.csv", CUTS + "\nOld,1,2", "line 2: BW needs two frame numbers"),
        ("Frame_Cuts.csv", CUTS + "\nOld," + ",".join(["9", "3"] * 10), "line 2: BR starts at frame 9 and stops at 3"),
        ("Frame_Cuts.csv", CUTS + "\nOld," + ",".join(["N/A"] * 20), "BR.bvh: Frame_Cuts.csv has no START"),
        ("Frame_Cuts.csv", CUTS + "\n" + LATE, "Old_BR.bvh: cannot cut frames 500 to 20"),
        ("Dataset_List.csv", STYLES + "\nOld,Bent,Maybe,Yes,\n", "line 2: Stochastic must be Yes or No, got 'Maybe'"),
    ],
)
def test_bad_tables_in_one_line(small, table, text, match):
    (small / table).unlink() if text is None else (small / table).write_text(text)
    with pytest.raises(ValueError, match=match) as caught:
        style100.styles(small) if table == "Dataset_List.csv" else datasets.load("100style", small)
    assert "\n" not in str(caught.value)


def test_table1_equals_the_paper(shared):
    rows = table1.rows(shared / "100style")
    assert "\n".join(f"{gait}|{frames:,}|{minutes}|{ratio}" for gait, frames, minutes, ratio in rows) == TABLE1


def test_styles_of_100style(shared):
    infos = style100.styles(shared / "100style")
    assert sorted(infos) == sorted(published.STYLES)
    assert [sum(not i.symmetric for i in infos.values()), sum(i.stochastic for i in infos.values())] == [30, 5]


def test_real_recordings_have_the_size_of_people(recordings):
    for kind, clips in recordings.items():
        for clip in clips:
            height = clip.global_positions[..., 1]
            assert -0.05 < height.min() < 0.1, (kind, clip.name)
            assert 1.0 < height.amax(1).median() < 2.0, (kind, clip.name)
    assert {c.fps for c in recordings["100style"]} == {60.0}
    assert {c.fps for k in ("bandai-1", "bandai-2") for c in recordings[k]} == {30.0}
    assert {c.fps for c in recordings["xia"]} == {120.0}
    assert {(c.style, c.gait, len(c)) for c in recordings["100style"]} == {("Neutral", "FW", 873), ("Neutral", "ID", 545)}


def test_real_recordings_survive_a_round_trip(recordings, tmp_path):
    for clips in recordings.values():
        for clip in clips[:: len(clips) // 4 or 1]:
            bvh.save(clip, tmp_path / "again.bvh")
            again = bvh.load(tmp_path / "again.bvh")
            assert (again.skeleton.names, again.fps) == (clip.skeleton.names, clip.fps)
            torch.testing.assert_close(again.global_positions, clip.global_positions, atol=2e-5, rtol=0)


def test_real_recordings_are_mirrored(recordings):
    """Within 10 mm, and for Xia 35 mm: that skeleton's two legs are not equally long."""
    for kind, clips in recordings.items():
        for clip in clips:
            mirrored = clip.mirrored()
            reflected = (clip.global_positions * torch.tensor([-1.0, 1, 1]))[:, list(clip.skeleton.mirror_pairs)]
            error = (mirrored.global_positions - reflected).norm(dim=-1).max()
            assert error < (0.035 if kind == "xia" else 0.01), (clip.name, error)
            twice = mirrored.mirrored().global_positions
            torch.testing.assert_close(twice, clip.global_positions, atol=1e-4, rtol=0)


def test_real_people_walk_where_they_face(recordings):
    ways = {"FW": 1, "walk": 1, "run": 1, "dash": 1, "walk-turn-left": 1, "walk-turn-right": 1, "walk-back": -1}
    checked = dict.fromkeys(recordings, 0)
    for kind, clips in recordings.items():
        for clip in (c for c in clips if c.gait in ways):
            frames = root_frames(clip)
            forward = R.rotate(frames.rotations, torch.tensor([0.0, 0.0, 1.0]))[1:]
            velocity = frames.positions.diff(dim=0) * clip.fps
            speed = velocity.norm(dim=-1)
            walking = speed > 0.3 * speed.max()
            cosine = ((velocity * forward).sum(-1) / speed)[walking].mean()
            assert ways[clip.gait] * cosine > 0.85, (clip.name, cosine)
            checked[kind] += 1
    assert min(checked.values()) >= 1


@pytest.mark.parametrize(
    ("arguments", "problem"),
    [
        (["list", "100style", "--root", "/nonexistent"], "/nonexistent does not exist"),
        (["list", "100styl"], "did you mean '100style'"),
    ],
)
def test_command_line_errors_are_one_line(arguments, problem):
    command = [sys.executable, "-m", "toolkit", "data", *arguments]
    done = subprocess.run(command, capture_output=True, text=True, env=os.environ | {"OMP_NUM_THREADS": "1"})
    assert done.returncode == 2
    assert done.stdout == ""
    assert done.stderr.count("\n") == 1
    assert done.stderr.startswith("error: ")
    assert problem in done.stderr


def test_command_line_prints(small, shared, capsys):
    from toolkit.__main__ import app

    app(["data", "list", "100style", "--root", str(small)], standalone_mode=False)
    assert capsys.readouterr().out.split() == ["Old", "BR", "1,", "FW", "1", "Zombie", "FW", "1"]
    table1.run(shared / "100style")
    printed = [" ".join(line.split()) for line in capsys.readouterr().out.splitlines()[1:]]
    assert printed == TABLE1.replace("|", " ").splitlines()


def test_available_says_whether_load_needs_a_root(monkeypatch, tmp_path):
    monkeypatch.delenv("TOOLKIT_DATA", raising=False)
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "empty"))
    assert datasets.available("procedural")
    assert not datasets.available("100style")
    monkeypatch.setenv("TOOLKIT_DATA", str(tmp_path))
    assert not datasets.available("100style")
    (tmp_path / "100style").mkdir()
    assert datasets.available("100style")
    with pytest.raises(ValueError, match="unknown dataset 'xio'; did you mean 'xia'"):
        datasets.available("xio")


def test_an_option_that_a_dataset_does_not_have_is_refused_by_name(tmp_path):
    with pytest.raises(ValueError, match=r"xia has no option 'seconds'; its options are root, styles, gaits"):
        datasets.load("xia", tmp_path, seconds=3.0)
