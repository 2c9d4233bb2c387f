"""Stored results: every table of the pages equals its file, and the prose states no number that no file holds."""

import math
import re
import subprocess
import sys
from pathlib import Path
from statistics import mean

import numpy as np
import pytest

from experiments import tables
from experiments.tables import DOCS, RESULTS, Result

PAGES = sorted(DOCS.glob("*.md"))
# pages whose prose states results
STATED = ("comparison", "embedded_model", "phase_sources", "procedural", "recipes", "reproducing", "stylisation",
          "stylisation_findings")


@pytest.fixture
def folder(tmp_path):
    """A folder with one result, of two seeds."""
    columns = {"model": ["model"], "mse": ["MSE", 4], "skate": ["skate, cm/s", 1, 100], "walks": ["walks", 0]}
    rows = [{"model": "lpn-film", "mse": [0.0402, 0.0422], "skate": [0.1204, 0.1304], "walks": 98},
            {"model": "repeat", "mse": [0.185], "skate": None}]
    Result("small", "Two seeds.", "python -m experiments …", columns, rows, {"frames": 1536000},
           {"share": 0.914}).save(tmp_path)
    return tmp_path


@pytest.mark.parametrize("page", PAGES, ids=lambda path: path.stem)
def test_the_tables_of_a_page_are_those_of_its_results(page):
    text = page.read_text(encoding="utf-8")
    assert tables.fill(text) == text, "run: python -m experiments tables"
    assert text.count("<!-- table ") == len(tables.TABLE.findall(text)), "a table without its end"


def test_the_prose_of_pages_states_only_stored_numbers():
    pages = [(DOCS / f"{page}.md").read_text(encoding="utf-8") for page in STATED]
    assert [found for text in pages for found in tables.unsupported(text)] == []


def test_the_prose_about_feet_and_speed_states_only_stored_numbers():
    section = (DOCS / "runtime.md").read_text(encoding="utf-8").partition("\n## Feet\n")[2]
    assert tables.unsupported(section) == []


@pytest.mark.parametrize("speed", ["natural speed", "1 m/s"])
def test_feet_in_closed_loop_keep_the_aims_but_for_what_the_network_predicts(speed):
    """Before foot IK the aim is out of reach: a prediction from real input already misses it."""
    rows = {row["walk"]: row for row in Result.load("closed-loop").rows}
    aim, now = rows[f"aim, {speed}"], rows[f"published, {speed}"]
    assert now["upright"] == now["styles"] == 99
    assert now["skate"] <= aim["skate"]
    assert now["worst"] <= aim["worst"]
    assert now["least"] >= aim["least"]
    ahead = next(row for name, row in rows.items() if name.startswith("published, one step ahead"))
    assert now["before"] > ahead["before"] > aim["before"]
    assert ahead["before"] > 4 * ahead["skate"]


@pytest.mark.parametrize("speed", ["natural speed", "0.7 m/s", "1 m/s"])
def test_feet_of_the_embedded_model_stand(speed):
    now = next(row for row in Result.load("closed-loop").rows if row["walk"] == f"embedded, {speed}")
    assert now["upright"] == now["styles"] == 25
    assert now["worst"] <= 0.005
    assert now["least"] >= 0.95


def test_steps_at_the_speed_of_the_real_take_are_as_frequent_as_its_own():
    """Within 10 % of the take's, and of 1.48 a second, which was asked."""
    rows = {row["walk"]: row for row in Result.load("closed-loop").rows}
    now = rows["published, 0.7 m/s"]
    assert now["steps"] == pytest.approx(rows["real: Neutral_FW.bvh"]["steps"], rel=0.1)
    assert now["steps"] == pytest.approx(1.48, rel=0.1)
    assert now["upright"] == now["styles"] == 99
    assert now["least"] >= 0.9


def test_one_step_ahead_keeps_the_aims_and_beats_its_floors_where_the_page_says_so():
    rows = {row["take"]: row for row in Result.load("one-step").rows}
    aim, plain, now = (rows[f"{kind}: Neutral_FW.bvh"] for kind in ("aim, calibrated", "published", "published, calibrated"))
    assert now["error"] <= aim["error"]
    assert min(now["right"], now["left"]) >= aim["right"]
    assert now["phase"] <= aim["phase"]
    assert now["error"] < now["repeat"] < plain["error"] < plain["mean"] / 10
    assert 1 < now["rank"] <= 10
    assert now["next"] > 0.9 * now["error"]  # the first of the other styles is hardly better
    ranks = {row["style"]: row["rank"] for row in rows.values() if row["take"].endswith("retargeted")}
    assert ranks["Strutting"] == ranks["Angry"] == 1
    assert ranks["Old"] > 60


