import itertools
import math
import re

import numpy as np
import pytest
import torch
from hypothesis import given, strategies as st
from refusal import refusal
from strategies import clips, human_clip
from torch.testing import assert_close

import toolkit as tk
from toolkit.io import bvh, decimals
from toolkit.motion import rotations as R

GOOD = """HIERARCHY
ROOT Hips
{
\tOFFSET 0 0 0
\tCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
\tJOINT Chest
\t{
\t\tOFFSET 0 10 0
\t\tCHANNELS 3 Zrotation Xrotation Yrotation
\t\tEnd Site
\t\t{
\t\t\tOFFSET 0 5 0
\t\t}
\t}
}
MOTION
Frames: 3
Frame Time: 0.033333
0 90 0 0 0 0 0 0 0
1 90 0 0 0 90 0 0 0
2 90 0 90 0 0 0 0 0
"""


def load(path, **labels):
    """A file in centimetres with Y up."""
    return bvh.load(path, unit=bvh.CENTIMETRE, up="y", **labels)


def assert_same(again, clip, error):
    """The same motion, up to an error in metres; the joints may stand in another order."""
    names = again.skeleton.names
    assert set(names) == set(clip.skeleton.names)
    assert again.fps == pytest.approx(clip.fps, abs=1e-3)
    same = [names.index(name) for name in clip.skeleton.names]
    parents = [names[again.skeleton.parents[j]] for j in same if j]
    assert parents == [clip.skeleton.names[p] for p in clip.skeleton.parents[1:]]
    assert_close(again.global_positions[:, same], clip.global_positions, atol=error, rtol=0)
    assert_close(R.to_matrix(again.global_rotations[:, same]),
                 R.to_matrix(clip.global_rotations), atol=1e-4, rtol=0)


def write(folder, text, name="walk.bvh"):
    path = folder / name
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


def test_a_file_worked_out_by_hand(tmp_path):
    text = GOOD.replace("JOINT Chest", "JOINT Bip01 L Thigh")
    clip = load(write(tmp_path, text), style="Old", gait="FW")
    assert clip.skeleton.names == ("Hips", "Bip01 L Thigh", "Bip01 L ThighEnd")
    assert (clip.fps, clip.style, clip.gait, clip.name) == (30.0, "Old", "FW", "walk.bvh")
    expected = [[[0, 0.9, 0], [0, 1, 0], [0, 1.05, 0]],
                [[0.01, 0.9, 0], [0.01, 1, 0], [0.01, 1.05, 0]],
                [[0.02, 0.9, 0], [-0.08, 0.9, 0], [-0.13, 0.9, 0]]]
    assert_close(clip.global_positions, torch.tensor(expected), atol=1e-6, rtol=0)


WAYS = {
    "crlf": lambda t: t.replace("\n", "\r\n"),
    "byte-order mark": lambda t: "\ufeff" + t,
    "brace behind the name": lambda t: re.sub(r"\n\s*{", " {", t),
    "odd spacing": lambda t: t.replace("Frames: 3", "  Frames:\t3").replace("90 0 0", " 90 0\t0 "),
    "cr": lambda t: t.replace("\n", "\r"),
    "signs, points, tabs": lambda t: t.replace(" 90 0", " +9.0e+1\t0.  "),
    "more digits than a double holds":
        lambda t: t.replace(" 90 0", " 90.0000000000000000000000 -0 "),
    "no last line end": lambda t: t.rstrip(),
    "decimal commas": lambda t: t.replace(".", ","),
    "UTF-16": lambda t: t.encode("utf-16"),
    "empty lines above": lambda t: "\n \n" + t,
    "keywords in lower case": lambda t: re.sub(
        "ROOT|JOINT|End Site|[XYZ](position|rotation)|OFFSET|CHANNELS", lambda m: m[0].lower(), t),
}


@pytest.mark.parametrize("change", WAYS.values(), ids=WAYS)
def test_ways_to_write_the_same_file(tmp_path, change):
    clip, same = (load(write(tmp_path, text)) for text in (GOOD, change(GOOD)))
    assert_same(same, clip, 1e-6)


