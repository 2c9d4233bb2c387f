import json
import math
import re
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import torch
from hypothesis import given, strategies as st
from refusal import refusal

import toolkit as tk
from toolkit.extra.shots import Scene, Shot, apart, crowd, feasibility, pins, reaching
from toolkit.extra.shots.feasibility import arrival, beside
from toolkit.extra.shots.following import FPS, Course, Curve, nearest
from toolkit.extra.shots.scene import _aimed, _limited

S_PATH = Shot([(0, 0), (1, 2, 2.5), (-1, 4), (0, 6, 7.0)],
              [(0, "Neutral"), (2, "Neutral"), (3, {"Zombie": 0.5, "Neutral": 0.5})])


@pytest.fixture(autouse=True)
def short_tries(monkeypatch):
    """Styles are tried in walks of a third of the length, so that a test is short."""
    monkeypatch.setattr("toolkit.extra.shots.scene.TRIED", 60)


times = st.lists(st.floats(0, 100), min_size=1, max_size=5, unique=True).map(sorted)


@st.composite
def some_shots(draw):
    steps = draw(st.lists(st.tuples(st.floats(-3, 3), st.floats(0.02, 5)), min_size=1, max_size=6))
    points = np.cumsum([(0.0, 0.0), *steps], axis=0).tolist()
    easing = st.sampled_from(["smooth", "linear", "jump"])
    facing, duration = draw(st.sampled_from([None, (0.0, 1.0)])), draw(st.sampled_from([None, 3.0]))
    return Shot(points,
                [(t, draw(st.sampled_from(["Neutral", "Zombie"])), draw(easing))
                 for t in draw(times)],
                [(t, draw(st.floats(0, 3)), draw(easing)) for t in draw(times)],
                [{"seconds": 1.0, "time": t} for t in draw(times)], smooth=draw(st.booleans()),
                seed=draw(st.integers(0, 99)), facing=facing, duration=duration)


@given(some_shots())
def test_a_shot_survives_its_file(tmp_path_factory, shot):
    path = tmp_path_factory.mktemp("shots") / "shot.json"
    shot.save(path)
    assert Shot.load(path) == shot
    tk.shots.save([shot, S_PATH], path)
    assert Scene.load(path) == Scene([shot, S_PATH])
    with refusal("holds 2 shots"):
        Shot.load(path)


@given(some_shots())
def test_a_plan_is_finite_and_never_goes_back(shot):
    course, heading = shot.plan()
    assert course.distance == sorted(course.distance)
    assert 0 == course.distance[0] <= course.distance[-1] <= course.curve.length
    assert len(course.distance) == len(course.speed)
    assert all(map(math.isfinite, course.speed))
    assert all(math.isfinite(heading.angle(at, (1.0, 1.0))) for at in course.distance[::60])


MEET = [Shot([(0, 0), (0, 2)], "Neutral"), Shot([(0.05, 2), (0.05, 0)], "Strut", seed=1)]


def test_those_who_keep_apart_do_and_the_others_walk_through_each_other(tmp_path, fast):
    path = tmp_path / "scene.json"
    nearest = []
    for scene in (Scene(MEET), Scene(MEET, 1.0, [((-3, 1), (-2, 1))])):
        tk.shots.save(scene, path)
        assert Scene.load(path) == scene
        places = torch.stack([s.root[:, :2] for s in scene.states(*fast)])
        nearest.append(float((places[:, 0] - places[:, 1]).norm(dim=-1).min()))
        assert (places[-1] - torch.tensor([[0.0, 2.0], [0.05, 0.0]])).norm(dim=-1).max() < 0.3
    assert nearest[0] < 0.3
    assert nearest[1] > 0.6


