"""The director in a page, by mouse, keys and touch; its courses and its motion are Python's."""

import copy
import dataclasses
import math

import numpy as np
import pytest
import torch

import toolkit as tk
from toolkit.extra import shots
from toolkit.extra.characters.character import Character
from toolkit.extra.shots import director, pins
from toolkit.networks.bank import StyleBank
from toolkit.runtime.recording import joined
from toolkit.view.pages import live_page

from .conftest import COMMENT, PLANTED, SIZES, drag, middle, shows_as_text, touches, visits

STARTED = "() => view.desk.making.every((take) => !take || take.frames.length)"
DONE = "() => !view.desk.making.some(Boolean) && view.desk.takes.every(Boolean)"
SHORT = {"version": 1, "shots": [{"path": [[0, 0], [0, 1], [0.6, 1.5]], "styles": "Neutral",
                                  "duration": 1.2}]}
ODD = {  # arrivals, pauses, easings, straight lines, facings, a style by layer, a point to look at
    "arrivals": {
        "path": [[0, 0], {"x": 0.5, "z": 1, "time": 1.5}, {"x": -1, "z": 2, "facing": [1, 0]}],
        "styles": [[0, "Neutral"], [0.5, {"Zombie": 0.5, "Old": 0.5}, "jump"], [1, "Strut", "in"]],
        "holds": [{"seconds": 1, "distance": 0.6}], "duration": 2, "seed": 5,
    },
    "looks": {
        "path": [[0, 0], [1, 0.5], [1, 1]], "smooth": False, "look_at": [0, 3], "arms": False,
        "styles": [[0, [{"Neutral": 1}, {"Zombie": 1}]], [1, "Old", "out"]],
        "speeds": [[0, 0.5, "smoother"], [1, 1.0]], "duration": 2,
    },
    "too fast": {"path": [[0, 0], [0, 2], [0.4, 2.2], [0, 0.5]], "styles": "Zombie",
                 "speeds": [[0, 2.5]], "duration": 1},
    "pinned": {
        "path": [[0, 0], [0, 1.5]], "styles": "Strut", "duration": 2, "pins": [
            {"at": 0.8, "right_hand": [-0.5, 1.3, 0.4], "look": [1, 1.2, 3]},
            {"at": 1.2, "to": 1.4, "left_hand": [0.5, 0.7, 0.7]},
            {"at": 1.8, "right_foot": [-0.1, 0.3, 1.2], "left_hand": [3, 1, 0]},
            {"at": 1.1, "pose": {"Chest": [0.924, 0.383, 0, 0], "Hips": [1, 0, 0, 0]}}],
    },
}
CROSSING = {
    "version": 1, "apart": 0.9, "walls": [[[1.2, -3], [1.2, 3]]],
    "shots": [
        {"path": [[-1.2, 0], [0, 0.1], [0.6, 0.5]], "styles": "Neutral", "speeds": [[0, 1.0]],
         "duration": 1},
        {"path": [[0, 1.2], [0, -1]], "styles": [[0, "Zombie"], [0.5, "Old"]], "speeds": [[0, 0.9]],
         "seed": 2, "duration": 1},
    ],
}
FRESH = """() => {
    const { desk } = view;
    globalThis.fresh ??= new desk.constructor(desk.data, desk.scene, () => {});
    fresh.open(desk.scene);  // of what was open, nothing is kept
    const { since } = fresh.stats, motions = [desk, fresh].map((one) => one.motion(0));
    return since === 0 && JSON.stringify(motions[0]) === JSON.stringify(motions[1]);
}"""
NAMELESS = """() => [...document.querySelectorAll(
    ".tkd :is(button,select,input,[tabindex],[role])")].filter((one) =>
    !(one.ariaLabel || one.textContent.trim()
        || one.labels?.[0]?.textContent.trim())).map((one) => one.outerHTML)"""
FRAMES = """() => new Promise((done) =>
    requestAnimationFrame(() => requestAnimationFrame(done)))"""


