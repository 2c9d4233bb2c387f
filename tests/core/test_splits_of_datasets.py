"""The splits of datasets have no leaks."""

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
    assert path.read_text() == json.dumps(vars(split)) + "\n"
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


def test_the_split_of_bandai_has_no_leaks(shared):
    bandai = tk.datasets.split("bandai", root=shared / "bandai")
    assert bandai.whole_takes
    assert leaks.find(bandai) == []
    styles = {b.style for b in bandai.train}
    assert all({b.style for b in getattr(bandai, part)} == styles for part in blocks.PARTS)
