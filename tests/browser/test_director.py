"""The director in a page, by mouse, keys and touch: draw, drag, key, scrub, undo, save, export; its course is Python's."""

import copy
import dataclasses
import json
import math
import time
from pathlib import Path

import pytest
import torch
from posed_rigs import rig, with_twists

import toolkit as tk
from toolkit import runtime
from toolkit.view import director
from toolkit.view.character import Character

from .conftest import ARTEFACTS

SIZES = {"desk": {"width": 1280, "height": 760}, "phone": {"width": 390, "height": 844}}
DONE = "() => !view.desk.making.some(Boolean) && view.desk.takes.every(Boolean)"
EXAMPLES = Path(__file__).resolve().parents[2] / "examples" / "shots"
ODD = {  # arrivals, pauses, easings, straight lines, a facing at a point, a style by layer, a point to look at
    "arrivals": {"path": [[0, 0], {"x": 1, "z": 2, "time": 3}, {"x": -1, "z": 3, "facing": [1, 0]}, [0, 5, 9]], "seed": 5,
                 "styles": [[0, "Neutral"], [2, {"Zombie": 0.5, "Old": 0.5}, "jump"], [4, "Strut", "in"]],
                 "holds": [{"seconds": 1, "distance": 3.5}], "duration": 7},
    "looks": {"path": [[0, 0], [2, 0.5], [2, 2]], "smooth": False, "look_at": [0, 3], "arms": False, "duration": 5,
              "styles": [[0, [{"Neutral": 1}, {"Zombie": 1}]], [2, "Old", "out"]],
              "speeds": [[0, 0.5, "smoother"], [3, 1.0]]},
    "too fast": {"path": [[0, 0], [0, 2], [0.4, 2.2], [0, 0.5]], "styles": "Zombie", "speeds": [[0, 2.5]], "duration": 4},
}


class Desk:
    """An open page, with what it said."""

    def __init__(self, page, path):
        self.page, self.errors = page, []
        page.on("console", lambda m: self.errors.append(m.text) if m.type == "error" else None)
        page.on("pageerror", lambda e: self.errors.append(str(e)))
        page.goto(path.as_uri())
        self.wait()

    def wait(self) -> None:
        self.page.wait_for_function("() => globalThis.view?.stats.drawn > 0")
        self.page.wait_for_function(DONE, timeout=120_000)
        self.page.evaluate("() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")

    @property
    def shots(self) -> list:
        return tk.shots.parse(self.page.evaluate("() => view.desk.scene"))

    def at(self, x: float, z: float) -> tuple[float, float]:
        """Where a place of the floor is on the screen."""
        box = self.page.locator(".tkd-map").bounding_box()
        dx, dy = self.page.evaluate("(place) => view.map.out(place)", [x, z])
        return box["x"] + dx, box["y"] + dy

    def drag(self, *points: tuple[float, float]) -> None:
        mouse = self.page.mouse
        mouse.move(*points[0])
        mouse.down()
        for point in points[1:]:
            mouse.move(*point, steps=4)
        mouse.up()

    def press(self, name: str) -> None:
        self.page.get_by_role("button", name=name, exact=True).click()


@pytest.fixture
def open_page(browser):
    contexts = []

    def open_(path, size: str = "desk") -> Desk:
        phone = size == "phone"
        contexts.append(browser.new_context(viewport=SIZES[size], has_touch=phone, is_mobile=phone))
        return Desk(contexts[-1].new_page(), path)

    yield open_
    for context in contexts:
        context.close()


@pytest.fixture(scope="module")
def empty(tmp_path_factory):
    return director.web(*tk.pretrained(), tmp_path_factory.mktemp("director") / "director.html", half=True)


def double() -> tuple:
    model, bank = tk.pretrained()
    return copy.deepcopy(model).double(), dataclasses.replace(bank, vectors=bank.vectors.double())


def apart(clip, motion) -> torch.Tensor:
    """Distance of the root and of the farthest joint in each frame ``[F, 2]``, mm; of poses [(root, rotations)]."""
    root, rotations = (torch.tensor(values, dtype=torch.float64) for values in zip(*motion, strict=True))
    other = dataclasses.replace(clip, rotations=rotations.unflatten(-1, (-1, 4)), root_positions=root)
    joints = (other.global_positions - clip.global_positions).norm(dim=-1)
    return 1e3 * torch.stack((joints[:, 0], joints.amax(-1)), -1)