class Desk:
    """An open page."""

    def __init__(self, page):
        self.page = page
        page.wait_for_function("() => globalThis.view?.stats.drawn > 0", timeout=120_000)
        self.wait()

    def wait(self, until: str = STARTED) -> None:
        """By default for the plans; the motion takes longer."""
        self.page.wait_for_function(until, timeout=120_000)
        self.page.evaluate(FRAMES)

    def run(self, what: str):
        """Call or look at something of the page's view."""
        return self.page.evaluate(f"() => view.{what}")

    def open(self, scene: dict, until: str = STARTED) -> None:
        self.page.evaluate("(scene) => view.open(scene)", scene)
        self.wait(until)

    @property
    def shots(self) -> list:
        return tk.shots.parse(self.run("desk.scene"))

    def clip(self, k: int = 0) -> tk.Clip:
        """The motion of a character."""
        motion = self.page.evaluate("""(k) => view.desk.motion(k).map(
            (parts) => parts.map((part) => [...part]))""", k)
        root, turns = (torch.tensor(part, dtype=torch.float64)
                       for part in zip(*motion, strict=True))
        skeleton = tk.pretrained().model.layout.skeleton
        return tk.Clip(skeleton, turns.unflatten(-1, (-1, 4)), root, 60)

    def at(self, x: float, z: float) -> tuple[float, float]:
        """Where a place of the floor is on the screen."""
        box = self.page.locator(".tkd-map").bounding_box()
        dx, dy = self.page.evaluate("(place) => view.map.out(place)", [x, z])
        return box["x"] + dx, box["y"] + dy

    def press(self, name: str) -> None:
        """Click on a button and wait for the form, which is drawn with the next frame."""
        self.page.get_by_role("button", name=name, exact=True).click()
        self.page.evaluate(FRAMES)


def alive() -> tuple:
    """The embedded model and its bank; the style of each shot wanders."""
    model, bank = tk.pretrained()
    model = copy.deepcopy(model)
    model.life = 0.1
    return model, bank


@pytest.fixture(scope="module")
def file(pages):
    """A page with a short shot, opened by every test here, whose style Aeroplane is marked; the
    last styles have planted names.
    """
    model, bank = alive()
    count, names = len(bank), (*bank, *PLANTED)
    at = [*range(count), 0, 0, 0]
    bank = StyleBank(names, bank.vectors[at], bank.speeds[at], [k == "Aeroplane" for k in names])
    return director.web(model, bank, pages / "director.html", tk.shots.parse(SHORT), title=COMMENT)


@pytest.fixture(scope="module")
def opened(browser, file):
    with visits(browser) as visit:
        yield Desk(visit(file))


@pytest.fixture
def desk(opened):
    """The page, with the short shot."""
    opened.open(SHORT)
    return opened


@pytest.fixture(scope="module")
def double() -> tuple:
    model, bank = alive()
    precise = dataclasses.replace(bank, vectors=bank.vectors.double())
    return model.double(), precise


def apart(clip: tk.Clip, other: tk.Clip) -> float:
    """Distance of the farthest joint, mm."""
    return 1e3 * float((other.global_positions - clip.global_positions).norm(dim=-1).max())


def test_the_same_shots_give_the_same_courses_motion_and_words(desk, double):
    shots = tk.shots.parse({"version": 1, "shots": [ODD[name] | {"name": name} for name in ODD]})
    scene = tk.shots.Scene(shots)
    desk.open(tk.shots.data(scene), DONE)
    assert desk.shots == shots
    found = desk.page.evaluate("""() => view.desk.takes.map(({ course, heading }) => ({
        x: course.curve.x, z: course.curve.z, at: course.curve.at, knots: course.curve.knots,
        late: course.late, distance: course.distance, speed: course.speed,
        angles: course.distance.map((d) => heading.angle(d, [0.3, 0.2])) }))""")
    model, bank = double
    states, words = list(scene.states(model, bank)), []
    for k, (shot, seen) in enumerate(zip(shots, found, strict=True)):
        course, heading = plan = shot.plan(bank)
        curve = course.curve
        expected = {
            "x": curve.x, "z": curve.z, "at": curve.at, "knots": curve.knots, "late": course.late,
            "distance": course.distance, "speed": course.speed,
            "angles": [heading.angle(d, (0.3, 0.2)) for d in course.distance],
        }
        for what, values in expected.items():
            assert seen[what] == pytest.approx(values, abs=1e-9), (shot.name, what)
        walked = joined(states[: len(course.distance) - 1], k)
        clip = shot.drawn(model, walked, course)
        assert apart(clip, desk.clip(k)) < 1.0, shot.name
        lines = shot.unmet(bank, plan, [tuple(place) for place in walked.root[:, :2].tolist()])
        words += [f"{shot.name}: {line}" for line in lines + pins.missed(shot.pins, clip)]
    said = desk.page.locator(".tkd-say p").all_text_contents()
    assert said == words
    assert sum(line.startswith("too fast: ") for line in said) > 1
    assert sum(line.startswith("pinned: ") for line in said) > 0


