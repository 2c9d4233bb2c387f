"""Mutations of files: tokens, lines, bytes, encodings, JSON values, tables of tensors."""

import contextlib
import json
import math
import random
import re
import struct
from collections.abc import Callable

import numpy as np

NUMBERS = (b"0", b"-0", b"2", b"-1", b"180", b"1e-9", b"1e308", b"-1e39", b"1e-320", b"1e999",
           b"nan", b"-inf", b"9" * 400,
           b"9" * 5000, b"99999999999999", b"4503599627370497.5", b"0x10", b"1_000", b"1,5", b"--1",
           b".", b"1.2.3", b"1e",
           "١٢".encode(), b"N/A")
WORDS = (b"{", b"}", b"JOINT a", b"ROOT b", b"End Site", b"End Site {", b"OFFSET", b"OFFSET 0 1 0",
         b"CHANNELS 0", b"MOTION",
         b"CHANNELS 3 Xrotation Yrotation Zrotation", b"HIERARCHY", b"Xposition",
         b"Frames: 999999999", b"Frame Time: 0",
         b"Yes", b"No", b'"', b",", b'""', b"Hips", b"STYLE_NAME")
RUBBISH = (b"\0", b"\0" * 64, b"\xef\xbb\xbf", b"\xff\xfe", b"\xe2\x80\xa8", b"\x85", b"\x1c",
           b"\x0b", b"\x1b[31m", b"\r",
           b"\r\n", b"\n" * 9, b"\t", b"\xf0\x9f\xa6\xb6")
VALUES = (None, True, False, -1, 0, 1, 3, 2**31, 2**63, 10**12, 10**30, 0.5, 1e308, math.nan,
          math.inf, "", "x", "Hips",
          "-1", "\0", "\ud800", [], {}, [[]], [0], ["a", "a"], {"a": 1}, [math.nan] * 3, "@deep")
WHOLE = (0, 1, 2, 3, 7, 255, 256, 65535, 2**31 - 1, 2**31, 2**32 - 1, 2**63 - 1, 2**63, 2**64 - 1)
FLOATS = (math.nan, math.inf, -math.inf, 0.0, -1.0, 1e30, 3e38, 1e-40)
LONGEST = 200_000  # bytes, longest mutated text
DEEP = "[" * 3000  # replaces "@deep" in a JSON text

Mutate = Callable[[random.Random, bytes], bytes]


def text(rng: random.Random, data: bytes) -> bytes:
    """A text file with a few mutated tokens, lines or bytes."""
    for _ in range(rng.choice((1, 1, 1, 2, 2, 3, 5, 9))):
        data = rng.choice(_TEXT)(rng, data)[:LONGEST]
    return data


_NUMBER, _TOKEN = (re.compile(rb"(?<![^\s,])" + first + rb"[^\s,]*")
                   for first in (rb"[-+.\d]", rb"[^\s,]"))


def _token(pattern: re.Pattern, make: Callable[[random.Random, bytes], bytes]) -> Mutate:
    def change(rng: random.Random, data: bytes) -> bytes:
        found = pattern.search(data, rng.randrange(len(data) + 1))
        return data if not found else data[: found.start()] + make(rng,
                                                                   found[0]) + data[found.end() :]

    return change


def _lines(rng: random.Random, data: bytes) -> bytes:
    lines = data.splitlines(keepends=True) or [b""]
    i, j = rng.randrange(len(lines)), rng.randrange(len(lines))
    match rng.randrange(4):
        case 0:
            del lines[i : i + rng.choice((1, 1, 1, 5))]
        case 1:
            lines[j:j] = [lines[i]] * rng.choice((1, 1, 2, 40))
        case 2:
            lines[i], lines[j] = lines[j], lines[i]
        case 3:
            lines[i] = lines[i].rstrip() + b" " + lines[j]
    return b"".join(lines)


def _bytes(rng: random.Random, data: bytes) -> bytes:
    at, to = sorted(rng.randrange(len(data) + 1) for _ in range(2))
    match rng.randrange(4):
        case 0:
            return data[:at]
        case 1:
            return data[:at] + data[min(to, at + 50) :]
        case 2:
            return data[:at] + rng.choice(RUBBISH) + data[at:]
    return (
        data if at == len(data) else data[:at] + bytes([data[at] ^ 1 << rng.randrange(8)])
        + data[at + 1 :]
    )


def _encoding(rng: random.Random, data: bytes) -> bytes:
    match rng.randrange(4):
        case 0:
            return data.replace(b"\n", rng.choice((b"\r", b"\r\n", b"\n\n", b"\x0b")))
        case 1:
            return data.decode(errors="replace").encode(rng.choice(("utf-16", "utf-8-sig",
                                                                    "utf-32")))
        case 2:
            return data.replace(rng.choice((b" ", b"0", b",", b".")),
                                rng.choice((b"\t", b"\xc2\xa0", b"", b"  ")))
    return data.swapcase()


def _frames(rng: random.Random, data: bytes) -> bytes:
    """Another number of frames, or a header with a wrong number."""
    if rng.random() < 0.5:
        return re.sub(rb"(?<=Frames:)[^\n]*", b" " + rng.choice(NUMBERS), data, count=1)
    more, row = rng.choice((0, 1, 2, 50)), data[data.rstrip().rfind(b"\n") + 1 :]
    return re.sub(rb"(?<=Frames: )\d+", lambda m: b"%d" % (int(m[0][:9]) + more), data,
                  count=1) + row * more