def test_the_same_shots_give_the_same_courses_motion_and_words(open_page, empty):
    """Prints how far the page, and Python in float32, are from plain Python in double precision: root, farthest joint."""
    model, bank = double()
    scenes = {"along_a_wall": tk.shots.load(EXAMPLES / "along_a_wall.json")[0]}
    scenes |= {name: tk.shots.parse({"version": 1, "shots": [shot]})[0] for name, shot in ODD.items()}
    desk, measured = open_page(empty), {}
    for name, shot in scenes.items():
        desk.page.evaluate("(scene) => view.open(scene)", tk.shots.data([shot]))
        desk.wait()
        assert desk.shots == [shot], name
        found = desk.page.evaluate("""() => {
            const { course, heading } = view.desk.takes[0], { curve } = course;
            return { x: curve.x, z: curve.z, at: curve.at, knots: curve.knots, late: course.late,
                     distance: course.distance, speed: course.speed,
                     angles: course.distance.map((d) => heading.angle(d, [0.3, 0.2])),
                     motion: view.desk.motion(0).map((parts) => parts.map((part) => [...part])),
                     words: [...document.querySelectorAll(".tkd-say p")].map((line) => line.textContent) };
        }""")
        course, heading = shot.plan(bank)
        curve = course.curve
        expected = {"x": curve.x, "z": curve.z, "at": curve.at, "knots": curve.knots, "late": course.late,
                    "distance": course.distance, "speed": course.speed,
                    "angles": [heading.angle(d, (0.3, 0.2)) for d in course.distance]}
        for what, values in expected.items():
            assert found[what] == pytest.approx(values, abs=1e-9), f"{name}: {what}"
        clip = runtime.record(model, shot.states(model, bank), feet=shot.feet, arms=shot.arms)
        far = apart(clip, found["motion"])
        last = min(600, len(far))
        single = shot.render(*tk.pretrained())
        rough = apart(clip, zip(single.root_positions.tolist(), single.rotations.flatten(1).tolist(), strict=True))
        measured[name] = {"frames": last, "page, mm": far[:last].amax(0).tolist(),
                          "float32, mm": rough[:last].amax(0).tolist()}
        assert far[:last, 0].max() < 1.0, name
        if name != "along_a_wall":
            said = shot.check(model, bank)
            assert found["words"] == said, name
    assert len(said) > 1  # of the last, which is too fast
    print("\n", json.dumps(measured, indent=1))
    ARTEFACTS.mkdir(parents=True, exist_ok=True)
    (ARTEFACTS / "director.json").write_text(json.dumps(measured, indent=1), encoding="utf-8")
    assert desk.errors == []


CROSSING = {"version": 1, "apart": 0.9, "walls": [[[1.2, -3], [1.2, 3]]], "shots": [
    {"path": [[-3, 0], [0, 0.1], [0.6, 2]], "styles": "Neutral", "speeds": [[0, 1.0]]},
    {"path": [[0, 3], [0, -3]], "styles": [[0, "Zombie"], [3, "Old"]], "speeds": [[0, 0.9]], "seed": 2},
    {"path": [[-0.4, -3], [0.9, 3]], "styles": "BigSteps", "speeds": [[0, 1.0]], "seed": 3, "arms": False, "radius": 0.6},
]}


