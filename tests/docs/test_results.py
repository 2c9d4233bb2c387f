"""Tables of pages, drawn from stored results."""

import pytest

from experiments import tables
from experiments.tables import Result


@pytest.fixture
def folder(tmp_path):
    """A folder with one result, of two seeds."""
    columns = {"model": ["model"], "mse": ["MSE", 4], "skate": ["skate, cm/s", 1, 100],
               "walks": ["walks", 0]}
    rows = [{"model": "lpn-film", "mse": [0.0402, 0.0422], "skate": [0.1204, 0.1304], "walks": 98},
            {"model": "repeat", "mse": [0.185], "skate": None}]
    Result("small", "Two seeds.", "python -m experiments …", columns, rows, {"frames": 1536000},
           {"share": 0.914}).save(tmp_path)
    return tmp_path


def test_a_table_is_drawn_and_drawn_again_the_same(folder):
    page = "Before.\n\n<!-- table small -->\nold\n<!-- end -->\n\nAfter.\n"
    drawn = tables.fill(page, folder)
    assert drawn == ("Before.\n\n<!-- table small -->\n| model | MSE | skate, cm/s | walks |\n| "
                     "--- | --- | --- | --- |\n"
                     "| lpn-film | 0.0412 ± 0.0014 | 12.5 ± 0.7 | 98 |\n| repeat | 0.1850 |  |  |\n"
                     "<!-- end -->\n\nAfter.\n")
    assert tables.fill(drawn, folder) == drawn
    some = tables.fill(page.replace("small", "small: model mse; without lpn | none"), folder)
    assert "| model | MSE |\n| --- | --- |\n| repeat | 0.1850 |\n<!-- end" in some