def test_bodies_keep_apart_by_the_reach_of_their_styles(fast):
    model, bank = fast
    arms = Scene([replace(MEET[0], styles="Aeroplane"), MEET[1]], 1.0)
    scene, nearest = arms.spaced(model, bank, bodies=0.4), []
    for each in (arms, scene):
        places = torch.stack([tk.runtime.world_joints(state.joints, state.root)["position"]
                              for state in list(each.states(model, bank))[::5]])
        nearest.append(float(torch.cdist(places[:, 0], places[:, 1]).min()))
    assert nearest[0] < 0.25 < 0.3 < nearest[1]
    (line,) = arms.check(model, bank)
    assert "its limbs may go through others; `shot --bodies" in line
    assert scene.check(model, bank) == []
    for shot, radius in zip(arms.shots, scene.radii, strict=True):  # in a walk straight ahead
        style = shot.styles[0].layers[0]
        state, reach = tk.runtime.start(model, bank.blend(style)), []
        for _ in range(59):
            state = tk.runtime.step(model, state, tk.runtime.Command((0.0, bank.speed(style))))
            joints = tk.runtime.world_joints(state.joints, state.root)["position"][0, :, [0, 2]]
            reach.append(float((joints - state.root[0, :2]).norm(dim=-1).max()))
        assert radius == pytest.approx(max(reach[20:]) + 0.2, abs=0.0051)
        assert radius == round(radius, 2)
    assert scene.radii[0] > scene.radii[1] + 0.2  # outstretched arms


@pytest.mark.parametrize(("wide", "said"),
                         [(0.9, "too narrow, characters keep 0.5 m"), (1.8, "too narrow for two"),
                          (2.1, None)])
def test_check_names_a_gate_that_is_too_narrow(fast, wide, said):
    walls = [((-3, 1), (-wide / 2, 1)), ((wide / 2, 1), (3, 1))]
    lines = Scene(MEET, 1.0, walls)._gaps(fast[1])
    assert [said in line for line in lines] == ([True] if said else [])
    assert all(line.startswith(f"between walls[0] and walls[1] are {wide:.2f} m") for line in lines)


def test_check_names_ends_that_are_too_close(fast):
    near = [replace(MEET[0], name="first"),
            Shot([(5, 0), (MEET[0].path[-1].x + 0.6, MEET[0].path[-1].z)], "Neutral")]
    (line,) = Scene(near, 0.7).check(*fast)
    assert line.endswith("end 0.60 m apart and keep 0.70 m: they do not both arrive")


def test_check_names_a_gate_to_which_too_many_come_at_once(fast):
    def at(x, z):  # turned by 45 degrees
        return 0.5**0.5 * (x - z), 0.5**0.5 * (x + z)

    walls = [(at(-9, 2), at(-1.2, 2)), (at(1.2, 2), at(9, 2))]
    places = [(1.5 * k - 3, z) for z in (-1, -3) for k in range(5)]
    many = [Shot([at(x, z), at(0, 2), at(x, 8 + z)], "Neutral", [(0, 0.6)]) for x, z in places]
    (line,) = Scene(many, 1.2, walls).check(*fast)
    assert "those who come at once would wait for up to" in line
    later = [replace(shot, holds=[{"seconds": 1.5 * k, "time": 0}])
             for k, shot in enumerate(many)]
    beside = [replace(shot, path=(shot.path[0], at(1.3, 2), shot.path[2]))
              for shot in many]  # not through the gate
    for shots in (later, beside):
        assert Scene(shots, 1.2, walls)._gaps(fast[1]) == []


def test_radius_of_a_circle_and_ways_of_neighbours_on_rings():
    circle = [(3 * math.sin(0.2 * k), 3 * math.cos(0.2 * k)) for k in range(16)]
    found = feasibility.radius(SimpleNamespace(curve=Curve(circle, smooth=True)), 4.0)
    assert found == pytest.approx(3.0, rel=0.02)
    rings, _, ways = crowd.places(30)
    kinds = sorted(set(zip(rings.tolist(), ways.tolist(), strict=True)))
    assert [way for _, way in kinds] == [(-1.0) ** k for k in range(len(kinds))]
    assert len(kinds) > 1