def test_those_who_keep_apart_walk_as_in_python(open_page, empty):
    """Prints how far the page is from plain Python in double precision; the scene keeps its fields, undone and saved."""
    scene, desk = tk.shots.Scene.parse(CROSSING), open_page(empty)
    before = desk.page.evaluate("() => view.desk.scene")
    desk.page.evaluate("(scene) => view.open(scene)", CROSSING)
    desk.wait()
    with torch.no_grad():
        clips = scene.render(*double())
    for k, clip in enumerate(clips):
        motion = desk.page.evaluate(f"() => view.desk.motion({k}).map(([root, q]) => [[...root], [...q]])")
        assert len(motion) == len(clip)
        off = apart(clip, motion)
        print(f"character {k}: {len(clip)} frames, root {off[:, 0].max():.6f} mm, joint {off[:, 1].max():.6f} mm")
        assert off.max() < 1.0
    alone = scene.shots[0].render(*tk.pretrained())
    assert float((clips[0].root_positions[:300] - alone.root_positions[:300]).norm(dim=-1).max()) > 0.1
    assert "All keep 0.9 m apart, or" in desk.page.locator(".tkd-say").inner_text()
    assert tk.shots.Scene.parse(desk.page.evaluate("() => view.desk.scene")) == scene
    desk.page.evaluate("() => view.desk.change((shots) => void (shots[0].path[0].x = -0.2))")
    desk.wait()
    with pytest.raises(Exception, match=r"shots\[0\] and shots\[1\] start 0.20 m from each other, closer than the 0.90 m"):
        desk.page.evaluate("() => view.desk.change((shots) => void Object.assign(shots[0].path[0], { x: 0.2, z: 3 }))")
    desk.press("Undo")
    desk.press("Undo")
    assert desk.page.evaluate("() => view.desk.scene") == before
    assert not desk.errors


def test_a_shot_is_made_by_hand(open_page, empty, tmp_path):
    desk = open_page(empty)
    page = desk.page
    desk.press("Draw the path with the next drag")
    way = [(2 * math.sin(k / 3), 0.5 * k) for k in range(11)]
    desk.drag(*(desk.at(x, z) for x, z in way))
    desk.wait()
    drawn = desk.shots[0].path
    assert 3 <= len(drawn) < 20
    assert math.hypot(drawn[-1].x - way[-1][0], drawn[-1].z - way[-1][1]) < 0.2

    desk.drag(desk.at(drawn[1].x, drawn[1].z), desk.at(drawn[1].x + 1, drawn[1].z))
    desk.wait()
    dragged = desk.shots[0].path
    assert dragged[1].x == pytest.approx(drawn[1].x + 1, abs=0.05)
    assert dragged[2:] == drawn[2:]
    page.keyboard.press("ArrowUp")  # the point has the focus
    assert desk.shots[0].path[1].z == pytest.approx(dragged[1].z + 0.1, abs=0.006)
    page.keyboard.press("Delete")
    assert len(desk.shots[0].path) == len(drawn) - 1

    for seconds, style in ((0, "Zombie"), (2, "Old"), (4, "Strut")):
        page.evaluate("(seconds) => view.seek(seconds)", seconds)
        desk.press("Add a style key at this time")
        page.get_by_label("Style 1", exact=True).select_option(style)
    keys = [(key.time, key.blend) for key in desk.shots[0].styles]
    assert keys == [(0, {"Zombie": 1}), (2, {"Old": 1}), (4, {"Strut": 1})]
    desk.press("Add a style to this blend")
    slider = page.locator(".tkd-mix input").first
    slider.fill("75")
    mixed = desk.shots[0].styles[2].blend
    assert mixed["Strut"] == pytest.approx(0.75)
    assert sum(mixed.values()) == pytest.approx(1)
    desk.press("Add a speed key at this time")
    page.get_by_label("speed, m/s").fill("1.1")
    page.get_by_label("speed, m/s").press("Enter")
    desk.press("Add a pause at this time")
    shot = desk.shots[0]
    assert [(key.time, key.speed) for key in shot.speeds] == [(4, 1.1)]
    assert [(hold.time, hold.seconds) for hold in shot.holds] == [(4, 1)]
    desk.wait()

    ruler = page.get_by_role("slider", name="Time").bounding_box()
    page.mouse.click(ruler["x"] + 0.5 * ruler["width"], ruler["y"] + 20)
    middle = page.evaluate("() => view.desk.seconds")
    count = page.evaluate("() => view.desk.takes[0].count")
    assert middle == pytest.approx(count / 120, rel=0.1)
    shown = page.evaluate("() => [...view.desk.pose(0, Math.round(view.desk.seconds * 60) - 1).root]")
    assert shown[2] > 0.5
    desk.press("Onion skin at this time, or away with it")
    desk.press("Play")
    page.wait_for_function("(before) => view.desk.seconds > before + 0.3", arg=middle)
    desk.press("Pause")

    key = page.get_by_role("button", name="Style key 2").bounding_box()  # keys are dragged in time
    desk.drag((key["x"] + key["width"] / 2, key["y"] + key["height"] / 2), (key["x"] + key["width"] / 2 + 40, key["y"] + 5))
    assert 2.1 < desk.shots[0].styles[1].time < 4
    moved = desk.shots
    page.keyboard.press("Control+z")
    assert desk.shots == [shot]
    page.keyboard.press("Control+Shift+z")
    assert desk.shots == moved
    for _ in range(30):
        page.keyboard.press("Control+z")
    assert desk.shots[0].path == director_start()
    assert page.get_by_role("button", name="Undo").is_disabled()
    for _ in range(30):
        page.keyboard.press("Control+y")
    assert desk.shots == moved
    desk.wait()

    desk.press("Add a character")
    assert [s.name for s in desk.shots] == ["shot 1", "shot 2"]
    page.get_by_role("tab", name="shot 1").click()
    desk.wait()
    page.wait_for_timeout(300)
    ARTEFACTS.mkdir(parents=True, exist_ok=True)
    page.screenshot(path=ARTEFACTS / "director.png")
    asked = desk.shots
    files = {}
    export = "Export the motion of this character as "
    for name in ("Save the shots as JSON", export + "GLB", export + "BVH"):
        with page.expect_download() as download:
            desk.press(name)
        files[name] = tmp_path / download.value.suggested_filename
        download.value.save_as(files[name])
    saved, glb, bvh = files.values()
    assert tk.shots.load(saved) == asked
    clips = [tk.load(glb), tk.load(bvh)]
    walked = asked[0].render(*tk.pretrained())
    for clip in clips:
        assert len(clip) == len(walked)
        assert (clip.root_positions - walked.root_positions).norm(dim=-1).max() < 0.03
    joints = [clips[0].skeleton.names.index(name) for name in walked.skeleton.names]
    assert (clips[0].global_positions[:, joints] - walked.global_positions).norm(dim=-1).max() < 0.05

    assert len(Character.load(glb).points) > 1000  # the mannequin's skin

    desk.press("Remove this character")
    with page.expect_file_chooser() as chooser:
        desk.press("Open a file of shots")
    chooser.value.set_files(saved)
    page.wait_for_function("() => view.desk.shots.length === 2")
    assert desk.shots == asked
    bad = tmp_path / "bad.json"
    bad.write_text('{"version": 1, "shots": [{"path": [[0, 0]], "styles": "Zombie"}]}')
    with page.expect_file_chooser() as chooser:
        desk.press("Open a file of shots")
    chooser.value.set_files(bad)
    page.get_by_text("bad.json: shots[0]: path: two or more points are needed, got 1").wait_for()
    assert desk.shots == asked
    assert desk.errors == []


