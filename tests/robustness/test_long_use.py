"""What widgets leave behind in a kernel."""

from types import SimpleNamespace

import pytest
from ipywidgets.widgets.widget import _instances

import toolkit as tk
from toolkit.extra.shots.director import Director
from toolkit.view.widgets.controller import Controller
from toolkit.view.widgets.player import Player

pytestmark = pytest.mark.usefixtures("one_walk")


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


def test_a_closed_widget_leaves_no_part(walk_clip):
    model, bank = tk.pretrained()
    before = set(_instances)
    for make in (lambda: Player(walk_clip.cut(0, 60)), lambda: Controller(model, bank),
                 lambda: Director(model, bank)):
        made = make()
        assert set(_instances) > before
        made.close()
        made.close()  # a second time does no harm
        assert set(_instances) == before