def test_what_is_named_like_html_is_shown_as_text(desk):
    desk.open(tk.shots.data([tk.shots.Shot([(k, 0), (k, 0.5)], text, duration=0.5, name=text)
                             for k, text in enumerate(PLANTED)]), DONE)
    assert desk.page.get_by_role("tab").all_text_contents() == list(PLANTED)
    shows_as_text(desk.page)


def test_those_who_keep_apart_walk_as_in_python(desk, double):
    scene = tk.shots.Scene.parse(CROSSING)
    before = desk.run("desk.scene")
    desk.open(CROSSING, DONE)
    with torch.no_grad():
        clips = scene.render(*double)
    for k, clip in enumerate(clips):
        assert apart(clip, desk.clip(k)) < 1.0
    assert "All keep 0.9 m apart, or" in desk.page.locator(".tkd-say").inner_text()
    assert tk.shots.Scene.parse(desk.run("desk.scene")) == scene
    near = "Object.assign(shots[0].path[0], { x: 0.2, z: 1.2 })"
    with pytest.raises(Exception, match=r"start 0.20 m from each other, closer than the 0.90 m"):
        desk.page.evaluate(f"() => view.desk.change((shots) => void {near})")
    desk.press("Undo")
    assert desk.run("desk.scene") == before


def test_of_another_model_the_page_plays_what_the_kernel_renders(desk, double):
    """The embedded model's motion, but the page has no network."""
    scene = SHORT | {"shots": [ODD["pinned"]]}
    desk.open(scene, DONE)
    (clip,) = shots.Scene.parse(scene).render(*double)
    motion = {"scene": scene, "takes": [live_page.numbers(director.frames(clip))]}
    found = desk.page.evaluate("""([motion, other]) => {
        const { desk } = view, data = { ...desk.data, network: null };
        const one = new desk.constructor(data, desk.scene, () => {}), waits = [one.pose(0, 0)];
        let refused = [];
        for (const act of [() => one.motion(0), () => one.filled({ ...motion, problem: "bad" })])
            try { act(); } catch ({ message }) { refused.push(message); }
        one.filled({ ...motion, scene: other });
        waits.push(one.making.length);
        one.filled(motion);
        const frames = one.motion(0).length, joints = one.joints(0, 60), pins = one.missedPins(0);
        const gap = one.takes[0].apart.map((v, f) => Math.abs(v - desk.takes[0].apart[f]));
        one.change(([shot]) => void (shot.path[1].x = 2));  // the old motion on the new plan
        const { course: { curve }, places } = one.take(0);
        waits.push(one.making[0] === one.take(0), places.length, curve.point(curve.length)[0]);
        return { waits, refused, frames, joints, pins, own: desk.missedPins(0),
                 gap: Math.max(...gap) };
    }""", [motion, scene | {"shots": [ODD["looks"]]}])
    assert found["waits"] == [None, 1, True, len(clip), pytest.approx(2)]
    assert found["refused"] == ["the kernel has not rendered it yet", "bad"]
    assert found["frames"] == len(clip)
    assert np.array(found["joints"]) == pytest.approx(clip.global_positions[60].numpy(), abs=1e-5)
    assert found["pins"] == found["own"]
    assert found["gap"] < 0.1  # the hips beside the root


def test_a_path_is_drawn_and_its_points_are_dragged(desk):
    page = desk.page
    desk.press("Draw the path with the next drag")
    way = [(math.sin(k / 3), 0.25 * k) for k in range(9)]
    drag(page, *(desk.at(x, z) for x, z in way))
    desk.wait()
    drawn = desk.shots[0].path
    assert 3 <= len(drawn) < 20
    assert math.hypot(drawn[-1].x - way[-1][0], drawn[-1].z - way[-1][1]) < 0.2
    drag(page, desk.at(drawn[1].x, drawn[1].z), desk.at(drawn[1].x + 0.5, drawn[1].z))
    dragged = desk.shots[0].path
    assert dragged[1].x == pytest.approx(drawn[1].x + 0.5, abs=0.05)
    assert dragged[2:] == drawn[2:]
    page.keyboard.press("ArrowUp")  # the point has the focus
    assert desk.shots[0].path[1].z == pytest.approx(dragged[1].z + 0.1, abs=0.006)
    page.keyboard.press("Delete")
    assert len(desk.shots[0].path) == len(drawn) - 1
    cut = desk.shots
    for _ in range(4):
        page.keyboard.press("Control+z")
    assert desk.shots == tk.shots.parse(SHORT)
    for _ in range(4):
        page.keyboard.press("Control+y")
    assert desk.shots == cut


