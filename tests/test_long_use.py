"""What widgets leave behind in a kernel. `python -m experiments long-use` drives a whole one."""

import gc
import weakref
from types import SimpleNamespace

import pytest
from IPython.core.interactiveshell import InteractiveShell
from ipywidgets.widgets.widget import _instances
from robustness.long_use import leaks
from traitlets.config import Config

import toolkit as tk
from toolkit.view.controller import Controller
from toolkit.view.director import Director
from toolkit.view.player import Player


@pytest.fixture
def cell(monkeypatch):
    """The message that runs a cell of JupyterLab."""
    parent = {"metadata": {"cellId": "first"}, "header": {"msg_id": "1"}}
    shell = SimpleNamespace(kernel=SimpleNamespace(get_parent=lambda: parent))
    monkeypatch.setattr("IPython.get_ipython", lambda: shell)
    return parent


def test_a_cell_that_runs_again_closes_what_it_made(cell):
    trained = tk.pretrained()
    two = [Controller(*trained) for _ in range(2)]
    assert all(made.comm for made in two)
    cell |= {"metadata": {"cellId": "second"}, "header": {"msg_id": "2"}}
    other = Controller(*trained)
    cell |= {"metadata": {"cellId": "first"}, "header": {"msg_id": "3"}}
    again = Controller(*trained)
    assert [made.comm for made in two] == [None, None]
    assert other.comm
    assert again.comm
    again.close()
    other.close()


def test_without_cells_nothing_is_closed(cell):
    trained = tk.pretrained()
    cell["metadata"] = {}
    made = [Controller(*trained) for _ in range(2)]
    assert all(one.comm for one in made)
    for one in made:
        one.close()


def test_a_closed_widget_leaves_no_part(walk_clip):
    model, bank = tk.pretrained()
    before = set(_instances)
    for make in (lambda: Player(walk_clip.cut(0, 60)), lambda: Controller(model, bank), lambda: Director(model, bank)):
        made = make()
        assert set(_instances) > before
        made.close()
        made.close()  # a second time does no harm
        assert set(_instances) == before


def test_a_closed_player_that_a_notebook_keeps_holds_no_part_and_no_picture(walk_clip):
    kept = Player(walk_clip.cut(0, 60))
    rows = [part for part in kept.children if part is not kept.image]
    parts = [weakref.ref(part) for part in (*rows, *rows[1].children, *rows[2].children, *rows[3].children)]
    del rows
    kept.close()
    gc.collect()
    assert [part() for part in parts] == [None] * 14
    assert not kept.image.value
    assert len(kept.clip) == 60


def test_growth_is_seen():
    flat = [{"cycle": n, "memory": 500.0 + n % 3, "tasks": 5, "threads": 9} for n in range(50, 300, 10)]
    assert leaks(flat) == []
    assert leaks([*flat, {"cycle": 300, "memory": 500.0, "tasks": 6, "threads": 9}]) == ["tasks: 5 → 6"]
    assert leaks([{"cycle": n, "memory": 500.0 + 0.2 * n, "held": 9.0} for n in range(50, 300, 10)]) == [
        "memory: 0.20 MB a cycle"]
    steps = [{"cycle": n, "memory": 500.0 + 4.0 * (n > 60), "held": 9 + n / 5} for n in range(50, 300, 10)]
    assert leaks(steps) == ["held: 0.20 MB a cycle"]


@pytest.mark.filterwarnings("ignore:Output cache limit")
def test_ipython_keeps_results_and_outputs_without_a_limit(capsys):
    """What docs/robustness.md says of a notebook that grows; ``long-use --forget`` empties these tables."""
    config = Config({"HistoryManager": {"hist_file": ":memory:"}, "InteractiveShell": {"cache_size": 4}})
    shell = InteractiveShell(config=config)
    for number in range(8):
        shell.run_cell(f"{number} + 100", store_history=True)
    assert sorted(shell.user_ns["Out"]) == [5, 6, 7, 8]
    assert [name for name in shell.user_ns_hidden if name[1:].isdigit()] == [f"_{number}" for number in range(1, 9)]
    assert len(shell.history_manager.outputs) == 8
    assert "Out[8]: 107" in capsys.readouterr().out