def test_velocities_of_those_who_keep_apart():
    places, ahead = np.array([[0.0, 0.0], [0.0, 2.0]]), np.array([[0.0, 1.0], [0.0, -1.0]])
    none, alike = np.zeros((0, 2, 2)), np.array([0.4, 0.4])
    safe = apart.velocities(places, ahead, ahead, alike, none, 0.5)
    assert safe[0, 0] * safe[1, 0] < 0  # each to its own side
    assert np.allclose(safe[0], -safe[1])
    turn = np.array([[0.6, 0.8], [-0.8, 0.6]])  # the axes do not matter
    turned = apart.velocities(places @ turn, ahead @ turn, ahead @ turn, alike, none, 0.5)
    assert np.allclose(turned, safe @ turn)
    wide = apart.velocities(places, ahead, ahead, np.array([0.3, 0.9]), none, 0.5)
    assert abs(wide[0, 0]) > abs(safe[0, 0])
    # they part: nothing to do
    assert np.allclose(apart.velocities(places, ahead, -ahead, alike, none, 0.5), -ahead)
    near = apart.velocities(places / 2, ahead, ahead, alike, none, 0.5)
    assert near[0, 0] < -0.5 < 0.5 < near[1, 0]  # both to their right
    walls = np.array([[[-5.0, 0.6], [5.0, 0.6]]])
    alone = apart.velocities(places[:1], ahead[:1], ahead[:1], alike[:1], walls, 0.5)
    assert alone[0, 1] < 0.11


@given(st.integers(2, 60), st.integers(0, 999))
def test_a_dense_crowd_that_moves_a_frame_keeps_its_distance(characters, seed):
    """On a grid as dense as it may be, each moves by up to 3 cm."""
    rng, radii = np.random.default_rng(seed), np.full(characters, 0.35)
    grid = 0.7 * np.stack(np.divmod(np.arange(characters), 8), -1)
    moved = grid + rng.uniform(-0.03, 0.03, grid.shape)
    parted = apart.parted(moved, radii, np.zeros((0, 2, 2)), 0.5)
    distance = np.linalg.norm(parted[:, None] - parted, axis=-1) + np.eye(characters)
    assert distance.min() >= 0.7
    assert np.linalg.norm(parted - moved, axis=-1).max() < 0.15
    far = 3 * grid  # nobody is too close
    assert np.array_equal(apart.parted(far, radii, np.zeros((0, 2, 2)), 0.5), far)


def test_those_who_make_room_do_not_go_back():
    course = Shot([(0, 0), (0, 9)], "Neutral", [(0, 1.0)]).plan(tk.pretrained().bank)[0]
    for asked, wanted in (((0.0, -1.0), (0.0, 0.0)), ((0.8, 0.5), (0.0, 0.5))):
        assert _aimed(course, 60, (0.0, 1.0), np.array(asked))[0] == pytest.approx(wanted)


@pytest.mark.parametrize(("limbs", "place"), [
    ({"left_hand": (0.15, 1.2, 2)}, (0, 1.5)),  # within reach
    ({"left_hand": (2.1, 1.2, 2)}, None),  # too far to be walked to
    ({"right_hand": (0.6, 1.2, 2)}, (0.95, 1.5)),  # on the wrong side
    ({"left_hand": (1.0, 1.2, 2)}, (0.65, 1.5)),  # too far
    ({"left_hand": (0.9, 1.2, 2), "right_hand": (0.5, 1.2, 2)}, (0.7, 1.5)),
    ({"left_foot": (0.2, 0.3, 2)}, (0.1, 1.7)),
])
def test_places_out_of_reach_move_the_path_to_a_step_before_them(limbs, place):
    held = Shot([(0, 0), (0, 4)], "Neutral", pins=[{"at": 2} | limbs], facing=(0, 1))
    course = held.plan(tk.pretrained().bank)[0]
    stops = [course.curve.point(at) for _, at, _ in course.arrivals]
    assert stops == ([pytest.approx(place)] if place else [])
    straight = max(map(abs, course.curve.x)) < 1e-9
    assert straight == (not place or place[0] == 0)


