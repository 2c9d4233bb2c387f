"""The splits of datasets have no leaks, and leaks that are planted in them are found."""

import copy
import json

import pytest
from course import leaks

import toolkit as tk
from toolkit import features
from toolkit.__main__ import main
from toolkit.datasets import blocks, style100
from toolkit.motion import trajectory

GAITS = {"BR": (100, 4300), "FW": (250, 7600), "SR": (80, 1180), "ID": (30, 500)}


@pytest.fixture(scope="module")
def tables(tmp_path_factory):
    """A folder with the two tables of 100STYLE for eight styles, and no motion file."""
    folder = tmp_path_factory.mktemp("tables")
    styles = ["Angry", "Bent", "Zombie", *style100.HELD_OUT]
    cuts = [",".join(style100.TABLES["Frame_Cuts.csv"])]
    for i, style in enumerate(styles):
        row = [style]
        for gait in sorted(style100.GAITS):
            row += [str(end + 31 * i) for end in GAITS[gait]] if gait in GAITS else ["N/A"] * 2
        cuts.append(",".join(row))
    (folder / "Frame_Cuts.csv").write_text("\n".join(cuts) + "\n")
    rows = [",".join(style100.TABLES["Dataset_List.csv"])]
    rows += [f"{style},some,No,Yes," for style in styles]
    (folder / "Dataset_List.csv").write_text("\n".join(rows) + "\n")
    return folder


def check(split, cuts):
    """The rules of a split of 100STYLE, frame by frame."""
    assert leaks.find(split) == []
    assert {block.style for block in split.train} == {block.style for block in split.validation}
    owner = {}
    for part in blocks.PARTS:
        for style, gait, start, stop in getattr(split, part):
            first, last = cuts[style, gait]
            assert first <= start < stop <= last
            assert part == "test" or style not in style100.HELD_OUT
            for frame in range(start, stop):
                assert owner.setdefault((style, gait, frame), part) == part
    # 60 frames before a frame to 61 after it
    reach = [*range(trajectory.SAMPLES[0], trajectory.SAMPLES[-1] + 12, 10), 61]
    for part in blocks.PARTS:
        for style, gait, start, stop in getattr(split, part):
            for edge in (start, stop - 1):
                assert {owner.get((style, gait, edge + o), part) for o in reach} == {part}
    assert split.gap >= features.CLIP_FRAMES
    return owner


def test_100style_is_split_from_its_tables_alone(tables):
    split = tk.datasets.split("100style", root=tables)
    cuts = style100.frame_cuts(tables)
    owner = check(split, cuts)
    assert split == tk.datasets.split("100style", root=tables)
    assert {b.style for b in split.test} >= set(style100.HELD_OUT)
    seen = [b for b in split.test if b.style not in style100.HELD_OUT]
    assert {b.gait for b in seen} >= {"BR", "FW"}
    every = [b for part in blocks.PARTS for b in getattr(split, part)]
    assert all(b.stop - b.start >= blocks.LEAST for b in every)
    idle = [part for (style, gait, _), part in owner.items() if (style, gait) == ("Angry", "ID")]
    assert idle == ["train"] * 470
    assert len({b.start < 2000 for b in split.test if b.gait == "FW"}) == 2  # both ends are tested


def test_the_real_tables_have_a_split_without_leaks(shared):
    split = tk.datasets.split("100style", root=shared / "100style")
    cuts = style100.frame_cuts(shared / "100style")
    assert leaks.find(split) == []
    total = sum(stop - start for start, stop in cuts.values())
    sizes = {part: sum(b.stop - b.start for b in getattr(split, part)) / total
             for part in blocks.PARTS}
    assert sizes["train"] > 0.6
    assert 0.05 < sizes["validation"] < 0.12
    assert len({b.style for b in split.train}) == 95
    assert {b.style for b in split.test} == {style for style, _ in cuts}
    bandai = tk.datasets.split("bandai", root=shared / "bandai")
    assert bandai.whole_takes
    assert leaks.find(bandai) == []
    styles = {b.style for b in bandai.train}
    assert all({b.style for b in getattr(bandai, part)} == styles for part in blocks.PARTS)


def planted(split, kind):
    """The split as JSON values, with one leak."""
    made = copy.deepcopy(split.to_json())
    style, gait, start, stop = next(b for b in split.train if b.gait == "FW")
    held = next(b for b in split.test if b.style == style and b.gait == gait)
    if kind == "overlap":
        made["validation"].append([style, gait, stop - 1, stop + 5])
    elif kind == "gap":
        made["train"].append([style, gait, held.stop + 239, held.stop + 300])
    elif kind == "twin":
        made["test"].append([style, gait, start, stop, True])
    elif kind == "twin by name":
        made["train"].append([f"{style}_M", gait, held.start, held.stop])
    elif kind == "twin beside":
        made["train"].append([style, f"{gait}_mirror", held.stop + 100, held.stop + 400])
    elif kind == "same take":
        made["whole_takes"] = True
    elif kind == "unseen style":
        made["train"].append([style100.HELD_OUT[2], "XX", 0, 400])
    return made


@pytest.mark.parametrize("kind", ["overlap", "gap", "twin", "twin by name", "twin beside",
                                  "same take", "unseen style"])
def test_planted_leaks_of_every_kind_are_found(tables, kind):
    found = leaks.find(planted(tk.datasets.split("100style", root=tables), kind))
    word = kind.split(" by ")[0].split(" beside")[0]
    assert found
    assert {line.split(":")[0] for line in found} == {word}


def test_a_gap_of_the_window_is_enough_and_one_frame_less_is_not():
    for between, n in ((239, 1), (240, 0)):
        split = {"train": [["A", "FW", 0, 1000]], "test": [["A", "FW", 1000 + between, 2000]]}
        assert len(leaks.find(split)) == n
        assert leaks.find(split | {"gap": 121}) == []
    others = [["A", "BW", 0, 9], ["B", "FW", 0, 9]]
    assert leaks.find({"train": [["A", "FW", 0, 9]], "test": others}) == []
    assert len(leaks.find({"train": ["030001", "M030002"], "test": ["M030001", "030003"]})) == 1
    many = leaks.find({"train": [["A", "FW", 0, 9]] * 40, "test": [["A", "FW", 0, 9]] * 40})
    assert (len(many), many[-1]) == (1001, "and more: only 1000 leaks are listed")


def test_the_verb_writes_a_split(tables, tmp_path):
    path = tmp_path / "split.json"
    assert main(["data", "split", "100style", "--root", str(tables), "--out", str(path)]) == 0
    assert json.loads(path.read_text()) == tk.datasets.split("100style", root=tables).to_json()