def director_start() -> tuple:
    return tk.shots.Shot(director.START, "Neutral").path


def test_a_thumb_plans_on_a_phone(open_page, empty):
    desk = open_page(empty, "phone")
    page = desk.page
    touch = page.context.new_cdp_session(page)

    def drag(*points):
        kinds = ["touchStart", *["touchMove"] * (len(points) - 1)]
        for kind, (x, y) in zip(kinds, points, strict=True):
            touch.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [{"x": x, "y": y}]})
        page.wait_for_timeout(100)  # the finger rests; after a fling the browser ignores the next tap
        touch.send("Input.dispatchTouchEvent", {"type": "touchMove", "touchPoints": [{"x": x, "y": y}]})
        touch.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})

    before = desk.shots[0].path
    drag(*(desk.at(before[1].x + dx, before[1].z) for dx in (0, -0.5, -1)))
    assert desk.shots[0].path[1].x == pytest.approx(before[1].x - 1, abs=0.1)
    page.get_by_role("button", name="Draw the path").tap()
    drag(*(desk.at(-1 + 0.2 * k, 1 + 0.1 * k * k) for k in range(8)))
    assert desk.shots[0].path[0].x == pytest.approx(-1, abs=0.05)
    ruler = page.get_by_role("slider", name="Time").bounding_box()
    drag((ruler["x"] + 30, ruler["y"] + 10), (ruler["x"] + 120, ruler["y"] + 10))
    assert page.evaluate("() => view.desk.seconds") > 0.5
    page.get_by_role("button", name="Add a style key").tap()
    page.get_by_label("Style 1", exact=True).select_option("Zombie")
    assert len(desk.shots[0].styles) == 2
    desk.wait()
    page.evaluate("() => document.querySelector('.tkd').scrollTo(0, 0)")
    page.wait_for_timeout(300)
    page.screenshot(path=ARTEFACTS / "director-phone.png")
    boxes = [page.locator(name).bounding_box() for name in (".tkd-stage", ".tkd-map", ".tkd-time")]
    assert all(box["y"] + box["height"] <= SIZES["phone"]["height"] for box in boxes)  # seen without scrolling
    assert page.evaluate("() => document.documentElement.scrollWidth") == SIZES["phone"]["width"]
    assert desk.errors == []