def test_places_near_a_wall_move_off_it():
    walls = np.array([[[-5.0, 0.6], [5.0, 0.6]]])
    moved = apart.parted(np.array([[0.0, 0.4], [2.0, -1.0]]), np.array([0.3, 0.3]), walls, 0.5)
    assert np.allclose(moved, [[0.0, 0.1], [2.0, -1.0]])
    close = apart.parted(np.array([[0.0, 0.0], [0.0, 0.5]]), np.array([0.3, 0.3]), walls + 9, 0.5)
    assert np.allclose(close, [[0.0, -0.0505], [0.0, 0.5505]])  # each by the half
    slow = _limited(np.array([[3.0, 4.0], [0.0, 1.0], [0.0, 0.0]]), np.ones((3, 1)))
    assert np.allclose(slow, [[0.6, 0.8], [0.0, 1.0], [0.0, 0.0]])


def test_the_examples_are_valid(fast):
    for file in (Path(__file__).parents[2] / "examples" / "shots").glob("*.json"):
        for shot in Scene.load(file).shots[::7]:  # of a crowd, some
            shot.plan(fast[1])


def test_a_render_has_the_bits_of_its_states_and_a_seed_other_steps(fast):
    short = replace(S_PATH, duration=1.5, styles=[(0, "Neutral"), (1, "Zombie")])
    made = short.render(*fast)
    assert len(made) == 1.5 * FPS
    again = tk.runtime.record(fast[0], Scene([short]).states(*fast))
    assert torch.equal(again.rotations, made.rotations)
    assert torch.equal(again.root_positions, made.root_positions)
    for changes, least in (({"seed": 1}, 0.1), ({"feet": False, "arms": False}, 1e-3)):
        other = replace(short, **changes).render(*fast)
        assert (other.rotations - made.rotations).abs().max() > least


def test_characters_keep_to_their_paths_and_their_times(fast):
    model, bank = fast
    made = []
    for style in ("Neutral", "Old"):
        timed = [(0, 0), (1, 2, 3.4 / bank.speed(style)), (-1, 4), (0, 6, 9.5 / bank.speed(style))]
        made.append(replace(S_PATH, styles=style, path=timed))
    plans = [shot.plan(bank) for shot in made]
    states = list(Scene(made).states(model, bank, plans))
    for who, (shot, (course, _)) in enumerate(zip(made, plans, strict=True)):
        own = states[: len(course.distance) - 1]
        places = [tuple(state.root[who, :2].tolist()) for state in own]
        apart = beside(course, places)
        assert sum(apart) / len(apart) < 0.07
        for k in (1, 3):
            seconds, metres = arrival(course.curve.point(course.curve.knots[k]), shot.path[k].time,
                                      places)
            assert seconds == 0
            assert metres < 0.12
        assert shot.unmet(bank, plans[who], places) == []
        contacts = torch.stack([state.contacts[who] for state in own])
        walk = tk.runtime.record(model, own, character=who)
        assert max(tk.metrics.foot_skate(walk, contacts).values()) < 0.01


def test_a_hold_stands_a_direction_is_kept_and_a_point_is_faced(fast):
    held = Shot([(0, 0), (0, 4)], "Neutral", holds=[{"time": 3.0, "seconds": 2.0}],
                facing=(1.0, 0.0))
    looks = Shot([(0, 0), (0, 4)], "Neutral", [(0, 0.6)], look_at=(3.0, 2.0), duration=5.0)
    roots = torch.stack([state.root for state in Scene([held, looks]).states(*fast)])
    stand = roots[round(4.2 * FPS) : round(5.0 * FPS), 0, :2]
    assert (stand - stand[0]).norm(dim=-1).max() < 0.1
    assert roots[200, 0, 2] > 0.9  # faces +x
    assert roots[-1, 0, 1] == pytest.approx(4.0, abs=0.15)
    for x, z, dx, dz in roots[90:300:30, 1].tolist():
        aim = math.atan2(3.0 - x, 2.0 - z)
        assert abs(math.remainder(math.atan2(dx, dz) - aim, math.tau)) < 0.45


