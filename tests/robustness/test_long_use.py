"""What widgets leave behind in a kernel."""

from types import SimpleNamespace

from ipywidgets.widgets.widget import _instances

import toolkit as tk
from toolkit.extra.shots.director import Director
from toolkit.view.widgets.controller import Controller
from toolkit.view.widgets.player import Player


def test_a_cell_that_runs_again_closes_what_it_made(walk_clip, monkeypatch):
    parent, results = {}, {}  # the message that runs a cell of JupyterLab; what IPython holds
    names = {"Out": results, "_oh": results}
    shell = SimpleNamespace(user_ns=names, user_ns_hidden=dict(names))
    shell.kernel = SimpleNamespace(get_parent=lambda: parent, shell=shell)
    monkeypatch.setattr("IPython.get_ipython", lambda: shell)
    made = []
    for message, cell in enumerate(("first", "second", "first")):
        parent |= {"metadata": {"cellId": cell}, "header": {"msg_id": message}}
        made += [Player(walk_clip.cut(0, 10)) for _ in range(2)]
        results[message] = made[-1]
        for of in (shell.user_ns, shell.user_ns_hidden):
            of |= {f"_{message}": made[-1], "mine": made[1]}
    assert list(results) == [1, 2]
    for of in (shell.user_ns, shell.user_ns_hidden):
        assert list(of) == ["Out", "_oh", "mine", "_1", "_2"]
        assert of["mine"] is made[1]
    assert [bool(player.comm) for player in made] == [False] * 2 + [True] * 4
    for player in made:
        player.close()


def test_a_closed_widget_leaves_no_part(walk_clip, fast):
    before = set(_instances)
    for make in (lambda: Player(walk_clip.cut(0, 60)), lambda: Controller(*fast),
                 lambda: Director(*tk.pretrained())):
        made = make()
        assert set(_instances) > before
        made.close()
        made.close()  # a second time does no harm
        assert set(_instances) == before
