"""Mutations of files: tokens, lines, bytes, encodings, JSON values, tables of tensors."""

import contextlib
import json
import math
import random
import re
import struct

NUMBERS = (b"0", b"-0", b"2", b"-1", b"180", b"1e-9", b"1e308", b"-1e39", b"1e-320", b"1e999",
           b"nan", b"-inf", b"9" * 400, b"9" * 5000, b"99999999999999", b"4503599627370497.5",
           b"0x10", b"1_000", b"1,5", b"--1", b".", b"1.2.3", b"1e", "١٢".encode(), b"N/A")
WORDS = (b"{", b"}", b"JOINT a", b"ROOT b", b"End Site", b"End Site {", b"OFFSET", b"OFFSET 0 1 0",
         b"CHANNELS 0", b"CHANNELS 3 Xrotation Yrotation Zrotation", b"MOTION", b"HIERARCHY",
         b"Xposition", b"Frames: 999999999", b"Frame Time: 0", b"Yes", b'"', b",", b'""', b"Hips")
RUBBISH = (b"\0", b"\0" * 64, b"\xef\xbb\xbf", b"\xff\xfe", b"\xe2\x80\xa8", b"\x85", b"\x1c",
           b"\x0b", b"\x1b[31m", b"\r", b"\r\n", b"\n" * 9, b"\t", b"\xf0\x9f\xa6\xb6")
VALUES = (None, True, False, -1, 0, 1, 3, 2**31, 2**63, 10**30, 0.5, 1e308, math.nan, math.inf, "",
          "x", "Hips", "-1", "\0", "\ud800", [], {}, [[]], [0], ["a", "a"], {"a": 1},
          [math.nan] * 3, "@deep")
WHOLE = (0, 1, 2, 3, 7, 255, 256, 65535, 2**31 - 1, 2**31, 2**32 - 1, 2**63 - 1, 2**63, 2**64 - 1)
FLOATS = (math.nan, math.inf, -math.inf, 0.0, -1.0, 1e30, 3e38, 1e-40)
LONGEST = 200_000  # bytes, longest mutated text
DEEP = "[" * 3000  # replaces "@deep" in a JSON text
TOKEN, NUMBER = re.compile(rb"[^\s,]+"), re.compile(rb"(?<![^\s,])[-+.\d][^\s,]*")


def text(rng: random.Random, data: bytes) -> bytes:
    """A text file with a few mutated tokens, lines or bytes."""
    for _ in range(rng.choice((1, 1, 1, 2, 2, 3, 5, 9))):
        change = rng.choice((*[_token] * 6, _lines, _bytes, _encoding))
        data = change(rng, data)[:LONGEST]
    return data


def _token(rng: random.Random, data: bytes) -> bytes:
    """Another number; another word, a word twice, none, or one with rubbish behind it."""
    kind = rng.choice((TOKEN, NUMBER))
    if not (found := kind.search(data, rng.randrange(len(data) + 1))):
        return data
    old = found[0]
    new = rng.choice(WORDS), b"", old + b" " + old, old + rng.choice(RUBBISH)
    if kind is NUMBER:
        new = rng.choice(NUMBERS), b"%.6f" % rng.gauss(0, 10 ** rng.randrange(6))
    return data[: found.start()] + rng.choice(new) + data[found.end() :]


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
    match rng.randrange(3):
        case 0:
            return data[:at]
        case 1:
            return data[:at] + data[min(to, at + 50) :]
    return data[:at] + rng.choice(RUBBISH) + data[at:]


def _encoding(rng: random.Random, data: bytes) -> bytes:
    match rng.randrange(4):
        case 0:
            return data.replace(b"\n", rng.choice((b"\r", b"\r\n", b"\n\n", b"\x0b")))
        case 1:
            encoding = rng.choice(("utf-16", "utf-8-sig", "utf-32"))
            return data.decode(errors="replace").encode(encoding)
        case 2:
            return data.replace(rng.choice((b" ", b"0", b",", b".")),
                                rng.choice((b"\t", b"\xc2\xa0", b"", b"  ")))
    return data.swapcase()


def number(rng: random.Random, data: bytes) -> bytes:
    """One of the floats of four bytes is another."""
    at = rng.randrange(max(len(data) // 4, 1)) * 4
    return data[:at] + struct.pack("<f", rng.choice(FLOATS)) + data[at + 4 :]


def flipped(rng: random.Random, data: bytes, *, in_place: bool = False) -> bytes:
    """A binary file with a few wrong bits, whole numbers or floats, or, unless ``in_place``, a part
    less or more.
    """
    for _ in range(rng.choice((1, 1, 1, 2, 4, 8))):
        at = rng.randrange(max(len(data), 1))
        match rng.randrange(in_place, 4):
            case 0:
                data = _bytes(rng, data)
                continue
            case 1:
                size = rng.choice((1, 2, 4, 8))
                new = (rng.choice(WHOLE) % 256**size).to_bytes(size, "little")
            case 2:
                new = struct.pack(rng.choice(("<f", "<d")), rng.choice(FLOATS))
            case _:
                new = bytes([data[at] ^ 1 << rng.randrange(8)]) if data else b""
        data = data[:at] + new + data[at + len(new) :]
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
    header, body = json.loads(data[8:end]), data[end:]
    kind = rng.randrange(10)
    if kind == 0:
        return rng.choice(WHOLE).to_bytes(8, "little") + data[8:]
    if kind == 1:
        return _bytes(rng, data)
    meta = header.pop("__metadata__", {})
    if kind == 2:
        header = tree(rng, header)
    elif kind == 3:
        body = number(rng, body)
    elif meta:
        part = rng.choice([*meta])
        value = meta[part]
        with contextlib.suppress(ValueError):
            value = json.loads(value)
        raw = rng.random() < 0.1
        meta[part] = rng.choice((DEEP, "", "{", "9" * 5000, "NaN")) if raw else _dumps(
            tree(rng, value))
    whole = {"__metadata__": meta, **header} if isinstance(header, dict) else header
    packed = _dumps(whole).encode(errors="replace")
    return len(packed).to_bytes(8, "little") + packed + body