def test_styles_speeds_and_pauses_are_keyed(desk):
    page = desk.page
    for seconds, style in ((0, "Zombie"), (0.6, "Old")):
        page.evaluate("(seconds) => view.seek(seconds)", seconds)
        desk.press("Add a style key at this time")
        page.get_by_label("Style 1", exact=True).select_option(style)
    keys = [(key.time, key.blend) for key in desk.shots[0].styles]
    assert keys == [(0, {"Zombie": 1}), (0.6, {"Old": 1})]
    shown = page.get_by_label("Style 1", exact=True).locator("option").all_text_contents()
    assert [name for name in shown if "broken" in name] == ["Aeroplane (broken)"]
    desk.press("Add a style to this blend")
    page.locator(".tkd-mix input").first.fill("75")
    assert desk.shots[0].styles[1].blend["Old"] == pytest.approx(0.75)
    desk.press("Add a speed key at this time")
    page.get_by_label("speed, m/s").fill("1.1")
    page.get_by_label("speed, m/s").press("Enter")
    desk.press("Add a pause at this time")
    (shot,) = desk.shots
    assert [(key.time, key.speed) for key in shot.speeds] == [(0.6, 1.1)]
    assert [(hold.time, hold.seconds) for hold in shot.holds] == [(0.6, 1)]
    desk.wait()

    page.mouse.click(*middle(page.get_by_role("slider", name="Time")))
    half = desk.run("desk.seconds")
    assert half == pytest.approx(desk.run("desk.take(0).count") / 120, rel=0.1)
    desk.press("Onion skin at this time, or away with it")
    desk.press("Play")
    page.wait_for_function("""(before) => view.desk.seconds > before + 0.2
        && (document.querySelector("[aria-label=Pause]")?.click(), true)""", arg=half)
    page.get_by_role("button", name="Play", exact=True).wait_for()
    key = page.get_by_role("button", name="Style key 2")
    drag(page, middle(key), middle(key, 40))  # in time
    assert 0.62 < desk.shots[0].styles[1].time < 1.2
    assert page.evaluate(NAMELESS) == []


def test_a_pin_is_added_dragged_and_reached(desk):
    page = desk.page
    desk.open({"version": 1, "shots": [{"path": [[0, 0], [0, 1.5]], "styles": "Strut",
                                         "duration": 1.6}]})
    desk.run("seek(1)")
    desk.press("Add a pin at this time")
    page.get_by_label("y, m").fill("1.3")
    page.get_by_label("y, m").press("Enter")
    (pin,) = desk.shots[0].pins
    x, z = pin.right_hand[0], pin.right_hand[2]
    (left, top), (to_left, to_top) = desk.at(x, z), desk.at(x - 0.3, z + 0.2)
    drag(page, (left, top - 9), (left + 5, top - 20), (to_left, to_top - 9))
    key = page.get_by_role("button", name=f"Pin 1 at {pin.at:.2f} s, right hand")
    drag(page, middle(key), middle(key, 155))
    desk.wait(DONE)
    (pin,) = desk.shots[0].pins
    assert pin.right_hand == pytest.approx((x - 0.3, 1.3, z + 0.2), abs=0.05)
    assert pin.at > 1.1
    hand = page.evaluate("""(at) => {
        const { desk } = view;
        return desk.joints(0, Math.round(at * 60) - 1)[desk.data.figure.arms[0][2]];
    }""", pin.at)
    assert hand == pytest.approx(pin.right_hand, abs=0.02)
    assert page.evaluate(NAMELESS) == []
    page.get_by_label("pins").select_option("look")
    assert desk.shots[0].pins[0].look == pin.right_hand
    desk.press("Delete this pin")
    assert desk.shots[0].pins == ()