def test_the_pose_that_is_fed_back_loses_the_clearance():
    """Not the phases, not what calibration or another vector changes; and the embedded model does not lose it."""
    rows = {row["fed"]: row for row in Result.load("swing").rows}
    real, ahead, phases, pose = (rows[name] for name in ("the real take", "nothing: one step ahead", "phases", "pose"))
    for form in ("own", "calibrated", "learnt"):
        assert real[form] > ahead[form] > 0.85 * real[form]
        assert phases[form] == pytest.approx(ahead[form], rel=0.02)
        assert pose[form] < 0.65 * ahead[form]
    assert pose["embedded"] > 0.9 * ahead["embedded"]


def test_the_runtime_is_as_fast_as_its_page_says():
    """Near the floor for one and for many; bfloat16 helps one alone; calibration costs many characters most."""
    rows = {row["work"]: row for row in Result.load("runtime-speed").rows}
    own, half, einsum = rows["toolkit"], rows["toolkit, bfloat16 weights"], rows["plain einsum weight blend (torch)"]
    assert max(own["1 floors"], own["64 floors"]) < 1.4
    assert own["64"] < einsum["64"] / 10
    assert half["1"] < 0.8 * own["1"]
    assert half["64"] > 0.9 * own["64"]
    assert rows["whole frame, toolkit, calibrated"]["1"] > 1.5 * rows["whole frame, toolkit"]["1"]
    assert rows["whole frame, toolkit, calibrated"]["64"] > 5 * rows["whole frame, toolkit"]["64"]


def table(name):
    """Rows of a result on stylisation by method and way; of all seeds."""
    return {(row["method"], row.get("codes")): row for row in Result.load(f"stylisation-{name}").rows}


def test_the_stylisation_page_compares_as_its_results_do():
    """Sentences without numbers of their own, or with ratios."""
    long = table("dataset-1-180-seconds")
    ours, dense = long["ours", "reference"], long["1-D convolutions", "reference"]
    shift = long["mean-pose shift", None]
    assert max(ours["fmd"]) < min(*dense["fmd"], shift["fmd"])  # the best with each of three seeds
    assert min(ours["both"]) > max(*dense["both"], shift["both"])
    rows = table("dataset-1")
    ours, dense, aberman = (mean(rows[name, "dissimilar"]["fmd"]) for name in
                            ("ours", "1-D convolutions", "Aberman et al. 2020"))
    assert aberman - dense > 3 * (dense - ours)  # most of the gap to Aberman et al. is there without the graph
    for name in ("dataset-1", "dataset-2"):
        rows = table(name)
        clip = rows["nearest real clip", None]
        assert clip["style"] == 1
        assert clip["fmd"] < min(np.min(row["fmd"]) for (method, _), row in rows.items()
                                 if method not in ("real motion", "nearest real clip"))
        assert min(rows[floor, None]["content"] for floor in ("unchanged source", "mean-pose shift")) > 0.88
    steps = {row["clip"]: row["steps"] for row in Result.load("stylisation-strips").rows}
    first, last = (list(steps).index(clip) for clip in ("masculinity walk: source", "old walk: the actor's own"))
    assert len(set([*steps.values()][first:last])) == 1  # the rhythm is the source's
    leads = [row for row in Result.load("stylisation-leads").rows if row["data"] == "dataset-1" and row["seconds"] == 180]
    for seed, share in ((0, "0.76"), (1, "0.70")):
        best = min(row["fmd"] for row in leads if row["seed"] == seed and row["lead"].startswith("1-D"))
        own = next(row["fmd"] for row in leads
                   if (row["seed"], row["lead"], row["kind"]) == (seed, "the recipe", "as trained"))
        assert f"{own / best:.2f}" == share


def test_hands_of_restyled_motions_move_as_the_stylisation_page_says():
    rows = Result.load("stylisation-strips").rows
    walks = [row["clip"] for row in rows].index("masculinity walk: source")
    for own, part in (("bow", rows[:walks]), ("walk", rows[walks:])):
        source, old, feminine = (next(r for r in part if r["clip"].startswith(name))
                                 for name in (f"masculinity {own}: source", f"old {own}: the", f"feminine {own}: the"))
        made = {name: [r for r in part if r["clip"].startswith((f"{name}, noise", f"{name}, reference"))]
                for name in ("old", "feminine")}
        assert [len(found) for found in made.values()] == [6, 6]
        if own == "walk":
            least = max(old["hands"], feminine["hands"])
            assert all(least < r["hands"] < source["hands"] for r in made["old"] + made["feminine"])
        else:
            assert old["hands"] < 1.3 * source["hands"] < min(r["hands"] for r in made["old"])
            assert all(3.5 < r["hands"] / source["hands"] < 4.5 for r in made["feminine"])
            assert min(r["speed"] for r in made["old"]) > old["speed"]
            assert min(r["speed"] for r in made["feminine"]) > feminine["speed"]


def test_a_page_walks_as_python_in_double_precision_does():
    rows = {row["compared"]: row for row in Result.load("page-equality").rows}
    for kind in ("embedded", "published"):
        assert max(rows[f"{kind}: page and double precision"][frame] for frame in ("60", "300", "600")) < 1e-6
        assert rows[f"{kind}: page and plain"]["60"] < 1e-3