BAD = (  # what both refuse, with the same words
    {"path": [[0, 0]]}, {"path": [[0, 0], [0, 0.001]]}, {"path": [[(-1) ** k * 900, k] for k in range(20)]},
    {"path": [[0, 0, 1], [0, 1]]}, {"path": [[0, 0], [0, 1, 2], [0, 2, 1]]}, {"styles": []},
    {"styles": [[0, "Neutral"], [0, "Old"]]}, {"facing": [1, 0], "look_at": [0, 1]}, {"speeds": [[1, 1], [1, 2]]},
    {"speeds": [[k / 10, 1] for k in range(1000)]},
)


def test_page_and_python_refuse_the_same_shots_in_the_same_words(open_page, empty):
    desk = open_page(empty)
    for bad in BAD:
        scene = {"version": 1, "shots": [{"path": [[0, 0], [0, 1]], "styles": "Neutral"} | bad]}
        with pytest.raises(ValueError, match=r"^shots\[0\]: ") as found:
            tk.shots.parse(scene)
        said = desk.page.evaluate("""(scene) => {
            try { view.open(scene); return "opened"; } catch (error) { return error.message; }
        }""", scene)
        assert said.split(", got")[0] == str(found.value).split(", got")[0]  # some of Python's say what they got


def test_a_change_computes_only_what_it_changes(open_page, empty):
    page = open_page(empty).page
    shot = {"path": [[0, 0], [1, 2], [-1, 3], [0, 4]], "styles": [[0, "Neutral"], [2, "Neutral"], [3, "Zombie"]],
            "speeds": [[0, 1.0], [3, 0.8]]}
    page.evaluate("(shot) => view.open({ version: 1, shots: [shot] })", shot)
    edits = ("shot.path[3].x = 1", "shot.styles[2].blend = { Old: 1 }", "shot.speeds[1].speed = 1.1", "shot.seed = 4",
             "shot.holds.push({ seconds: 1, time: 3, distance: null })", "shot.path[3].facing = [1, 0]",
             "shot.duration = 3", "shot.path[0].x = 0.1", "shot.path.splice(2, 1)")
    begun = []
    for edit in edits:
        page.evaluate("() => view.desk.motion(0)")
        page.wait_for_function(DONE, timeout=120_000)
        page.evaluate(f"() => view.desk.change(([shot]) => void ({edit}))")
        begun.append(page.evaluate("() => view.desk.stats.since"))
        same = page.evaluate("""() => {
            const { desk } = view, fresh = new desk.constructor(desk.data, desk.scene, () => {});
            return JSON.stringify(desk.motion(0)) === JSON.stringify(fresh.motion(0));
        }""")
        assert same, edit
    assert begun[0] > 60
    assert begun[1] > 90
    assert begun[3] == 0


def test_every_control_has_a_name(open_page, empty):
    desk = open_page(empty)
    page = desk.page
    for press in (None, "Add a style key at this time", "Add a speed key at this time", "Add a pause at this time",
                  "Add a point to the path"):
        if press == "Add a point to the path":
            page.locator(".tkd-map circle").last.focus()
            page.wait_for_timeout(100)
        if press:
            desk.press(press)
            page.wait_for_timeout(100)
        nameless = page.evaluate("""() => [...document.querySelectorAll(".tkd :is(button,select,input,[tabindex],[role])")]
            .filter((one) => !(one.ariaLabel || one.textContent.trim() || one.labels?.[0]?.textContent.trim()))
            .map((one) => one.outerHTML)""")
        assert nameless == []


