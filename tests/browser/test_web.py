"""A character whose network runs in the page, opened from a file: under keys, touch, gamepad."""

import dataclasses

import pytest

import toolkit as tk

from .conftest import (
    COMMENT,
    IMAGE,
    PLANTED,
    SCRIPT,
    SIZES,
    drag,
    middle,
    shows_as_text,
    touches,
    visits,
)

MOVED = """([x, z, far]) => {
    const [a, , b] = view.kernel.character.root;
    return Math.hypot(a - x, b - z) > far;
}"""
ROOT = "() => [...view.kernel.character.root]"


@pytest.fixture(scope="module")
def page(browser, pages):
    """The embedded model on a desk, of the tests in turn."""
    with visits(browser) as visit:
        yield drawn(visit(tk.view.web(*tk.pretrained(), pages / "character.html", half=True)))


def drawn(page):
    page.wait_for_function("() => globalThis.view?.stats.drawn > 0")
    return page


def wait_for_move(page, before, metres=0.5) -> None:
    page.wait_for_function(MOVED, arg=[before[0], before[2], metres])


def test_a_thumb_on_a_phone_walks_before_a_crowd_that_looks_the_same_drawn_by_either_way(
        visit, pages):
    """On the processor, as this browser draws, and instanced on the GPU; of planted names."""
    model, bank = tk.pretrained()
    bank = dataclasses.replace(bank.select(["Neutral", "Zombie", "Old"]), names=PLANTED,
                               broken=[False, True, False])
    page = drawn(visit(tk.view.web(model, bank, pages / "crowd.html", title=COMMENT, characters=4,
                                   half=True), "phone"))
    shown = page.locator(".tkc-menus select").first.locator("option").all_text_contents()
    assert sorted(shown) == sorted([IMAGE, f"{SCRIPT} (broken)", COMMENT])
    send = touches(page)
    stick, before = page.locator(".tkc-stick"), page.evaluate(ROOT)
    send("touchStart", middle(stick))
    send("touchMove", middle(stick, 0, -50))
    wait_for_move(page, before)
    send("touchEnd")
    page.wait_for_function("() => view.kernel.input.heading === null")
    triangle = page.locator(".tk-triangle svg").bounding_box()
    page.touchscreen.tap(triangle["x"] + 40, triangle["y"] + 165)
    assert page.evaluate("() => view.kernel.get('weights')")[2] > 0.7

    view, side = (page.locator(name).bounding_box() for name in (".tkc-view", ".tkc-side"))
    assert view["height"] > 0.4 * SIZES["phone"]["height"]
    assert side["y"] >= view["y"] + view["height"]
    assert side["y"] + side["height"] <= SIZES["phone"]["height"]
    assert page.evaluate("() => document.documentElement.scrollWidth") == SIZES["phone"]["width"]

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
        return { count: others.length, shown: apart(mine, empty), apart: apart(mine, picture()) };
    }""")
    assert seen["count"] == 3
    assert seen["shown"] > 0.005
    assert seen["apart"] < 0.2 * seen["shown"]  # edges, more of them the nearer they are
    shows_as_text(page)


def test_a_page_keeps_its_own_rate(page):
    # Sixty frames in a second of the page's clock, whether it draws more often or seldom.
    for period, expected in ((4, 60), (50, 60), (400, 15)):  # ms; it makes up for gaps of 100 ms
        made = page.evaluate("""(period) => {
            cancelAnimationFrame(view.kernel.handle);
            const request = globalThis.requestAnimationFrame, { kernel } = view;
            let tick;
            globalThis.requestAnimationFrame = (callback) => (tick = callback, 0);
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


def test_what_is_broken_while_it_runs_is_said_and_forgotten(page):
    # The watch spends 2 ms between two pictures; here its pictures come at once, and only as many
    # as it takes to look at the frames that the kernel made.
    said = page.evaluate("""async () => {
        const { kernel, stats } = view, { character } = kernel, pose = character.pose;
        const waiting = [], found = document.querySelector(".tkc-found");
        cancelAnimationFrame(kernel.handle);
        const request = globalThis.requestAnimationFrame;
        globalThis.requestAnimationFrame = (tick) => waiting.push(tick);
        while (!waiting.length) await new Promise((done) => setTimeout(done));
        const look = (frames) => {
            for (let k = 0; k < frames; k++) kernel.step();
            kernel.show();
            for (const { looks } = stats; stats.looks === looks;) waiting.pop()(0);
            return found.textContent;
        };
        const said = [look(120)];
        character.pose = function (traits) {
            pose.call(this, traits);
            this.root[1] += 0.02 * (kernel.frame % 2);
        };
        said.push(look(120));
        delete character.pose;
        said.push(look(300));
        globalThis.requestAnimationFrame = request;
        request(waiting.pop());
        kernel.run();
        return said;
    }""")
    assert ["shake: " in line for line in said] == [False, True, False]


def test_keys_gamepad_and_marker(page):
    page.keyboard.down("w")  # nothing was clicked
    wait_for_move(page, [0, 0, 0])
    walked = page.evaluate(ROOT)
    page.keyboard.down("q")
    page.wait_for_function("() => view.kernel.character.state.facing[0] > 0.5")
    page.keyboard.up("q")
    page.keyboard.up("w")
    assert walked[2] > abs(walked[0])

    triangle = page.locator(".tk-triangle svg")
    drag(page, middle(triangle, 0, 17), middle(triangle, 70, 59))
    weights = page.evaluate("() => view.kernel.get('weights')")
    assert weights[1] > 0.7
    assert sum(weights) == pytest.approx(1)
    bank = tk.pretrained().bank
    far = 0.4 * float((bank["Neutral"] - bank["Zombie"]).norm())
    near = "([style, far]) => Math.hypot(...view.kernel.style.map((v, i) => v - style[i])) < far"
    page.wait_for_function(near, arg=[bank["Zombie"].tolist(), far])
    page.keyboard.press("ArrowUp")  # the marker has the focus, and its own arrows
    assert page.evaluate("() => view.kernel.input.move") == [0, 0]

    page.locator(".tkc-record").click()
    pad = "{ connected: true, axes: [1, 0, 0, 0], buttons: [] }"
    page.evaluate(f"() => {{ navigator.getGamepads = () => [{pad}]; }}")
    wait_for_move(page, page.evaluate(ROOT))
    with page.expect_download() as download:
        page.locator(".tkc-record").click()
    clip = tk.bvh.load(download.value.path())
    assert download.value.suggested_filename == "walk.bvh"
    assert (clip.root_positions[-1] - clip.root_positions[0]).norm() > 0.4