def test_joints_may_be_called_like_end_sites(tmp_path):
    """A leaf with channels is a joint; an End Site takes a name that is free."""
    joint = "JOINT {}\n{{\nOFFSET 0 1 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n{}}}\n"
    end = "End Site\n{\nOFFSET 0 5 0\n}\n"
    inner = end + joint.format("HeadEnd", "") + joint.format("Head2End", "")
    inner += joint.format("Toe_End", end + end)
    motion = "MOTION\nFrames: 1\nFrame Time: 0.1\n10 20 30 0 0 0 0 0 40"
    text = f"HIERARCHY\nROOT Head\n{{\nOFFSET 0 0 0\n{inner}}}\n{motion}"
    clip = load(write(tmp_path, text))
    names = ("Head", "Head3End", "HeadEnd", "Head2End", "Toe_End", "Toe_EndEnd", "Toe_End2End")
    bvh.save(clip, tmp_path / "again.bvh")
    again = load(tmp_path / "again.bvh")
    for skeleton in (clip.skeleton, again.skeleton):
        assert skeleton.names == names
        assert skeleton.ends == ("Head3End", "Toe_EndEnd", "Toe_End2End")
    assert_close(again.rotations, clip.rotations, atol=1e-6, rtol=0)
    turned = [name for name, q in zip(names, clip.rotations[0], strict=True)
              if bool((q != R.identity()).any())]
    assert turned == ["HeadEnd", "Toe_End"]
    assert clip.without_ends().skeleton.names == ("Head", "HeadEnd", "Head2End", "Toe_End")


@st.composite
def decimal(draw):
    value = draw(st.floats(-1e6, 1e6) | st.floats(allow_nan=False, allow_infinity=False))
    return draw(st.sampled_from(["%.6f", "%+.3f", "%g", "%.15g", "%.17g", "%e", "%.0f."])) % value


@given(
    st.lists(decimal(), min_size=1, max_size=12),
    st.sampled_from([" ", "\t", "  ", " \n", "\r\n\n"]),
)
def test_numbers_are_the_nearest_doubles_or_refused(words, between):
    """Bit by bit what Python reads; what is refused is read by Python itself."""
    columns = np.zeros((1, len(words)) if between[-1] == "\n" else (len(words), 1))
    if decimals.read(np.frombuffer(between.join(words).encode(), np.uint8), 0, columns):
        assert [v.hex() for v in columns.ravel().tolist()] == [float(w).hex() for w in words]
    else:
        assert any(len(re.sub(r"e.*|\D", "", w)) > 15 or "e" in w for w in words)


def test_position_channels_replace_the_offset_and_a_still_carrier_is_merged(tmp_path):
    six = "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation"
    text = f"""HIERARCHY
ROOT joint_Root {{
  OFFSET 0 0 0
  {six}
  JOINT Hips {{
    OFFSET 7 7 7
    {six}
    JOINT Spine {{
      OFFSET 7 7 7
      {six}
    }}
  }}
}}
MOTION
Frames: 2
Frame Time: 0.033333
0 0 0 0 0 0 1 90 2 0 0 0 0 20 0 0 0 0
0 0 0 0 0 0 1 90 9 0 0 0 0 20 0 0 0 0
"""
    clip = load(write(tmp_path, text))
    assert clip.skeleton.names == ("Hips", "Spine")
    expected = [[[0.01, 0.9, 0.02], [0.01, 1.1, 0.02]], [[0.01, 0.9, 0.09], [0.01, 1.1, 0.09]]]
    assert_close(clip.global_positions, torch.tensor(expected), atol=1e-6, rtol=0)
    said = r"walk\.bvh: joint Spine changes its distance to its parent by up to 5 units"
    with pytest.raises(bvh.BVHError, match=said):
        load(write(tmp_path, text.replace("9 0 0 0 0 20", "9 0 0 0 0 25")))


@pytest.mark.parametrize(("y", "length"), [(0.5, 0.105), (1.5, 0.015)])
def test_positions_near_zero_are_relative_to_the_offset(tmp_path, y, length):
    text = GOOD.replace("CHANNELS 3", "CHANNELS 6 Xposition Yposition Zposition")
    rows = "".join(f"0 90 0 0 0 0 0 {y} 0 0 0 0\n" for _ in range(3))
    clip = load(write(tmp_path, text[: text.index("0 90 0 0")] + rows))
    assert clip.skeleton.offsets[1].norm() == pytest.approx(length)


@given(
    clip=clips(),
    order=st.sampled_from(["".join(p) for p in itertools.permutations("XYZ")]),
    unit=st.sampled_from([0.01, 1.0, 0.0254]),
)
def test_save_and_load_again(tmp_path_factory, clip, order, unit):
    path = tmp_path_factory.mktemp("bvh") / "clip.bvh"
    bvh.save(clip, path, order=order, unit=unit)
    assert_same(bvh.load(path, unit=unit, up="y"), clip, 1e-4)