def test_a_shot_is_mirrored_reversed_cut_and_joined(desk):
    plan = {"path": [[0, 0], [0, 1], [0.5, 1.5]], "styles": [[0, "Neutral"], [0.8, "Old", "in"]],
            "holds": [{"seconds": 0.2, "distance": 0.5}],
            "pins": [{"at": 0.5, "left_hand": [0.5, 1, 0.5]}]}
    two = {"version": 1, "shots": [plan, {"path": [[5, 5], [5.3, 5]], "styles": "Zombie"}]}
    desk.open(two)
    before = desk.shots[0]
    desk.press("Mirror this shot: left and right change places")
    (shot, _) = desk.shots
    assert [(p.x, p.z) for p in shot.path] == [(0, 0), (0, 1), (-0.5, 1.5)]
    assert (shot.pins[0].right_hand, shot.pins[0].left_hand) == ((-0.5, 1, 0.5), None)
    desk.press("Mirror this shot: left and right change places")
    assert desk.shots[0] == before
    desk.wait()
    end = desk.run("desk.take(0).course.end")
    desk.press("Walk the path from its end to its start")
    (shot, _) = desk.shots
    assert [(p.x, p.z) for p in shot.path] == [(0.5, 1.5), (0, 1), (0, 0)]
    assert [list(key.blend) for key in shot.styles] == [["Old"], ["Neutral"]]
    assert [key.time for key in shot.styles] == pytest.approx([end - 0.8, end], abs=2e-3)
    assert shot.styles[0].easing == "smooth"
    assert shot.pins[0].at == pytest.approx(end - 0.5, abs=2e-3)

    desk.open(two)
    desk.run("seek(0.4)")
    half = desk.run("desk.take(0).course.distance[24]")
    desk.press("Cut off what is before this time")
    (shot, _) = desk.shots
    assert (shot.path[0].x, shot.path[0].z) == pytest.approx((0, half), abs=0.05)
    assert [key.time for key in shot.styles] == [0, 0.4]
    assert shot.pins[0].at == 0.1
    assert shot.styles[0].blend == pytest.approx({"Neutral": 0.5, "Old": 0.5})
    assert shot.holds[0].distance == pytest.approx(0.5 - half, abs=1e-3)
    desk.wait()
    end = desk.run("desk.take(0).course.end")
    desk.press("Put the shot of the next character at the end of this one")
    (joined,) = desk.shots
    assert joined.path[: len(shot.path)] == shot.path
    ahead = [joined.path[-1].x - 0.5, joined.path[-1].z - 1.5]  # from where the first shot ends
    assert math.hypot(*ahead) == pytest.approx(0.3, abs=1e-3)
    assert min(ahead) > 0.1
    assert joined.styles[-1].time == pytest.approx(end, abs=2e-3)
    assert joined.styles[-1].blend == {"Zombie": 1}
    desk.press("Put the shot of the next character at the end of this one")
    said = desk.page.get_by_role("status", name="What cannot be met")
    assert "no next one" in said.inner_text()


def test_shots_and_motion_are_saved_and_opened(desk, tmp_path):
    page = desk.page
    desk.press("Add a character")
    assert [s.name for s in desk.shots][1:] == ["shot 2"]
    page.get_by_role("tab").first.click()
    asked, walked, files = desk.shots, desk.clip(), []
    export = "Export the motion of this character as "
    for name in ("Save the shots as JSON", export + "GLB", export + "BVH"):
        with page.expect_download() as download:
            desk.press(name)
        files.append(tmp_path / download.value.suggested_filename)
        download.value.save_as(files[-1])
    saved, glb, bvh = files
    assert list(tk.shots.Scene.load(saved).shots) == asked
    for path in (glb, bvh):
        clip = tk.load(path)
        joints = [clip.skeleton.names.index(name) for name in walked.skeleton.names]
        torch.testing.assert_close(clip.global_positions[:, joints].double(),
                                   walked.global_positions, atol=1e-3, rtol=0)
    assert len(Character.load(glb).points) > 1000  # the mannequin's skin

    desk.press("Remove this character")
    bad = tmp_path / "bad.json"
    bad.write_text('{"version": 1, "shots": [{"path": [[0, 0]], "styles": "Zombie"}]}')
    for path in (saved, bad):
        with page.expect_file_chooser() as chooser:
            desk.press("Open a file of shots")
        chooser.value.set_files(path)
        page.wait_for_function("() => view.desk.shots.length === 2")
    said = "bad.json: shots[0]: path: two or more points are needed, got 1"
    page.get_by_text(said).wait_for()
    assert desk.shots == asked