def test_check_names_what_is_to_blame():
    """A style that walks on in a pause; the pause and not the turn before it; the style."""
    _, bank = tk.pretrained()
    pause = Shot([(0, 0), (0, 4)], "Neutral", [(0, 1.0)], [{"distance": 2, "seconds": 2}])
    in_time = Shot([(0, 0), (0, 4, 4.0)], "Neutral", duration=4.0)
    for shot in (in_time, pause):
        plan = shot.plan(bank)
        places = [(0.0, at) for at in plan[0].distance[1:]]
        assert shot.unmet(bank, plan, places) == []
    on = [(0.0, z + 0.45 * (z == 2.0)) for _, z in places]
    assert "is ahead of the plan: Neutral does not stand" in pause.unmet(bank, plan, on)[-1]

    bent = Shot([(0, 0), (0, 2), (1.5, 2.3), (3, 2)], "Neutral", [(0, 1.0)])
    held = replace(bent, holds=[{"distance": 2.3, "seconds": 2}])
    straight = Shot([(0, 0), (0, 4)], [(0, "Neutral"), (4, "Old"), (8, "Zombie")], [(0, 1.0)])
    for shot, blamed in ((bent, "the turn after"),
                         (held, "does not stand still in the pause after 2.3 m"),
                         (straight, "Old does not keep to it")):
        plan = shot.plan(bank)
        ahead = [plan[0].curve.point(at) for at in plan[0].distance[1:]]
        late = next(k for k, at in enumerate(plan[0].distance) if at > 2.29)
        ahead[late + 5] = (ahead[late + 5][0] - 0.3, ahead[late + 5][1] + 0.3)
        said = next(x for x in shot.unmet(bank, plan, ahead) if "from the path" in x)
        assert blamed in said


@pytest.mark.parametrize(("changes", "said"), [
    ({"speeds": [(0, 6.0)], "path": [(0, 0), (0, 12)]}, "times that of the style"),
    ({"speeds": [(0, 2.0)], "path": [(0, 0), (0, 4), (0.8, 3)]}, "too tight"),
    ({"path": [(0, 0), (0, 5, 0.5)]}, "too far away to be reached at 0.5 s"),
    ({"path": [(0, 0), (0, 8, 3.0)]}, "path[1] is met"),
    ({"duration": 2.0, "path": [(0, 0), (0, 9)]}, "the end of the path is not reached in 2 s"),
    ({"path": [(0, 0), (0, 2)], "holds": [{"distance": 5, "seconds": 1}]},
     "holds[0] is after the end"),
    ({"pins": [{"at": 1.4, "left_hand": (0.3, 2.6, 2.0)}]}, "is 2.60 m high"),
])
def test_check_says_what_cannot_be_met(fast, changes, said):
    lines = replace(Shot([(0, 0), (0, 3)], "Neutral"), **changes).check(*fast)
    assert any(said in line for line in lines), lines