def _nested(rng: random.Random, data: bytes) -> bytes:
    """A long chain of joints or End Sites."""
    deep, at = rng.choice((1, 3, 30, 300)), data.find(b"End Site")
    name = rng.choice((b"JOINT n%d", b"End Site %d"))
    chain = b"".join(name % i + b"\n{\nOFFSET 0 1 0\n" for i in range(deep)) + b"}\n" * deep
    return data[:at] + chain + data[at:] if at >= 0 else data


_TEXT: tuple[Mutate, ...] = (
    *[_token(_NUMBER, lambda rng, _: rng.choice(NUMBERS))] * 2,
    *[_token(_NUMBER, lambda rng, _: b"%.6f" % rng.gauss(0, 10 ** rng.randrange(6)))] * 3,
    _token(_TOKEN, lambda rng, _: rng.choice(WORDS)),
    _token(_TOKEN, lambda rng, old: rng.choice((b"", old + b" " + old, old + rng.choice(RUBBISH)))),
    _lines, _bytes, _encoding, _frames, _nested,
)


def flipped(rng: random.Random, data: bytes, *, in_place: bool = False) -> bytes:
    """A binary file with a few wrong bits, whole numbers or floats, or, unless ``in_place``, a part
    less or more.
    """
    for _ in range(rng.choice((1, 1, 1, 2, 4, 8))):
        at = rng.randrange(len(data) + 1)
        match rng.randrange(3 * in_place, 8):
            case 0:
                data = _bytes(rng, data)
            case 1:
                data = data[:at]
            case 2:
                to = rng.randrange(len(data) + 1)
                data = data[:at] + data[to : to + rng.choice((1, 4, 16, 64))] + data[at:]
            case 3 | 4:
                size = rng.choice((1, 2, 4, 8))
                new = (rng.choice(WHOLE) % 256**size).to_bytes(size, "little")
                data = data[:at] + new + data[at + len(new) :]
            case 5:
                new = struct.pack(rng.choice(("<f", "<d")), rng.choice(FLOATS))
                data = data[:at] + new + data[at + len(new) :]
            case _ if at < len(data):
                data = data[:at] + bytes([data[at] ^ 1 << rng.randrange(8)]) + data[at + 1 :]
    return data


def tree(rng: random.Random, node: object) -> object:
    """A JSON value with one node changed, removed or added."""
    if isinstance(node, dict | list) and node and rng.random() < 0.85:
        keys = list(node) if isinstance(node, dict) else range(len(node))
        key, made = rng.choice(keys), dict(node) if isinstance(node, dict) else list(node)
        match rng.randrange(12):
            case 0:
                del made[key]
            case 1:
                name = rng.choice(("x", "", "phase", "names"))
                made = made | {name: rng.choice(VALUES)} if isinstance(made, dict) else made * 2
            case _:
                made[key] = tree(rng, made[key])
        return made
    return rng.choice(VALUES)


def json_text(rng: random.Random, data: bytes) -> bytes:
    """A JSON file with wrong values or wrong bytes."""
    if rng.random() < 0.2:
        return _bytes(rng, data)
    return _dumps(tree(rng, json.loads(data))).encode(errors="replace")


def _dumps(value: object) -> str:
    return json.dumps(value).replace('"@deep"', DEEP)


def tensors(rng: random.Random, data: bytes) -> bytes:
    """A safetensors file with wrong values in its metadata, its table of tensors or its bytes."""
    end = 8 + int.from_bytes(data[:8], "little")
    header, body = json.loads(data[8:end]), bytearray(data[end:])
    kind = rng.randrange(10)
    if kind == 0:
        size = rng.choice((0, 1, 7, end, len(data), 2**31, 2**40, 2**63, 2**64 - 1))
        return size.to_bytes(8, "little") + data[8:]
    if kind == 1:
        return _bytes(rng, data[: end if rng.random() < 0.5 else None]) + data[end:]
    meta = header.pop("__metadata__", {})
    if kind == 2:
        header = tree(rng, header)
    elif kind == 3 and body:
        at = rng.randrange(len(body) // 4) * 4
        body[at : at + 4] = np.float32(rng.choice((math.nan, math.inf, 1e38))).tobytes()
    elif meta:
        part = rng.choice([*meta])
        raw = rng.random() < 0.1
        meta[part] = rng.choice((DEEP, "", "{", "9" * 5000, "NaN")) if raw else _dumps(tree(
            rng, _loads(meta[part])))
    packed = _dumps({"__metadata__": meta, **header}
                    if isinstance(header, dict) else header).encode(errors="replace")
    return len(packed).to_bytes(8, "little") + packed + bytes(body)


def tensors_of_size(rng: random.Random, data: bytes) -> bytes:
    """`tensors` with the size of the original file."""
    return (tensors(rng, data) + bytes(len(data)))[: len(data)]


def _loads(value: str) -> object:
    with contextlib.suppress(ValueError):
        return json.loads(value)
    return value
