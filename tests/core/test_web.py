import base64
import copy
import json
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
import torch
from refusal import refusal
from test_compiled import drawn

import toolkit as tk
from toolkit import view
from toolkit.extra.shots import crowd
from toolkit.view.pages import live_page, page

SCENE = Path(page.__file__).parents[1] / "scene"


@pytest.fixture(scope="module")
def trained():
    return tk.pretrained()


@pytest.fixture(scope="module")
def node(tmp_path_factory):
    """``node(source, **given)``.

    What JavaScript assigns to ``result``; a file of the scene is ``await scene(name)``.
    """
    program = shutil.which("node")
    if program is None:
        pytest.skip("no Node found (Debian: apt-get install nodejs)")
    folder = tmp_path_factory.mktemp("node")

    def run(source: str, **given):
        (folder / "given.json").write_text(json.dumps(given), encoding="utf-8")
        (folder / "run.mjs").write_text(f"""
            import {{ readFileSync, writeFileSync }} from "node:fs";
            const scene = (name) => import({json.dumps(SCENE.as_uri())} + `/${{name}}.js`);
            const given = JSON.parse(readFileSync({json.dumps(str(folder / "given.json"))}));
            const listed = (state) => Object.fromEntries(
                Object.entries(state).map(([name, values]) => [name, [...values]]));
            let result;
            {source}
            writeFileSync({json.dumps(str(folder / "result.json"))}, JSON.stringify(result));
        """, encoding="utf-8")
        done = subprocess.run(
            [program, folder / "run.mjs"], capture_output=True, text=True, timeout=120, check=False
        )
        assert done.returncode == 0, done.stderr
        return json.loads((folder / "result.json").read_text(encoding="utf-8"))

    return run


def test_a_page_holds_the_chosen_styles_and_half_the_bytes(small_run, tmp_path):
    model, bank = small_run.model, small_run.bank
    path = view.web(model, bank, tmp_path / "walk.html")
    text = path.read_text(encoding="utf-8")
    data = json.loads(re.search(r'id="data">(.*?)</script>', text)[1])
    assert data["styles"] == ["Neutral", "Zombie"]
    assert data["traits"]["names"] == ["Neutral", "Zombie", "Neutral"]

    one = view.web(model, bank, tmp_path / "one.html", styles=["Zombie"], half=True)
    data = json.loads(re.search(r'id="data">(.*?)</script>', one.read_text(encoding="utf-8"))[1])
    assert data["styles"] == ["Zombie"]
    assert np.array_equal(read(data["vectors"]), bank["Zombie"])
    weights = sum(p.numel() for layer in model.experts.layers for p in (layer.weight, layer.bias))
    saved = path.stat().st_size - one.stat().st_size
    assert saved == pytest.approx(2 * 4 / 3 * weights, rel=0.1)


def read(packed: dict) -> np.ndarray:
    kind = {"float32": "<f4", "float16": "<f2"}[packed["type"]]
    return np.frombuffer(base64.b64decode(packed["data"]), kind).astype(np.float32)


def test_another_model_is_shown_as_recorded_walks(small_run, tmp_path, monkeypatch):
    monkeypatch.setattr(live_page, "SECONDS", 0.2)
    other = tk.networks.build("pfnn-film", small_run.model.layout, 2, small_run.model.sizes)
    text = view.web(other, small_run.bank, tmp_path / "x.html").read_text(encoding="utf-8")
    assert "Recorded walks: the model pfnn-film cannot run in a page." in text
    assert "toolkitScene.player(stage, data)" in text


def test_what_does_not_go_into_a_page_is_refused_in_one_line(small_run, tmp_path):
    model, bank = small_run.model, small_run.bank
    huge = copy.deepcopy(model)
    torch.nn.init.constant_(huge.experts.layers[1].bias, 1e5)
    for refused, given in {
        "got 'Zombie'": (model, bank, {"styles": "Zombie"}),
        "at most 65504 in float16, got 100000": (huge, bank, {"half": True})
    }.items():
        with refusal(refused):
            view.web(given[0], given[1], tmp_path / "x.html", **given[2])
    assert not list(tmp_path.iterdir())