GOOD = {"path": [[0, 0], [0, 3]], "styles": [{"time": 0, "blend": "Neutral"}]}
BAD = [
    ({"path": [[0, 0]]}, "path: two or more points"),
    ({"path": [[0, 0], [0, math.nan]]}, "path[1]: z must be a number"),
    ({"path": [[0, 0], [0, 0]]}, "path[1]: is less than 1 cm"),
    ({"path": [[0, 0, None], [0, 1, 3], [0, 2, 2]]}, "times must increase"),
    ({"path": [[0, 0, 1], [0, 1]]}, "path[0]: the first point has the time 0"),
    ({"path": [[0, 0], {"x": 0, "y": 1}]}, "path[1]: unknown field 'y'"),
    ({"path": [[0, 0], [0, 1, 2, [0, 0]]]}, "facing must not be zero"),
    ({"styles": [{"time": 0, "blend": {"Old": 0.4}}]},
     "styles[0]: the weights of a blend must sum to 1"),
    ({"styles": [{"time": 0, "blend": "Old", "easing": "bounce"}]},
     "styles[0]: easing must be one of"),
    ({"speeds": [{"time": 0, "speed": -1}]}, "speeds[0]: speed must be a number from 0"),
    ({"speeds": [{"time": 0, "speed": True}]}, "speeds[0]: speed must be a number"),
    ({"holds": [{"seconds": 1}]}, "holds[0]: a hold needs either"),
    ({"facing": [0, 1], "look_at": [1, 1]}, "either facing or look_at"),
    ({"pins": [{"at": 1}]}, "pins[0]: a pin needs one of right_hand, left_hand"),
    ({"pins": [{"at": 1, "look": [0, 1]}]}, "pins[0]: look must be 3 numbers (x, y, z)"),
    ({"pins": [{"at": 1, "to": 1, "look": [0, 1, 1]}]}, "pins[0]: to must be after at"),
    ({"pins": [{"at": 1, "pose": {"Hips": [1, 1, 0, 0]}}]}, "rotations must be quaternions"),
    ({"duration": 1e9}, "duration must be a number"),
    ({"name": "a\nb"}, "name must be a line"),
]
BAD_SCENES = [
    ({"version": 2}, "this toolkit reads version 1"),
    ({"shots": []}, "shots: one or more"),
    ({"shots": [3]}, "shots[0]: expected the fields"),
    ({"shots": [GOOD, GOOD], "apart": 1.0}, "shots[0] and shots[1] start 0.00 m"),
    ({"apart": -1.0}, "apart must be a number"),
    ({"walls": [[[0, 0], [1, 0]]]}, "give apart"),
    ({"apart": 1.0, "walls": [[[0, 0], [0, 0]]]}, "walls[0]: start and end"),
]


SCENE = {"version": 1, "shots": [GOOD]}
FILES = [(None, "not a JSON file of shots"), ([], "expected an object with the fields"),
         *[(SCENE | {"shots": [GOOD | changes]}, said) for changes, said in BAD],
         *[(SCENE | changes, said) for changes, said in BAD_SCENES]]


@pytest.mark.parametrize(("scene", "said"), FILES, ids=[said for _, said in FILES])
def test_a_bad_field_is_one_clear_line(tmp_path, scene, said):
    path = tmp_path / "bad.json"
    path.write_text("" if scene is None else json.dumps(scene))
    with refusal(re.escape(said)) as caught:
        Scene.load(path)
    assert str(path) in str(caught.value)


PINNED = Shot([(0, 0), (0.3, 2), (0, 5)], "Strut", pins=[
    {"at": 2.2, "right_hand": (-0.5, 1.3, 1.9)},
    {"at": 4.5, "to": 5.2, "left_hand": (0.6, 0.9, 3.6), "look": (0.6, 0.9, 3.6)},
    {"at": 9.5, "left_foot": (0.2, 0.3, 5.1)}])


def test_pins_are_reached_and_the_feet_and_the_frames_between_stay(fast):
    """Within 2 cm, with as many findings as the same walk; far from it without pins."""
    model, bank = fast
    plan = PINNED.plan(bank)
    states = PINNED._walked(model, bank, plan)
    places = list(map(tuple, states.root[:, :2].tolist()))
    made, walk = (shot.drawn(model, states, plan[0])
                  for shot in (PINNED, replace(PINNED, pins=())))
    assert pins.missed(PINNED.pins, made) == PINNED.unmet(bank, plan, places) == []
    missed = [line.split(" is ")[0] for line in pins.missed(PINNED.pins, walk)]
    assert missed == ["pins[0]: the right hand", "pins[1]: the left hand", "pins[2]: the left foot"]
    assert len(tk.evaluation.defects(made)) <= len(tk.evaluation.defects(walk))
    free = [f for f in range(len(walk)) if all(not p.at - 0.8 <= (f + 1) / FPS <= p.end + 0.8
                                     for p in PINNED.pins)]
    assert 100 < len(free) < len(walk)
    assert torch.equal(made.rotations[free], walk.rotations[free])
    away = (made.global_positions - walk.global_positions).norm(dim=-1)
    assert away[:, made.skeleton.role("right_toe")].max() < 0.005  # no pin of it
    head = made.skeleton.neck[-1]
    ahead = made.global_rotations[300, head], made.global_positions[300, head]
    to = torch.tensor(PINNED.pins[1].look) - ahead[1]
    look = tk.motion.rotations.rotate(ahead[0], made.skeleton.facing_axis)
    assert float((look * to).sum() / to.norm()) > math.cos(0.3)