@pytest.mark.parametrize(("options", "problem"), [
    ({"unit": 0.0}, "unit must be a positive number of metres, got 0.0"),
    ({"unit": math.inf}, "unit must be a positive number of metres, got inf"),
    ({"order": "XYX"}, "order must name each of X, Y and Z once, such as 'YXZ'; got 'XYX'"),
])
def test_a_unit_or_order_that_no_file_can_have_is_refused(tmp_path, options, problem):
    with refusal(re.escape(problem)):
        bvh.save(human_clip(0), tmp_path / "clip.bvh", **options)
    assert not list(tmp_path.iterdir())


BAD = {
    "cut inside the last line": (GOOD[:-10], 21, "expected 9 numbers, got 4"),
    "no frame": (GOOD[: GOOD.index("0 90 0 0")].replace("Frames: 3", "Frames: 0"), 17,
        "header says 0 frames, the file holds 0"),
    "too many frames": (GOOD + "0 0 0 0 0 0 0 0 0\n", 17, "header says 3 frames, the file holds 4"),
    "frame time zero": (GOOD.replace("0.033333", "0"), 18, "frame time must be positive"),
    "not a number": (GOOD.replace("1 90 0", "1 nan 0"), 20,
        "channel 2 is not a finite number: 'nan'"),
    "a number as Python writes it": (GOOD.replace("1 90 0", "1 9_0 0"), 20,
        "channel 2 is not a finite number: '9_0'"),
    "unknown word": (GOOD.replace("JOINT Chest", "JONT Chest"), 6, "unexpected 'JONT Chest'"),
    "joint twice": (GOOD.replace("JOINT Chest", "JOINT Hips"), 6, "joint Hips appears twice"),
    "two figures": (GOOD.replace("MOTION", "ROOT b\n{\n}\nMOTION"), 16,
        "a second ROOT: the file holds several figures; keep one of them"),
    "unknown channel": (GOOD.replace("3 Zrotation", "3 Wrotation"), 9,
        "CHANNELS needs its count and names"),
    "a brace too few": (GOOD.replace("}\nMOTION", "MOTION"), 15,
        "MOTION inside joint 'Hips', a brace is missing"),
    "binary": (bytes(range(256)) * 20, 1, "expected HIERARCHY"),
    "a joint inside an End Site": (
        GOOD.replace("OFFSET 0 5 0\n", "OFFSET 0 5 0\nEnd Site {\n}\n"), 13,
        "unexpected End inside an End Site"),
    "an offset that float32 cannot hold": (GOOD.replace("OFFSET 0 10 0", "OFFSET 0 1e300 0"), 8,
        "OFFSET needs three"),
    "a number of frames of 5,000 digits": (GOOD.replace("Frames: 3", "Frames: " + "9" * 5000), 17,
        "expected 'Frames: N'"),
}


@pytest.mark.parametrize(("text", "line", "problem"), BAD.values(), ids=BAD)
def test_bad_files_are_refused_by_name_and_line(tmp_path, text, line, problem):
    path = write(tmp_path, text)
    with pytest.raises(bvh.BVHError) as caught:
        load(path)
    message = str(caught.value)
    assert "\n" not in message
    assert message.startswith(f"{path}, line {line}: ")
    assert problem in message
    assert message.isprintable()


def test_a_position_that_float32_cannot_hold_is_refused(tmp_path):
    with pytest.raises(bvh.BVHError, match=r"walk\.bvh.*positions of joint Hips"):
        load(write(tmp_path, GOOD.replace("1 90 0 0", "1e308 90 0 0")))


@pytest.mark.parametrize(("text", "fps"), [
    ("0.033333", 30), (".033", 30), ("0.0083", 120), ("0.0167", 60), ("0.04", 25), ("0.0417", 24),
    ("0.033367", 1 / 0.033367), ("0.016", 62.5), ("0.0125", 80), ("3.33333e-2", 30)])
def test_frame_times_are_rounded_numbers(tmp_path, text, fps):
    assert load(write(tmp_path, GOOD.replace("0.033333", text))).fps == pytest.approx(fps, abs=1e-9)


def test_angles_that_may_be_radians_are_doubted(walk_clip, tmp_path):
    angles = R.to_euler(walk_clip.rotations, "YXZ")
    # Saved in degrees, these are the numbers of the radians.
    small = R.from_euler(angles * math.pi / 180, "YXZ")
    tk.bvh.save(walk_clip.replace(rotations=small), tmp_path / "radians.bvh")
    doubt = "no joint turns by more than .* degrees: if the file has radians, convert them"
    with pytest.warns(UserWarning, match=doubt):
        tk.load(tmp_path / "radians.bvh")