START = """
import toolkit as tk
model, bank = tk.pretrained()
desk = tk.view.Director(model, bank, height=700)
desk
"""
PROBE = """
import asyncio, json, pathlib
async def probe():
    while True:
        ask = pathlib.Path("ask.json")
        if ask.exists():
            desk.shots = tk.shots.load(ask)
            ask.unlink()
        pathlib.Path("desk.tmp").write_text(json.dumps(desk.scene)); pathlib.Path("desk.tmp").rename("desk.json")
        await asyncio.sleep(0.2)
probing = asyncio.create_task(probe())
"""


def test_in_jupyterlab_the_kernel_has_the_shots(open_notebook, lab):
    notebook = open_notebook("director.ipynb", [START, PROBE, "len(desk.render())"])
    page, folder = notebook.page, lab[1]
    notebook.run_all(300)
    page.wait_for_function("() => document.querySelector('.tkd')?.parentElement.toolkit.stats.drawn > 0", timeout=120_000)
    page.evaluate("() => { globalThis.view = document.querySelector('.tkd').parentElement.toolkit; }")
    desk = page.locator(".tkd")
    desk.scroll_into_view_if_needed()
    point = page.locator(".tkd-map circle").nth(1).bounding_box()
    x, y = point["x"] + point["width"] / 2, point["y"] + point["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x - 50, y, steps=5)
    page.mouse.up()
    wanted = page.evaluate("() => view.desk.scene")
    assert wanted["shots"][0]["path"][1]["x"] > 0.7
    deadline = time.monotonic() + 60
    while tk.shots.parse(json.loads((folder / "desk.json").read_text())) != tk.shots.parse(wanted):
        assert time.monotonic() < deadline
        time.sleep(0.1)
    page.keyboard.press("Control+z")  # reaches the director, not the notebook
    assert page.evaluate("() => view.desk.shot.path[1].x") == 0.6
    asked = tk.shots.load(EXAMPLES / "two_who_meet.json")
    tk.shots.save(asked, folder / "ask.tmp")
    (folder / "ask.tmp").rename(folder / "ask.json")
    page.wait_for_function("() => view.desk.shots.length === 2")
    assert tk.shots.parse(page.evaluate("() => view.desk.scene")) == asked
    page.wait_for_function(DONE, timeout=120_000)
    page.wait_for_timeout(500)
    ARTEFACTS.mkdir(parents=True, exist_ok=True)
    desk.screenshot(path=ARTEFACTS / "director-lab.png")
    assert notebook.errors == []


OWN = """
import json, pathlib
import toolkit as tk
model, bank = tk.published.load("{data}")
shot = tk.shots.Shot([(0, 0), (0.6, 2)], [(0, "Neutral"), (2, "Zombie")], duration=4.0)
desk = tk.view.Director(model, bank, [shot], height=700, character="{hero}")
desk
# cell
pathlib.Path("{motion}").write_text(json.dumps(desk.render().root_positions.tolist()))
"""


def test_in_jupyterlab_the_published_model_moves_a_character_of_ones_own(open_notebook, lab, shared, tmp_path):
    hero, motion = tmp_path / "hero.glb", tmp_path / "motion.json"
    tk.export.gltf.save(rig("along y", arms=1.1, legs=0.85, hips=1.1, joints=with_twists), hero)
    cells = OWN.format(data=shared / "lpn_film_100style", hero=hero, motion=motion).split("# cell")
    notebook = open_notebook("own.ipynb", cells)
    page = notebook.page
    notebook.run_all(300)
    page.wait_for_function("() => document.querySelector('.tkd')?.parentElement.toolkit.stats.drawn > 0", timeout=120_000)
    page.evaluate("() => { globalThis.view = document.querySelector('.tkd').parentElement.toolkit; }")
    page.wait_for_function(DONE, timeout=120_000)
    page.evaluate("() => view.seek(3)")
    page.wait_for_timeout(500)
    walked = page.evaluate("() => view.desk.motion(0).map(([root]) => [...root])")
    assert len(walked) == 240
    assert torch.tensor(walked).allclose(torch.tensor(json.loads(motion.read_text())), atol=0.01)
    corners = page.evaluate("() => view.scene.body.position.count")
    assert corners == len(Character.load(hero).points)
    ARTEFACTS.mkdir(parents=True, exist_ok=True)
    page.locator(".tkd").scroll_into_view_if_needed()
    page.locator(".tkd").screenshot(path=ARTEFACTS / "director-own.png")
    assert notebook.errors == []