def test_a_head_turns_to_a_limit_and_not_to_what_is_behind_it():
    angles = torch.tensor([0.5, 1.2, 2.0, math.pi - 0.35, math.pi - 0.1])
    way = torch.stack((angles.sin(), 0 * angles, angles.cos()), 1)
    turned = reaching._looked(torch.tensor([0.0, 0.0, 1.0]).expand(5, 3), way)[:, 1]
    # by hand: at half of BEHIND before the back, half of LOOK; then smoothly to nothing
    assert turned.tolist() == pytest.approx([0.5, 1.156, 1.2, 0.6, 0.068], abs=2e-3)


@pytest.mark.parametrize("x", [-0.2, -1.0])
def test_pins_of_one_place_are_reached_from_two(fast, x):
    pins_ = [{"at": at, "right_hand": (x, 1.2, 3.0)} for at in (3.0, 5.0)]
    course, _ = Shot([(0, 0), (0, 6)], "Neutral", pins=pins_).plan(fast[1])
    (_, first, _), (_, second, _) = course.arrivals
    assert second - first > 0.99 * pins.LEAST
    if x == -0.2:
        assert (first, second) == pytest.approx((3.0 - pins.AHEAD, first + pins.LEAST))


def test_pins_of_all_kinds_move_a_walk_by_known_distances(walk_clip):
    """Of the functions that tests/browser compares with those of the page, without a browser."""
    walk = walk_clip.cut(0, 240)
    (x, _, z), (to_x, _, to_z) = walk.root_positions[[0, -1]].tolist()
    shot = Shot([(x, z), (to_x, to_z)], "Neutral", [(0, 1.2)], pins=[
        {"at": 1, "to": 1.5, "right_hand": (x - 0.3, 1.5, z + 1.6), "look": (x + 3, 1.2, z)},
        {"at": 1.6, "left_hand": (x + 0.5, 0.6, z + 2.0), "look": (x - 2, 0.2, z + 3)},
        {"at": 2, "pose": {"Chest": (0.924, 0.383, 0, 0), "Hips": (1, 0, 0, 0)}},
        {"at": 2.8, "right_foot": (x - 0.1, 0.3, z + 3), "left_hand": (x + 0.1, 1.0, z + 3.4)}])
    course = replace(shot, pins=()).plan()[0]
    rotations, root = reaching.pinned(walk.skeleton, walk.rotations.double(),
                                      walk.root_positions.double(), shot.pins, course)
    made = walk.replace(rotations=rotations.float(), root_positions=root.float())
    gone = (made.global_positions - walk.global_positions).norm(dim=-1).mean(0)
    joints = ("right_hand", "right_elbow", "left_hand", "left_elbow", "right_foot", "hips")
    found = [float(gone[walk.skeleton.role(name)]) for name in joints]
    found.append(float(gone[walk.skeleton.names.index("HeadEnd")]))
    known = [0.38107, 0.25756, 0.44308, 0.39679, 0.20307, 0.16131, 0.54464]
    assert found == pytest.approx(known, abs=2e-5)  # twice the softness of an arm moves 4e-5


