"""A character whose network runs in the page: opened from a file, it walks as Python does, under keys, touch and gamepad."""

import json

import pytest
from walks import COMMANDS, WALK, apart, commands

import toolkit as tk

from .conftest import ARTEFACTS

SIZES = {"desk": {"width": 1280, "height": 760}, "phone": {"width": 390, "height": 844}}
COST = """() => {
    const { character, style } = view.kernel, taken = { step: [], pose: [] };
    const time = (what, kind, n = 10) => {
        const start = performance.now();
        for (let i = 0; i < n; i++) what();
        taken[kind].push((performance.now() - start) / n);
    };
    for (let i = 0; i < 60; i++) {
        time(() => character.step({ velocity: [0, 1], facing: [0, 1] }, style), "step");
        time(() => character.pose(), "pose");
    }
    return Object.fromEntries(Object.entries(taken).map(([kind, ms]) => {
        ms.sort((a, b) => a - b);
        return [kind, { median: ms[ms.length >> 1], best: ms[0] }];
    }));
}"""


class Live:
    """An open page, with what it said and asked for."""

    def __init__(self, page, path):
        self.page, self.errors, self.asked = page, [], []
        page.on("console", lambda m: self.errors.append(m.text) if m.type == "error" else None)
        page.on("pageerror", lambda e: self.errors.append(str(e)))
        page.on("request", lambda request: self.asked.append(request.url))
        page.goto(path.as_uri())
        page.wait_for_function("() => globalThis.view?.stats.drawn > 0")
        self.seconds = page.evaluate("() => performance.now() / 1000")  # since it was opened

    def root(self) -> list[float]:
        return self.page.evaluate("() => [...view.kernel.character.root]")

    def wait_for_move(self, before, metres=0.7) -> None:
        self.page.wait_for_function(
            "([x, z, far]) => { const [a, , b] = view.kernel.character.root; return Math.hypot(a - x, b - z) > far; }",
            arg=[before[0], before[2], metres],
        )


@pytest.fixture
def open_page(browser):
    """``open_page(path, size)``: a page in a window, or on a phone that is touched."""
    contexts = []

    def open_(path, size: str = "desk") -> Live:
        phone = size == "phone"
        contexts.append(browser.new_context(viewport=SIZES[size], has_touch=phone, is_mobile=phone))
        return Live(contexts[-1].new_page(), path)

    yield open_
    for context in contexts:
        context.close()


@pytest.fixture(scope="module")
def embedded(tmp_path_factory):
    return tk.view.web(*tk.pretrained(), tmp_path_factory.mktemp("web") / "character.html")


@pytest.mark.parametrize("kind", ["embedded", "published"])
def test_six_hundred_frames_are_pythons(open_page, tmp_path, request, kind):
    """Prints distances, milliseconds and sizes (``-s`` shows them); only the distance is a condition."""
    if kind == "published":
        model, bank = tk.published.load(request.getfixturevalue("shared") / "lpn_film_100style")
    else:
        model, bank = tk.pretrained()
    styles, measured = ("Neutral", "Zombie", "Aeroplane"), {}
    walked = {name: tk.runtime.rollout(model, COMMANDS, bank[name]) for name in styles}
    for half in (False, True):
        path = tk.view.web(model, bank, tmp_path / f"{kind}-{half}.html", half=half)
        live = open_page(path)
        found = {"megabytes": path.stat().st_size / 1e6, "seconds to open": live.seconds}
        measured["half" if half else "float32"] = found
        for name in styles:
            live.page.evaluate("name => { view.kernel.set('names', [name, name, name]); }", name)
            poses = live.page.evaluate(f"c => ({WALK})(view.kernel.character, c, view.kernel.target())", commands())
            distance = apart(walked[name], poses)
            assert len(distance) == 600
            found[name] = {f"mm at frame {frame}": float(distance[frame - 1]) for frame in (1, 60, 300, 600)}
        found["ms"] = live.page.evaluate(COST)
        assert live.errors == []
        assert [url for url in live.asked if not url.startswith(("file:", "data:", "blob:"))] == []
        live.page.close()
    print("\n", json.dumps(measured, indent=1))
    ARTEFACTS.mkdir(parents=True, exist_ok=True)
    file = ARTEFACTS / "web.json"
    known = json.loads(file.read_text(encoding="utf-8")) if file.exists() else {}
    file.write_text(json.dumps(known | {kind: measured}, indent=1), encoding="utf-8")
    for name in styles:
        assert measured["float32"][name]["mm at frame 60"] < 1.0