def test_every_float16_is_read_as_it_was_written(node):
    halves = np.arange(65536, dtype=np.uint16).view(np.float16)
    finite = halves[np.isfinite(halves)]
    packed = {"type": "float16", "data": base64.b64encode(finite.tobytes()).decode()}
    seen = node(
        'const { numbers } = await scene("numbers"); result = [...numbers(given.packed)];',
        packed=packed
    )
    assert np.array_equal(np.array(seen, np.float32), finite.astype(np.float32))


@pytest.mark.parametrize("calibrated", [False, True])
def test_a_step_from_anywhere_is_pythons(node, small_run, calibrated):
    """Forty states that no walk leads to, with feet crossed, commands to stand, to run and to look
    nowhere.
    """
    model, g = copy.deepcopy(small_run.model), torch.Generator().manual_seed(0)
    model.calibrated, count = calibrated, 40
    first = drawn(tk.runtime.start(model, small_run.bank["Zombie"].expand(count, -1)))
    states = {name: value.double() for name, value in vars(first).items()}
    velocity, facing = torch.randn(2, count, 2, generator=g, dtype=torch.float64)
    velocity[::4] = facing[::5] = 0

    state, double = tk.runtime.CharacterState(**states), copy.deepcopy(model).double()
    with torch.inference_mode():
        after = tk.runtime.step(double, state, tk.runtime.Command(velocity, facing))
        expected = {
            name: value.flatten(1) for name, value in vars(after).items() if name != "style"
        }
        expected["rotations"], expected["root"] = (
            value.flatten(1) for value in tk.runtime.pose(model.layout, after)
        )
    seen = node(
        """
        const { Character } = await scene("character");
        const { copy } = await scene("frame");
        const character = new Character(given.data);
        result = given.states.map((state, i) => {
            character.state = copy(state);
            character.step({ velocity: given.velocity[i], facing: given.facing[i] }, given.style);
            character.pose();
            const { rotations, root } = character;
            return listed({ ...character.state, rotations, root });
        });
    """,
        data=live_page.pack(model, small_run.bank),
        velocity=velocity.tolist(),
        facing=facing.tolist(),
        style=states.pop("style")[0].tolist(),
        states=[
            {name: values[i].flatten().tolist() for name, values in states.items()}
            for i in range(count)
        ],
    )
    for name, values in expected.items():
        mine = torch.tensor([one[name] for one in seen], dtype=torch.float64)
        if name == "rotations":
            mine, values = (
                (q.view(count, -1, 4) * q.view(count, -1, 4)[..., :1].sign()).flatten(1)
                for q in (mine, values)
            )
        assert torch.allclose(mine, values, rtol=0, atol=1e-6), (
            f"{name}: {float((mine - values).abs().max())}"
        )


def test_a_crowd_starts_as_pythons_and_walks_its_rings(node, trained, tmp_path):
    model, bank = trained
    data = live_page.pack(model, bank, characters=6)
    assert [one["style"] for one in data["others"]] == [1, 2, 3, 4, 5]
    seen = node(
        """
        const { Kernel } = await scene("character");
        const kernel = new Kernel(given.data);
        const started = kernel.others.map(({ character }) => listed(character.state));
        result = { started, drawn: 0 };
        kernel.on("msg:custom", ({ kind }, [poses]) => {
            if (kind === "others") result.drawn = poses.length;
        });
        for (let i = 0; i < 100; i++) kernel.step();
        kernel.show();
        result.roots = kernel.others.map(({ character }) => [...character.root]);
        result.user = [...kernel.character.root];
    """,
        data=data,
    )
    radii, angles, ways = crowd.places(5)
    place, facing = (torch.stack(pair, -1) for pair in (
        (radii * angles.sin(), radii * angles.cos()), (ways * angles.cos(), -ways * angles.sin())))
    expected = tk.runtime.start(model, bank.vectors[1:6], place, facing)
    for name in ("history", "future", "facing", "toes", "joints"):
        started = torch.tensor([one[name] for one in seen["started"]])
        assert torch.allclose(started, getattr(expected, name).flatten(1), atol=1e-5), name
    assert seen["drawn"] == 5
    roots = torch.tensor(seen["roots"])
    assert (roots[:, ::2].norm(dim=-1) - radii).abs().max() < 0.7
    assert (roots[:, ::2] - place).norm(dim=-1).min() > 0.5
    assert np.hypot(*seen["user"][::2]) < 0.5
    with refusal(r"characters must be 1 or more, .* got 0"):
        view.web(model, bank, tmp_path / "x.html", characters=0)