def test_pins_are_missed_in_the_frames_from_their_time_to_their_end(walk_clip):
    fast = walk_clip.replace(rotations=walk_clip.rotations[::10],
                             root_positions=walk_clip.root_positions[::10])
    place = fast.global_positions[5, fast.skeleton.role("left_hand")].tolist()  # at 6 / FPS
    for at, to, said in ((6, None, []), (6, 7, ["is out of reach"]), (5, 6, ["is out of reach"]),
                         (99, None, ["after the end of the motion"])):
        pin = {"at": at / FPS, "to": to and to / FPS, "left_hand": place}
        lines = pins.missed(replace(PINNED, pins=[pin]).pins, fast)
        assert [text in line for text, line in zip(said, lines, strict=True)] == [True] * len(said)


def test_a_pinned_pose_is_taken_where_the_character_stands(fast):
    model, bank = fast
    zombie = Shot([(0, 0), (0, 3)], "Zombie", duration=2.1).render(model, bank)
    pose = tk.shots.pose(zombie, 2.0)
    shot = Shot([(0, 0), (0, 2)], "Neutral", pins=[{"at": 3.5, "pose": pose}], duration=4.5)
    made = shot.render(model, bank)
    arms = [made.skeleton.role(f"{side}_elbow") for side in ("left", "right")]
    assert torch.allclose(made.rotations[209, arms].abs(), zombie.rotations[120, arms].abs(),
                          atol=1e-3)
    assert abs(made.global_positions[209, :, 1].amin()) < 0.05
    assert Shot(**tk.shots.data([shot])["shots"][0]) == shot
    bad = replace(shot, pins=[{"at": 1, "pose": {"Tail": (1, 0, 0, 0)}}])
    with refusal("has the joint 'Tail'"):
        bad.render(model, bank)


def test_the_curve_goes_through_its_points_and_knows_a_circle():
    points = [(2 * math.sin(a), 2 * math.cos(a)) for a in (k * math.pi / 8 for k in range(17))]
    curve = Curve(points, smooth=True)
    assert curve.length == pytest.approx(4 * math.pi, rel=2e-3)
    for (x, z), at in zip(points, curve.knots, strict=True):
        assert curve.point(at) == pytest.approx((x, z), abs=1e-9)
    assert curve.tangent(0.0) == pytest.approx((1.0, 0.0), abs=0.05)


def test_places_are_found_near_the_plan_and_near_the_time():
    back = Curve([(0, 0), (0, 6), (0.2, 6), (0.2, 0)], smooth=False)
    for planned, found in ((1, 1.5), (10.5, 10.7)):  # the two ways pass each other
        assert nearest(back, (0.1, 1.5), planned) == pytest.approx(found)
    places = [(0.0, 9.0)] * 60 + [(0.0, 0.2)] + [(0.0, 0.1)] * 60
    assert arrival((0.0, 0.0), 48 / FPS, places) == (pytest.approx(14 / FPS), 9.0)
    assert arrival((0.0, 0.0), 50 / FPS, places) == (0.0, 0.1)
    places = [(0.0, 0.1)] * 30 + [(0.0, 9.0)] * 300 + [(0.0, 0.1)] * 30
    assert arrival((0.0, 0.0), 3.0, places) == (math.inf, 9.0)  # half a second too far on each side


def test_a_plan_meets_times_and_pauses():
    curve = Curve([(0, 0), (0, 10)], smooth=False)
    course = Course(curve, ([0.0], [1.0], ["linear"]), [("path[1]", 4.0, 6.0)],
                    [(None, 5.0, 2.0)], None)
    assert course.distance[360] == pytest.approx(4.0, abs=0.02)
    assert sum(abs(at - 5.0) < 1e-6 for at in course.distance) == pytest.approx(2 * FPS, abs=3)
    assert course.distance[-1] == 10.0


def test_the_verb_writes_a_motion(tmp_path, command):
    file, out = tmp_path / "shot.json", tmp_path / "walk.bvh"
    Shot([(0, 0), (0, 1)], "Neutral", duration=1.0).save(file)
    assert "not reached in 1 s" in command(f"shot {file} --out {out}").err
    assert len(tk.bvh.load(out)) == 60
