import shutil
import warnings

import pytest
import torch
from refusal import refusal
from strategies import human_clip

from experiments import table1
from toolkit import datasets
from toolkit.datasets import style100
from toolkit.io import bvh

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
    """Some clips of each kind of file."""
    root = shared / "bandai"
    return {
        "100style": datasets.load("100style", shared / "100style"),
        "bandai-1": datasets.load("bandai", root, dataset=1, gaits=["walk", "bow"])[::8],
        "bandai-2": datasets.load("bandai", root, dataset=2, styles="active")[::12],
    }


@pytest.fixture
def small(tmp_path):
    """A folder in the layout of 100STYLE: two styles, each in its folder, of 20 frames."""
    for style, gait in (("Old", "FW"), ("Old", "BR"), ("Zombie", "FW")):
        clip = human_clip(1, frames=20, fps=60.0)
        bvh.save(clip, tmp_path / style / f"{style}_{gait}.bvh")
    cuts = {"FW": "5,15", "BR": "4,999"}
    row = [cuts.get(g, "N/A,N/A") for g in style100.GAITS]
    rows = [",".join([style, *row]) for style in ("Old", "Zombie")]
    (tmp_path / "Frame_Cuts.csv").write_text("\n".join([CUTS, *rows]))
    about = f"{STYLES}\nOld,Bent – slow,No,Yes,\nZombie,Stiff,Yes,No,Slow\n"
    (tmp_path / "Dataset_List.csv").write_text(about, "utf-8")
    return tmp_path


def test_takes_are_found_cut_and_labelled(small):
    clips = datasets.load("100style", small)
    found = [(c.style, c.gait, len(c)) for c in clips]
    assert found == [("Old", "BR", 16), ("Old", "FW", 10), ("Zombie", "FW", 10)]
    (whole,) = style100.SOURCE.load(small, styles="Old", gaits="FW")
    torch.testing.assert_close(whole.root_positions[5:15], clips[1].root_positions)
    # the same files without a folder per style, beside files with other names
    for path in small.glob("*/*.bvh"):
        path.rename(small / path.name)
    shutil.copy(small / "Old_FW.bvh", small / "Old_FW copy.bvh")
    (small / "notes.bvh").write_text("not a take")
    assert [c.name for c in datasets.load("100style", small)] == [c.name for c in clips]
    listed = {"Old": {"BR": 1, "FW": 1}, "Zombie": {"FW": 1}}
    assert datasets.contents("100style", small) == listed


def test_style_info(small):
    infos = style100.styles(small)
    old = style100.StyleInfo("Old", "Bent – slow", symmetric=True, stochastic=False, notes="")
    assert infos["Old"] == old
    zombie = infos["Zombie"]
    assert (zombie.symmetric, zombie.stochastic, zombie.notes) == (False, True, "Slow")
    may = datasets.may_mirror("100style", small)
    clip = human_clip(1, frames=20, fps=60.0)
    pairs = (("Old", "FW"), ("Old", "ID"), ("Zombie", "FW"))
    assert [may(clip.replace(style=s, gait=g)) for s, g in pairs] == [True, False, False]
    may = datasets.may_mirror("procedural")
    assert [may(clip.replace(style=s, gait="FW")) for s in ("Old", "HopLeft")] == [True, False]


def test_the_folder_from_the_environment(small, monkeypatch, tmp_path_factory):
    home = tmp_path_factory.mktemp("home")
    monkeypatch.setenv("TOOLKIT_DATA", str(home))
    assert datasets.available("procedural")
    assert not datasets.available("100style")
    with refusal(r"100style: nothing at .*data fetch 100style.*zenodo.*"
                 r"give root=.*TOOLKIT_DATA"):
        datasets.load("100style")
    shutil.move(small, home / "100style")
    assert datasets.available("100style")
    assert len(datasets.load("100style")) == 3


def test_bandai_reads_names(tmp_path):
    for name in ("1_walk-left_not-confident_1", "2_walk-turn-left_active_013"):
        bvh.save(human_clip(0), tmp_path / "data" / f"dataset-{name}.bvh")
    found = [(c.style, c.gait) for c in datasets.load("bandai", tmp_path)]
    assert found == [("not-confident", "walk-left"), ("active", "walk-turn-left")]
    assert [c.style for c in datasets.load("bandai", tmp_path, dataset=2)] == ["active"]


@pytest.mark.parametrize(
    ("arguments", "match"),
    [
        ({"styles": "Zombi"}, "unknown style 'Zombi'; did you mean Zombie"),
        ({"styles": ["Zombie"], "gaits": ["BR"]}, "no file of Zombie, BR in"),
        ({"name": "bandai", "dataset": 3}, "dataset must be 1, 2 or None for both, got 3"),
        ({"seconds": 3.0}, "100style: unknown option 'seconds'; it has gaits, root, styles"),
        ({"root": __file__}, "is not a folder"),
    ],
)
def test_bad_arguments_in_one_line(small, arguments, match):
    with refusal(match):
        datasets.load(**({"name": "100style", "root": small} | arguments))


@pytest.mark.parametrize(
    ("table", "text", "match"),
    [
        ("Frame_Cuts.csv", "STYLE_NAME,BR_START\nOld,1\n", r"line 1: .*missing: BR_STOP"),
        ("Frame_Cuts.csv", CUTS, "no row"),
        ("Frame_Cuts.csv", f"{CUTS}\nOld," + ",".join(["9", "3"] * 10),
         "line 2: BR starts at frame 9 and stops at 3"),
        ("Frame_Cuts.csv", f"{CUTS}\n{LATE}", "Old_BR.bvh: cannot cut frames 500 to 20"),
        ("Dataset_List.csv", f"{STYLES}\nOld,Bent,Maybe,Yes,\n",
         "line 2: Stochastic must be Yes or No, got 'Maybe'"),
    ],
)
def test_bad_tables_in_one_line(small, table, text, match):
    (small / table).write_text(text)
    with refusal(match):
        style100.styles(small) if table == "Dataset_List.csv" else datasets.load("100style", small)


def test_table1_equals_the_paper(shared, capsys):
    table1.run(shared / "100style")
    printed = [" ".join(line.split()) for line in capsys.readouterr().out.splitlines()[1:]]
    assert printed == TABLE1.replace("|", " ").splitlines()


def test_real_recordings_have_the_size_of_people(recordings):
    for kind, clips in recordings.items():
        for clip in clips:
            height = clip.global_positions[..., 1]
            assert -0.05 < height.min() < 0.1, (kind, clip.name)
            assert 1.0 < height.amax(1).median() < 2.0, (kind, clip.name)
    assert {c.fps for c in recordings["100style"]} == {60.0}
    assert {c.fps for k in ("bandai-1", "bandai-2") for c in recordings[k]} == {30.0}
    found = {(c.style, c.gait, len(c)) for c in recordings["100style"]}
    assert found == {("Neutral", "FW", 873), ("Neutral", "ID", 545)}


def test_the_verb_lists_and_says_what_is_wrong_in_one_line(small, command, monkeypatch):
    monkeypatch.setenv("RANK", "1")  # a variable of other programs silences nothing
    shown = warnings.showwarning
    printed = command("data list 100style --root", small).out.split()
    assert printed == ["Old", "BR", "1,", "FW", "1", "Zombie", "FW", "1"]
    said = command("data list 100styl", status=2)
    assert said.out == ""
    assert said.err.startswith("error: toolkit: unknown dataset '100styl'; did you mean 100style")
    assert said.err.count("\n") == 1
    assert warnings.showwarning is shown