def test_many_at_once_walk_as_each_alone_with_and_without_webassembly(node, small_run):
    seen = node(
        """
        const { Character, advance } = await scene("character");
        const { Network } = await scene("network");
        const walk = (network, n, alone) => {
            const crowd = Array.from({ length: n }, () => new Character(given.data, network));
            for (let t = 0; t < 40; t++) {
                const commands = crowd.map((_, c) =>
                    ({ velocity: [0.3 * c, 1], facing: [Math.sin(c), Math.cos(c)] }));
                const styles = crowd.map((_, c) => given.styles[c % 2]);
                if (alone) crowd.forEach((one, c) => one.step(commands[c], styles[c]));
                else advance(crowd, commands, styles);
            }
            return crowd.map((one) => (one.pose(), [...one.root, ...one.rotations]));
        };
        const { network } = given.data;
        const plain = new Network(network, { plain: true }), fast = new Network(network);
        result = { simd: Boolean(fast.simd), expected: walk(plain, 6, true),
                   plain: walk(plain, 6), few: walk(fast, 3),
                   alone: walk(fast, 6, true), many: walk(fast, 6) };
    """,
        data=live_page.pack(small_run.model, small_run.bank),
        styles=small_run.bank.vectors.tolist(),
    )
    assert seen["simd"]
    expected = np.array(seen["expected"])
    assert np.abs(expected[1:] - expected[0]).max() > 0.1
    for kind in ("plain", "few", "alone", "many"):
        assert np.abs(np.array(seen[kind]) - expected[: len(seen[kind])]).max() < 1e-8, kind


def test_the_kernel_in_a_page_does_what_a_notebooks_does(node, trained, fast, tmp_path):
    """Keys, stick, marker and recording, against `toolkit.view.Controller`."""
    model, bank = trained
    control = view.Controller(*fast)
    control.send = lambda content, buffers: sent.append(np.frombuffer(buffers[0], np.float32))
    sent, data = [], live_page.pack(model, bank.select(["Neutral", "Zombie", "Aeroplane"]))
    wishes = [
        {
            "kind": "input", "id": i, "move": [0.5, 1], "turn": turn, "run": turn < 0,
            "heading": heading
        }
        for i, (turn, heading) in enumerate(((1, None), (-1, None), (0, [0.6, -0.8])), 1)
    ]
    control.weights = [0.5, 0.25, 0.25]
    for wish in wishes:
        control._receive(control, wish, [])
        control.advance(20)
    control.close()
    seen = node(
        """
        const { Kernel } = await scene("character");
        const kernel = new Kernel(given.data), frames = [], names = [];
        kernel.on("msg:custom", ({ frame, input }, [buffer]) =>
            frames.push([frame, input, ...buffer]));
        kernel.on("change:weights", () => names.push(kernel.get("names")));
        kernel.download = (text) => (result.bvh = text);
        result = { frames, names };
        kernel.set("weights", [0.5, 0.25, 0.25]);
        for (const wish of given.wishes) {
            if (wish.id === 3) kernel.set("recording", true);
            kernel.send(wish);
            for (let i = 0; i < 20; i++) kernel.step(), kernel.show();
        }
        kernel.set("recording", false);
    """,
        data=data,
        wishes=wishes,
    )
    frames = np.array(seen["frames"])
    assert seen["names"] == [["Neutral", "Zombie", "Aeroplane"]]
    assert frames[:, 0].tolist() == list(range(1, 61))
    assert frames[:, 1].tolist() == [1] * 20 + [2] * 20 + [3] * 20
    # Python computes in single precision, the page in double.
    apart = np.abs(frames[:, 2:] - np.array(sent))
    assert apart[:10].max() < 2e-3
    assert apart.max() < 2e-2

    (tmp_path / "walk.bvh").write_text(seen["bvh"], encoding="utf-8")
    clip = tk.bvh.load(tmp_path / "walk.bvh")
    assert (len(clip), clip.fps, clip.skeleton.names) == (20, 60.0, model.layout.skeleton.names)
    joints = len(clip.skeleton)
    shown = tk.Clip(
        clip.skeleton, torch.tensor(frames[40:, 5 : 5 + 4 * joints]).float().view(20, joints, 4),
        torch.tensor(frames[40:, 2:5]).float(), 60.0
    )
    assert (clip.global_positions - shown.global_positions).norm(dim=-1).max() < 1e-4