def test_every_result_is_shown_or_named_on_a_page():
    text = "".join(page.read_text(encoding="utf-8") for page in PAGES)
    named = {name for _, name, _, _ in tables.TABLE.findall(text)}
    named |= {name for listed in re.findall(r"<!-- results ([\w -]+) -->", text) for name in listed.split()}
    assert named == {path.stem for path in RESULTS.glob("*.json")}


@pytest.mark.parametrize("path", sorted(RESULTS.glob("*.json")), ids=lambda path: path.stem)
def test_a_stored_result_says_what_it_is_and_reads_back(path, tmp_path):
    result = Result.load(path.stem)
    assert result.about
    assert "python -m " in result.command
    assert result.save(tmp_path).read_bytes() == path.read_bytes()
    assert path.stat().st_size < 200_000


def test_a_table_is_drawn_and_drawn_again_the_same(folder):
    page = "Before.\n\n<!-- table small -->\nold\n<!-- end -->\n\nAfter.\n"
    drawn = tables.fill(page, folder)
    assert drawn == ("Before.\n\n<!-- table small -->\n| model | MSE | skate, cm/s | walks |\n| --- | --- | --- | --- |\n"
                     "| lpn-film | 0.0412 ± 0.0014 | 12.5 ± 0.7 | 98 |\n| repeat | 0.1850 |  |  |\n"
                     "<!-- end -->\n\nAfter.\n")
    assert tables.fill(drawn, folder) == drawn
    assert "| model | walks |" in tables.fill(page.replace("small", "small: model walks"), folder)


@pytest.mark.parametrize("said", [
    "an error of 0.0412", "12.5 cm/s", "12.04 cm/s", "1,536,000 frames", "91 %", "91.4 % of them", "98 styles",
    "a spread of 0.0014", "as in section 5.1 and Table 2", "Mason et al. 2022", "`--steps 4000`", "[notebook](06_x.ipynb)",
    "<!-- cited -->7.7<!-- end -->",
])
def test_numbers_of_the_result_and_of_no_result(folder, said):
    assert tables.unsupported(f"<!-- table small -->\n<!-- end -->\n{said}.", folder) == []


@pytest.mark.parametrize("number", ["0.0413", "12.6", "92 %", "97", "0.05", "5", "−0.0412", "1,536,001"])
def test_numbers_that_no_result_holds_are_found(folder, number):
    (found,) = tables.unsupported(f"<!-- table small -->\n<!-- end -->\nText with {number} in it.", folder)
    assert found.startswith(f"{number} in: …")


def test_a_page_may_name_a_result_without_a_table(folder):
    assert tables.unsupported("<!-- results small -->\n98 styles", folder) == []
    assert len(tables.unsupported("98 styles", folder)) == 1


def test_wrong_results_are_errors_in_one_line(folder):
    (folder / "broken.json").write_text("{")
    (folder / "other.json").write_text('{"a": 1}')
    for call, said in (
        (lambda: tables.fill("<!-- table none -->\n<!-- end -->", folder), r"none.json: no such result; known: broken"),
        (lambda: tables.fill("<!-- table small: model gpu -->\n<!-- end -->", folder), "small has no column gpu; columns: "),
        (lambda: Result.load("broken", folder), r"broken.json: is not a result"),
        (lambda: Result.load("other", folder), r"other.json: is not a result"),
        (lambda: Result("x", "", "", {"a": ["a"]}, [{"b": 1}]), "x: a row has b, which no column shows"),
    ):
        with pytest.raises(ValueError, match=said) as error:
            call()
        assert "\n" not in str(error.value)


def test_what_is_not_finite_is_stored_as_nothing(tmp_path):
    Result("gaps", "a", "b", {"v": ["v", 2]}, [{"v": math.nan}, {"v": [1.0, math.inf]}]).save(tmp_path)
    assert [row["v"] for row in Result.load("gaps", tmp_path).rows] == [None, [1.0, None]]
    assert Result.load("gaps", tmp_path).markdown().splitlines()[2:] == ["|  |", "| 1.00 |"]


def test_rows_without_a_value_in_the_columns_that_are_shown_are_left_out(folder):
    assert "repeat" in Result.load("small", folder).markdown(["model", "mse"])
    assert "repeat" not in Result.load("small", folder).markdown(["model", "skate", "walks"])


def test_the_command_writes_pages(tmp_path, monkeypatch, folder, capsys):
    page = tmp_path / "page.md"
    page.write_text("<!-- table small: walks -->\n<!-- end -->\n")
    monkeypatch.setattr(tables, "DOCS", tmp_path)
    monkeypatch.setattr(tables, "RESULTS", folder)
    tables.run()
    assert "| 98 |" in page.read_text()
    assert "page.md" in capsys.readouterr().out
    tables.run()
    assert capsys.readouterr().out == ""


def test_the_command_line_knows_it():
    done = subprocess.run([sys.executable, "-m", "experiments", "tables", "--help"], capture_output=True, text=True,
                          cwd=Path(__file__).parents[1])
    assert "stored results" in done.stdout
