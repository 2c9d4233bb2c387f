"""The splits of datasets have no leaks, and leaks that are planted in them are found."""

import json

import pytest
from course import leaks

import toolkit as tk
from toolkit import features
from toolkit.datasets import blocks, style100

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


def test_100style_is_split_from_its_tables_alone(tables, tmp_path, command):
    split, path = tk.datasets.split("100style", root=tables), tmp_path / "split.json"
    assert leaks.find(split) == []
    assert split.gap >= features.CLIP_FRAMES > 60 + 61  # frames that a window reaches
    command(f"data split 100style --root {tables} --out {path}")
    assert json.loads(path.read_text()) == split.to_json()
    styles = [{block.style for block in getattr(split, part)} for part in blocks.PARTS]
    assert styles[0] == styles[1] == styles[2] - set(style100.HELD_OUT)
    assert styles[2] >= set(style100.HELD_OUT)
    seen = [b for b in split.test if b.style not in style100.HELD_OUT]
    assert {b.gait for b in seen} >= {"BR", "FW"}
    cuts = style100.frame_cuts(tables)
    for block in (*split.train, *split.validation, *split.test):
        first, last = cuts[block.style, block.gait]
        assert first <= block.start < block.start + blocks.LEAST <= block.stop <= last
    assert ("Angry", "ID", *cuts["Angry", "ID"]) in split.train  # 470 frames are too few to cut
    assert len({b.start < 2000 for b in seen if b.gait == "BR"}) == 2  # both ends are tested


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


def test_planted_leaks_of_every_kind_are_found(tables):
    split = tk.datasets.split("100style", root=tables)
    style, gait, start, stop = next(b for b in split.train if b.gait == "FW")
    held = next(b for b in split.test if b.style == style and b.gait == gait)
    for kind, part, *block in (
        ("overlap", "validation", style, gait, stop - 1, stop + 5),
        ("gap", "train", style, gait, held.stop + 239, held.stop + 300),
        ("twin", "test", style, gait, start, stop, True),
        ("twin", "train", f"{style}_M", gait, held.start, held.stop),
        ("twin", "train", style, f"{gait}_mirror", held.stop + 100, held.stop + 400),
        ("unseen style", "train", style100.HELD_OUT[2], "XX", 0, 400),
        ("same take", "whole_takes"),
    ):
        made = split.to_json()
        made[part] = [*made[part], block] if block else True
        assert {line.split(":")[0] for line in leaks.find(made)} == {kind}


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