def test_keys_gamepad_and_marker(open_page, embedded):
    live = open_page(embedded)
    page = live.page
    page.keyboard.down("w")  # nothing was clicked
    live.wait_for_move([0, 0, 0], 1.0)
    walked = live.root()
    page.keyboard.down("q")
    page.wait_for_function("() => view.kernel.character.state.facing[0] > 0.5")
    page.keyboard.up("q")
    page.keyboard.up("w")
    assert walked[2] > abs(walked[0])

    box = page.locator(".tk-triangle svg").bounding_box()
    page.mouse.move(box["x"] + 110, box["y"] + 123)
    page.mouse.down()
    page.mouse.move(box["x"] + 180, box["y"] + 165, steps=8)
    page.mouse.up()
    weights = page.evaluate("() => view.kernel.get('weights')")
    assert weights[1] > 0.7
    assert sum(weights) == pytest.approx(1)
    zombie = tk.pretrained().bank["Zombie"]
    page.wait_for_function(
        "([zombie, far]) => Math.hypot(...view.kernel.style.map((v, i) => v - zombie[i])) < far",
        arg=[zombie.tolist(), 0.4 * float((tk.pretrained().bank["Neutral"] - zombie).norm())],
    )
    before = live.root()
    page.keyboard.down("ArrowUp")  # the marker has the focus, and its own arrows
    page.wait_for_timeout(100)
    page.keyboard.up("ArrowUp")
    assert page.evaluate("() => view.kernel.input.move") == [0, 0]
    page.keyboard.down("s")
    live.wait_for_move(before)
    page.keyboard.up("s")

    page.locator(".tkc-record").click()
    page.evaluate("() => { navigator.getGamepads = () => [{ connected: true, axes: [1, 0, 0, 0], buttons: [] }]; }")
    live.wait_for_move(live.root())
    with page.expect_download() as download:
        page.locator(".tkc-record").click()
    path = download.value.path()
    clip = tk.bvh.load(path)
    assert download.value.suggested_filename == "walk.bvh"
    assert float((clip.root_positions[-1] - clip.root_positions[0]).norm()) > 0.5
    page.evaluate("() => view.scene.setQuality(2)")  # whole pixels
    page.wait_for_timeout(200)
    ARTEFACTS.mkdir(parents=True, exist_ok=True)
    page.screenshot(path=ARTEFACTS / "web.png")
    assert live.errors == []


def test_a_thumb_on_the_stick_walks_on_a_phone(open_page, embedded):
    live = open_page(embedded, "phone")
    page = live.page
    touch = page.context.new_cdp_session(page)
    stick = page.locator(".tkc-stick").bounding_box()
    x, y = stick["x"] + stick["width"] / 2, stick["y"] + stick["height"] / 2
    before = live.root()
    touch.send("Input.dispatchTouchEvent", {"type": "touchStart", "touchPoints": [{"x": x, "y": y}]})
    touch.send("Input.dispatchTouchEvent", {"type": "touchMove", "touchPoints": [{"x": x, "y": y - 50}]})
    live.wait_for_move(before, 1.0)
    page.screenshot(path=ARTEFACTS / "web-phone.png")
    touch.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
    page.wait_for_function("() => view.kernel.input.heading === null")
    triangle = page.locator(".tk-triangle svg").bounding_box()
    page.touchscreen.tap(triangle["x"] + 40, triangle["y"] + 165)
    assert page.evaluate("() => view.kernel.get('weights')")[2] > 0.7

    view, side, window = (page.locator(name).bounding_box() for name in (".tkc-view", ".tkc-side", "body"))
    assert view["height"] > 0.4 * window["height"]
    assert side["y"] >= view["y"] + view["height"]
    assert side["y"] + side["height"] <= SIZES["phone"]["height"]
    assert page.evaluate("() => document.documentElement.scrollWidth") == SIZES["phone"]["width"]
    assert live.errors == []


def test_a_crowd_looks_the_same_drawn_by_either_way(open_page, tmp_path):
    """On the processor, as this browser draws, and instanced on the GPU."""
    path = tk.view.web(*tk.pretrained(), tmp_path / "crowd.html", characters=6)
    live = open_page(path)
    page = live.page
    page.wait_for_function("() => view.kernel.frame > 30")
    seen = page.evaluate("""() => {
        cancelAnimationFrame(view.kernel.handle);
        const { scene, kernel } = view;
        const others = kernel.others.map(({ character: { root, rotations } }) => [root, rotations]);
        const gl = scene.renderer.getContext(), [w, h] = [scene.canvas.width, scene.canvas.height];
        const picture = () => {
            scene.render();
            const pixels = new Uint8Array(4 * w * h);
            gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
            return pixels;
        };
        const apart = (a, b) => a.reduce((n, v, i) => n + (Math.abs(v - b[i]) > 24), 0) / a.length;
        scene.crowd.pose(others);
        const mine = picture(), bodies = scene.crowd;
        for (const mesh of bodies.meshes) mesh.visible = false;
        const empty = picture(), { skeleton, tints } = kernel.get("crowd");
        const instanced = new toolkitScene.Crowd(skeleton, tints, scene.light, "#cdc8be");
        scene.scene.add(...instanced.meshes);
        instanced.pose(others);
        const theirs = picture(), moved = others.map(([[x, , z]]) => Math.hypot(x, z));
        return { count: others.length, shown: apart(mine, empty), apart: apart(mine, theirs), moved };
    }""")
    assert seen["count"] == 5
    assert seen["shown"] > 0.01
    assert seen["apart"] < 0.1 * seen["shown"]
    page.screenshot(path=ARTEFACTS / "crowd.png")
    assert live.errors == []


def test_frames_keep_their_own_rate(open_page, embedded):
    """Sixty in a second of the page's clock, whether it draws more often or seldom."""
    page = open_page(embedded).page
    for period, expected in ((4, 60), (8, 60), (16.6, 60), (50, 60), (400, 15)):  # ms; longest gap made up for: 100 ms
        made = page.evaluate("""(period) => {
            cancelAnimationFrame(view.kernel.handle);
            const request = globalThis.requestAnimationFrame;
            let tick;
            globalThis.requestAnimationFrame = (callback) => (tick = callback, 0);
            const { kernel } = view;
            kernel.last = 0;
            kernel.due = 0;
            kernel.run();
            const first = kernel.frame;
            for (let now = 1; now <= 2001; now += period) tick(now);
            globalThis.requestAnimationFrame = request;
            kernel.run();
            return (kernel.frame - first) / 2;
        }""", period)
        assert abs(made - expected) <= 1, f"every {period} ms"
