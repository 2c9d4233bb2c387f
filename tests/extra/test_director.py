"""The director's kernel: shots in and out, what it refuses, its page from the command line."""

import json

import pytest
import torch
import traitlets

import toolkit as tk
from toolkit import __main__ as line
from toolkit.extra.shots import Shot, director
from toolkit.networks.bank import StyleBank
from toolkit.view import Director


@pytest.fixture(scope="module")
def desk():
    return Director(*tk.pretrained())


def test_shots_go_in_and_out(desk):
    assert {"data", "scene", "height"} <= set(desk.keys)  # which the page gets
    assert [shot.name for shot in desk.shots] == ["shot 1"]
    assert [(p.x, p.z) for p in desk.shots[0].path] == [(0, 0), (0.6, 2), (-0.6, 4), (0, 6)]
    blended = [(0, "Old"), (1, {"Old": 0.5, "Strut": 0.5})]
    two = [Shot([(0, 0), (0, 1)], "Zombie", duration=0.5), Shot([(1, 0), (1, 2)], blended)]
    desk.shots = two
    assert desk.shots == two
    json.dumps(desk.scene)
    # of a page
    desk.scene = {"version": 1,
                  "shots": [{"path": [[0, 0], [0, 1]], "styles": "Zombie", "duration": 0.5}]}
    assert len(desk.render()) == 30


@pytest.mark.parametrize(("changes", "said"), [
    ({"version": 10**400}, "version"), ({"shots": [{}] * 10**5}, "at most 256 entries, got 100000"),
    ({"walls": [[0]]}, "walls"), ({"path": [[[0] * 9] * 9] * 9}, "path"),
    ({"styles": "Nobody"}, "Nobody"), ({"name": "x" * 10**5}, "name"),
])
def test_a_scene_that_is_not_valid_is_refused_in_one_line(desk, changes, said):
    """A message of any page; the kernel keeps the scene that it had."""
    before = json.loads(json.dumps(desk.scene))
    scene = before | {key: changes[key] for key in changes.keys() & {*before, "walls"}}
    if scene == before:
        scene["shots"] = [before["shots"][0] | changes]
    with pytest.raises(traitlets.TraitError, match=said) as error:
        desk.set_state({"scene": scene})
    assert len(str(error.value)) < 300
    assert str(error.value).isprintable()
    assert desk.scene == before


def test_the_kernel_renders_what_does_not_run_in_a_page(tmp_path):
    model, bank = tk.pretrained()
    other = tk.networks.build("pfnn-film", model.layout, 2, model.sizes)
    few = StyleBank(bank.names[:2], torch.zeros(2, other.style_size))
    shot = Shot([(0, 0), (0, 1)], few.names[0], name="to the door", duration=0.2)
    text = director.web(other, few, tmp_path / "desk.html", [shot]).read_text(encoding="utf-8")
    assert "Recorded shots: the model pfnn-film cannot run in a page." in text
    assert "to the door" in text
    own = Director(other, few, [shot])
    assert not {"network", "start"} & own.data.keys()
    for weight in other.parameters():
        weight.data.fill_(float("nan"))
    before, own.shots = own.motion, [shot, shot]
    assert (before["scene"], own.motion["scene"]) == (tk.shots.data([shot]), own.scene)
    assert "takes" not in own.motion
    assert "finite" in own.motion["problem"]
    own.close()


def test_the_command_line_writes_a_page_of_a_file(tmp_path):
    shot = Shot([(0, 0), (0, 1)], "Zombie", name="</script><b>")
    shot.save(tmp_path / "shot.json")
    words = ["export", "director", "--shots", str(tmp_path / "shot.json"), "--half", "--styles",
             "Zombie,Old"]
    assert line.main([*words, "--out", str(tmp_path / "desk.html")]) == 0
    page = (tmp_path / "desk.html").read_text(encoding="utf-8")
    assert "</script><b>" not in page
    text = page.split('id="data">')[1].split("</script>")[0]
    data = json.loads(text)
    assert tk.shots.parse(data["scene"]) == [shot]
    assert data["styles"] == ["Zombie", "Old"]
    assert data["course"]["FPS"] == 60