def test_a_thumb_plans_on_a_phone(visit, file):
    desk = Desk(visit(file, "phone"))
    page = desk.page
    send = touches(page)

    def drag(*points):
        for kind, point in zip(["touchStart", *["touchMove"] * len(points)], points, strict=False):
            send(kind, point)
        page.wait_for_timeout(100)  # after a fling the browser would ignore the next tap
        send("touchMove", points[-1])
        send("touchEnd")

    before = desk.shots[0].path
    drag(*(desk.at(before[1].x + dx, before[1].z) for dx in (0, -0.3, -0.6)))
    assert desk.shots[0].path[1].x == pytest.approx(before[1].x - 0.6, abs=0.1)
    page.get_by_role("button", name="Draw the path").tap()
    drag(*(desk.at(-0.5 + 0.15 * k, 0.3 + 0.03 * k * k) for k in range(8)))
    assert desk.shots[0].path[0].x == pytest.approx(-0.5, abs=0.05)
    ruler = page.get_by_role("slider", name="Time").bounding_box()
    drag((ruler["x"] + 30, ruler["y"] + 10), (ruler["x"] + 120, ruler["y"] + 10))
    assert desk.run("desk.seconds") > 0.2
    page.get_by_role("button", name="Add a style key").tap()
    page.get_by_label("Style 1", exact=True).select_option("Zombie")
    assert len(desk.shots[0].styles) == 2
    page.evaluate("() => document.querySelector('.tkd').scrollTo(0, 0)")
    for name in (".tkd-stage", ".tkd-map", ".tkd-time"):  # seen without scrolling
        box = page.locator(name).bounding_box()
        assert box["y"] + box["height"] <= SIZES["phone"]["height"]
    assert page.evaluate("() => document.documentElement.scrollWidth") == SIZES["phone"]["width"]


def test_a_change_computes_only_what_it_changes(desk):
    shot = {"path": [[0, 0], [1, 2], [-1, 3], [0, 4]], "duration": 1.5,
            "styles": [[0, "Neutral"], [0.5, "Neutral"], [1, "Zombie"]],
            "speeds": [[0, 2.0], [1, 1.6]]}
    desk.open({"version": 1, "shots": [shot]})
    edits = {"shot.arms = false": 60, "shot.path[3].x = 1": 60,
             "shot.styles[2].blend = { Old: 1 }": 30, "shot.speeds[1].speed = 1.1": 0,
             "shot.seed = 4": 0}
    for edit, least in edits.items():
        desk.run("desk.motion(0)")
        desk.wait()
        desk.page.evaluate(f"() => view.desk.change(([shot]) => void ({edit}))")
        since = desk.run("desk.stats.since")
        assert since >= least, edit
        assert desk.page.evaluate(FRESH), edit
    assert since == 0


def test_defects_are_those_of_python_and_red_on_the_timeline(desk):
    near = {"version": 1, "shots": [
        {"path": [[0, 0], [0, 1]], "styles": "Neutral", "duration": 2},
        {"path": [[0.3, 1.5], [0.3, 0.5], [1.5, 0.5]], "styles": "WideLegs", "duration": 2,
         "name": "wide"}]}
    desk.open(near)
    desk.page.wait_for_function("() => view.desk.findings", timeout=60_000)
    found = desk.run("desk.findings")
    expected = tk.evaluation.defects([desk.clip(0), desk.clip(1)])
    assert {one["kind"] for one in found} >= {"body", "pop", "floor"}
    assert {one["joint"] for one in found} > {"left_toe", "limb and limb of 0 and 1"}
    assert [(one["kind"], one["joint"]) for one in found] == [
        (one.kind, one.joint) for one in expected]
    for what in ("start", "end", "value"):
        assert [one[what] for one in found] == pytest.approx(
            [getattr(one, what) for one in expected], abs=2e-3, rel=1e-5)
    desk.page.evaluate(FRAMES)
    for who, tab in enumerate(("shot", "wide")):
        desk.page.get_by_role("tab", name=tab, exact=True).click()
        desk.page.evaluate(FRAMES)
        shown = sum(one.character == who or "of 0" in one.joint for one in expected)
        assert 0 < shown == desk.page.locator(".defect").count()
    assert " s, " in desk.page.locator(".defect title").first.inner_html()
    assert desk.page.locator(".tkd-found").inner_text().startswith("Defects: ")
