"""Fetching from a server that cuts, stalls and lies, and archives that mean harm: whole and checked, or not at all."""

import collections
import dataclasses
import hashlib
import http.client
import http.server
import io
import json
import os
import random
import re
import shutil
import signal
import stat
import subprocess
import sys
import threading
import time
import zipfile
from pathlib import Path

import filelock
import pytest

import toolkit as tk
from toolkit.__main__ import main
from toolkit.datasets import download, fetch, home, procedural


class Server(http.server.ThreadingHTTPServer):
    """Serves ``content`` at any path; ``plan`` holds what to do with the next requests, ``whole`` when it is used up."""

    daemon_threads = True

    def __init__(self, content: bytes):
        super().__init__(("127.0.0.1", 0), Handler)
        self.content, self.plan, self.requests = content, collections.deque(), []
        self.tag, self.ranges, self.extra, self.chunk, self.sent = '"one"', True, 0, len(content) + 1, 0
        self.stop = threading.Event()

    @property
    def url(self) -> str:
        return f"https://127.0.0.1:{self.server_port}/data.zip"  # see `unencrypted`

    @property
    def plain(self) -> str:
        return f"http://127.0.0.1:{self.server_port}/data.zip"


class Handler(http.server.BaseHTTPRequestHandler):
    def do_GET(self):
        server = self.server
        server.requests.append(dict(self.headers))
        deed, *number = (server.plan.popleft() if server.plan else "whole").split()
        self.protocol_version = "HTTP/1.1" if deed == "chunked" else "HTTP/1.0"
        self.close_connection = True
        if deed.isdigit():
            self.send_response(int(deed))  # with the address to go to, if it redirects
            self.send_header("Content-Length", "0")
            if deed.startswith("3"):
                self.send_header("Location", number[0] if number else "/elsewhere.zip")
            self.end_headers()
            return
        data, start = server.content, 0
        asked = re.fullmatch(r"bytes=(\d+)-", self.headers.get("Range", ""))
        if asked and server.ranges and self.headers.get("If-Range", server.tag) == server.tag:
            start = int(asked[1])
        if start >= len(data):
            self.send_response(416)
            self.send_header("Content-Range", f"bytes */{len(data)}")
            self.send_header("Content-Length", "0")
            self.end_headers()
            return
        self.send_response(206 if start else 200)
        if start:
            self.send_header("Content-Range", f"bytes {start}-{len(data) - 1}/{len(data) + server.extra}")
        if server.tag:
            self.send_header("ETag", server.tag)
        if deed == "chunked":
            self.send_header("Transfer-Encoding", "chunked")
        elif deed != "unannounced":
            self.send_header("Content-Length", str(len(data) - start + server.extra))
        self.end_headers()
        upto = start + int(number[0]) if number else len(data)
        for at in range(start, upto, server.chunk):
            piece = data[at : min(at + server.chunk, upto)]
            try:
                self.wfile.write(b"%x\r\n%s\r\n" % (len(piece), piece) if deed == "chunked" else piece)
                self.wfile.flush()
            except OSError:
                return
            server.sent += len(piece)
            if server.chunk < len(data):
                time.sleep(0.01)
        if deed == "chunked" and not number:
            self.wfile.write(b"0\r\n\r\n")
        if deed == "stall":
            server.stop.wait(20)

    def log_message(self, *_):
        pass


def zipped(members: dict[str, bytes]) -> bytes:
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as out:
        for name, data in members.items():
            out.writestr(name, data)
    return file.getvalue()


@pytest.fixture(scope="session")
def members(tmp_path_factory) -> dict[str, bytes]:
    """What 100STYLE's archive holds, small: two styles in folders of their own, the tables, and what is left out."""
    folder = tmp_path_factory.mktemp("written")
    procedural.write(folder, ["Neutral", "Zombie"], ["FW"], seconds=1.0)
    files = {}
    for path in sorted(folder.iterdir()):
        style = f"{path.name.split('_')[0]}/" if path.suffix == ".bvh" else ""
        files[f"100STYLE/{style}{path.name}"] = path.read_bytes()
    noise = random.Random(0).randbytes(200_000)
    return {"100STYLE/": b"", **files, "100STYLE/noise.txt": noise, "__MACOSX/100STYLE/._x.bvh": b"junk"}


@pytest.fixture
def server(members):
    with Server(zipped(members)) as running:
        thread = threading.Thread(target=running.serve_forever, kwargs={"poll_interval": 0.02}, daemon=True)
        thread.start()
        yield running
        running.stop.set()
        running.shutdown()
        thread.join()


class Unencrypted(http.client.HTTPConnection):
    """In place of an encrypted connection, so that the server needs no certificate."""

    def __init__(self, *given, context=None, check_hostname=None, **named):
        super().__init__(*given, **named)


@pytest.fixture
def unencrypted(monkeypatch):
    monkeypatch.setattr(http.client, "HTTPSConnection", Unencrypted)


@pytest.fixture
def root(tmp_path, monkeypatch, server, unencrypted) -> Path:
    """An empty data home whose 100style comes from the server, its size and checksum known."""
    monkeypatch.setenv("TOOLKIT_DATA", str(tmp_path / "home"))
    monkeypatch.setattr(download, "STALL", 0.6)
    publish(monkeypatch, server)
    return tmp_path / "home" / "100style"


def publish(monkeypatch, server, **changes):
    known = {"size": len(server.content), "sha256": hashlib.sha256(server.content).hexdigest(), "unpacked": 1_000_000}
    origin = dataclasses.replace(fetch.ORIGINS["100style"], url=server.url, **(known | changes))
    monkeypatch.setitem(fetch.ORIGINS, "100style", origin)


def get(**options) -> dict:
    return fetch.fetch("100style", **options)


def left(root: Path) -> list[str]:
    """What lies in the data home, the lock left out."""
    return sorted(p.name for p in root.parent.iterdir() if not p.name.endswith(".lock"))


def test_fetched_data_is_found_without_a_root(root, server, capsys, members):
    assert not tk.datasets.available("100style")
    known = get()
    assert known["sha256"] == hashlib.sha256(server.content).hexdigest()
    assert known["found"] == "2 of the 2 takes of 2 styles that its tables name"
    assert known["source"] == server.url
    assert "CC BY 4.0" in known["terms"]
    assert re.fullmatch(r"20\d\d-\d\d-\d\dT.*\+00:00", known["date"])
    assert json.loads((root / fetch.RECORD).read_text()) == known
    assert left(root) == ["100style"]
    assert not list(root.rglob("*x.bvh"))
    for name, data in members.items():
        if name.endswith((".bvh", ".csv", ".txt")) and name.startswith("100STYLE"):
            assert (root / name.removeprefix("100STYLE/")).read_bytes() == data
    assert [c.style for c in tk.datasets.load("100style")] == ["ProceduralNeutral", "ProceduralZombie"]
    assert tk.datasets.where("100style") == f"100style: {root}"
    assert main_status(["data", "list", "100style"]) == 0
    printed = capsys.readouterr()
    assert "ProceduralZombie" in printed.out
    assert get() == known  # there already
    assert len(server.requests) == 1


def main_status(arguments: list[str]) -> int:
    try:
        return main(arguments)
    except SystemExit as stop:
        return stop.code


def test_commands_say_which_data_they_use(root, capsys):
    get()
    assert main_status(["data", "list", "100style"]) == 0
    assert capsys.readouterr().err == f"100style: {root}\n"


@pytest.mark.parametrize("plan", [["cut 100000"], ["stall 100000"], ["500", "503"], ["cut 100000", "429", "stall 50000"],
                                  ["302"], ["cut 1"] * (download.TRIES + 2), ["unannounced"], ["chunked"],
                                  ["chunked 100000"]])
def test_a_bad_connection_is_tried_again(root, server, plan):
    server.plan.extend(plan)
    assert get()["files"] == 5
    assert len(server.requests) == len(plan) + (plan not in (["unannounced"], ["chunked"]))
    if plan[0].endswith("100000"):
        assert server.requests[1]["Range"] == "bytes=100000-"
        assert server.requests[1]["If-Range"] == '"one"'


def test_a_server_that_stays_bad_is_given_up_and_gone_on_with_later(root, server):
    server.plan.extend(["cut 100000"] + ["500"] * 20)
    with pytest.raises(OSError, match=r"answers 500.*100,000 bytes are kept, the same command goes on"):
        get()
    assert len(server.requests) == download.TRIES
    server.plan.clear()
    assert get()["files"] == 5
    assert server.requests[-1]["Range"] == "bytes=100000-"


def test_a_home_that_is_not_there_is_said_in_plain_words(root):
    said = r"/none\.zip: cannot be reached \(.*refused\); is there a network\?; nothing came$"
    with pytest.raises(OSError, match=said):
        get(source="https://127.0.0.1:9/none.zip")


def test_a_server_without_ranges_starts_again(root, server):
    server.ranges = False
    server.plan.append("cut 100000")
    assert get()["files"] == 5
    assert server.requests[1]["Range"] == "bytes=100000-"


@pytest.mark.parametrize("honest", [True, False], ids=["If-Range", "If-Range ignored"])
@pytest.mark.parametrize("known", [True, False], ids=["known", "unknown"])
def test_a_file_that_changed_is_not_stitched(root, server, monkeypatch, members, known, honest):
    server.plan.extend(["cut 100000"] + ["500"] * 4)
    with pytest.raises(OSError, match="500"):
        get()
    server.content = zipped(members | {"100STYLE/more.txt": os.urandom(4000)})
    server.tag = '"two"'
    if not honest:
        monkeypatch.setattr(Handler, "do_GET", ignoring_if_range(Handler.do_GET))
    publish(monkeypatch, server, **({} if known else {"size": None, "sha256": None}))
    server.plan.clear()
    assert get()["sha256"] == hashlib.sha256(server.content).hexdigest()


def ignoring_if_range(do):
    def wrapped(self):
        del self.headers["If-Range"]
        do(self)

    return wrapped


@pytest.mark.parametrize("known", [True, False], ids=["known", "unknown"])
def test_without_a_validator_only_a_known_checksum_lets_it_go_on(root, server, monkeypatch, known):
    server.tag = ""
    publish(monkeypatch, server, **({} if known else {"size": None, "sha256": None}))
    server.plan.append("cut 100000")
    assert get()["files"] == 5
    assert ("Range" in server.requests[1]) == known


@pytest.mark.parametrize("extra", [-100, 100])
def test_a_lie_about_the_length_is_found(root, server, extra):
    server.extra = extra
    with pytest.raises(ValueError, match=f"expected a file of {len(server.content):,} bytes, the server announces"):
        get()
    assert not root.exists()


def test_a_lie_about_an_unknown_length_is_found(root, server, monkeypatch):
    publish(monkeypatch, server, size=None, sha256=None)
    server.extra = -100
    with pytest.raises(ValueError, match=r"not a whole zip archive.*refused"):
        get()
    assert left(root) == []
    server.extra = 100  # the connection ends early, again and again; asked for the rest, the server says that this is all
    assert get()["files"] == 5


def test_a_file_that_ends_early_or_never_is_not_taken(root, server, monkeypatch):
    whole = server.content
    server.plan.extend(["unannounced"] * 20)
    server.content = whole[:-10]
    with pytest.raises(ValueError, match=f"expected a file of {len(whole):,} bytes, .* {len(whole) - 10:,}"):
        get()
    shutil.rmtree(root.parent)
    server.content = whole + bytes(100)
    with pytest.raises(ValueError, match=f"more came than the {len(whole):,} bytes"):
        get()
    publish(monkeypatch, server, size=None, sha256=None)
    monkeypatch.setattr(fetch, "LARGEST", 4000)
    with pytest.raises(ValueError, match="more came than the 4,000 bytes"):
        get()
    server.plan.clear()
    with pytest.raises(ValueError, match=r"announces .* more than the 4,000"):
        get()
    assert not root.exists()


def test_a_wrong_checksum_is_refused_and_the_file_removed(root, server):
    right, server.content = server.content, server.content[:-1] + bytes([server.content[-1] ^ 1])
    digest = hashlib.sha256(server.content).hexdigest()
    with pytest.raises(ValueError, match=f"expected the sha256 [0-9a-f]{{64}}, got {digest}.*refused .removed; the same"):
        get()
    assert left(root) == []
    server.content = right
    assert get()["files"] == 5


@pytest.mark.parametrize(("plan", "problem"), [(["404"], "answers 404 Not Found"), (["302"] * 40, "answers 302 Found$")])
def test_an_answer_that_stays_no(root, server, plan, problem):
    server.plan.extend(plan)
    with pytest.raises(ValueError, match=problem):
        get()
    assert not root.exists()


@pytest.mark.parametrize("hops", [["http"], ["http", "https"], ["https", "http", "https"]])
def test_no_hop_is_unencrypted_without_a_checksum(root, server, monkeypatch, hops):
    publish(monkeypatch, server, size=None, sha256=None)
    addresses = [server.url if hop == "https" else server.plain for hop in hops]
    server.plan.extend(f"302 {address}" for address in addresses)
    with pytest.raises(ValueError, match=rf"the server leads to {server.plain}, which is not encrypted"):
        get()
    assert len(server.requests) == hops.index("http") + 1
    assert not root.exists()
    server.plan.clear()
    server.plan.extend(f"302 {address}" for address in addresses)
    publish(monkeypatch, server)  # the checksum is known
    assert get()["files"] == 5


def test_an_unencrypted_address_needs_a_checksum(root, server, monkeypatch):
    publish(monkeypatch, server, size=None, sha256=None)
    with pytest.raises(ValueError, match=rf"{server.plain}: is not encrypted; give an https address, or .*--sha256"):
        get(source=server.plain)
    assert not server.requests
    digest = hashlib.sha256(server.content).hexdigest()
    assert get(source=server.plain, sha256=digest)["sha256"] == digest


def test_a_redirect_leads_to_the_web_only(root, server):
    server.plan.append("302 ftp://127.0.0.1/data.zip")
    with pytest.raises(ValueError, match=r"leads to ftp://127\.0\.0\.1/data\.zip"):
        get()


def test_contents_have_a_checksum_where_the_archive_has_none(root, server, monkeypatch, members, tmp_path):
    for name, data in members.items():
        if name.startswith("100STYLE/") and data and not name.endswith(".npz"):
            path = tmp_path / "own" / name.removeprefix("100STYLE/")
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(data)
    right = fetch.contents(tmp_path / "own")
    publish(monkeypatch, server, size=None, sha256=None, contents="0" * 64)
    with pytest.raises(ValueError, match=rf"expected files of the checksum 0+, got {right}; --sha256 accepts another"):
        get()
    assert left(root) == []
    assert get(sha256=hashlib.sha256(server.content).hexdigest())["files"] == 5
    shutil.rmtree(root)
    publish(monkeypatch, server, size=None, sha256=None, contents=right)
    assert get()["files"] == 5
    shutil.rmtree(root)
    server.content = zipped(members | {"100STYLE/more.txt": b"planted"})
    with pytest.raises(ValueError, match="expected files of the checksum"):
        get()


def test_a_checksum_of_contents_uses_the_identifiers_of_git(tmp_path):
    (tmp_path / "a").write_bytes(b"")
    (tmp_path / "b").mkdir()
    (tmp_path / "b" / "c").write_bytes(b"hello\n")
    lines = "e69de29bb2d1d6434b8b29ae775ad8c2e48c5391 a\nce013625030ba8dba906f756967f9e9ca394464a b/c\n"
    assert fetch.contents(tmp_path) == hashlib.sha256(lines.encode()).hexdigest()


def test_each_public_home_is_fixed_and_checked():
    for origin in fetch.ORIGINS.values():
        assert origin.url.startswith("https://")
        assert origin.sha256 or origin.contents
        assert origin.sha256 or re.search(r"/[0-9a-f]{40}$", origin.url)  # a commit, not a branch


@pytest.mark.skipif(os.name == "nt", reason="needs links and owners")
@pytest.mark.parametrize("planted", ["archive.part", "archive.json", "archive.zip", "unpacked", "", "hard"])
def test_a_planted_link_is_not_followed(root, server, tmp_path, planted):
    target = tmp_path / "precious"
    work = root.with_name(".100style.fetch")
    work.parent.mkdir(parents=True)
    if planted in ("", "unpacked"):
        target.mkdir()
        (target / "file").write_text("keep")
    else:
        target.write_text("keep")
    if planted:
        work.mkdir()
    if planted == "hard":
        os.link(target, work / "archive.part")
    else:
        (work / planted if planted else work).symlink_to(target)
    with pytest.raises(ValueError, match=r"is a link, or another user's; remove .*\.100style\.fetch to download in safety"):
        get()
    assert (target / "file" if target.is_dir() else target).read_text() == "keep"
    assert not server.requests


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() != 0, reason="only root gives files away")
def test_a_folder_of_another_user_is_not_used(root, server):
    work = root.with_name(".100style.fetch")
    work.mkdir(parents=True)
    os.chown(work, 12345, 12345)
    with pytest.raises(ValueError, match="another user's"):
        get()
    assert not server.requests


@pytest.mark.skipif(os.name == "nt", reason="Windows has other permissions")
def test_the_folder_of_a_download_is_private(root, server):
    work = root.with_name(".100style.fetch")
    work.mkdir(parents=True)
    work.chmod(0o777)
    server.plan.extend(["500"] * 20)
    with pytest.raises(OSError, match="500"):
        get()
    assert work.stat().st_mode & 0o777 == 0o700


@pytest.mark.parametrize("notes", ["", "{", "[]", "7", "null", '{"url": 1}', "[" * 5000, '{"url": "URL", "validator": 7}',
                                   '{"url": "URL", "validator": "", "total": "x"}', "\udcff", "9" * 5000])
def test_damaged_notes_are_none(root, server, notes):
    work = root.with_name(".100style.fetch")
    work.mkdir(parents=True)
    (work / "archive.part").write_bytes(b"half")
    (work / "archive.json").write_bytes(notes.replace("URL", server.url).encode(errors="surrogateescape"))
    assert get()["files"] == 5
    assert "Range" not in server.requests[0]


@pytest.mark.parametrize("change", [lambda r: "", lambda r: "[]", lambda r: "{", lambda r: r.replace('"files"', '"fils"'),
                                    lambda r: r.replace('"files": 5', '"files": "5"'), lambda r: "[" * 5000,
                                    lambda r: r.replace('"date": "2', '"date": "\\u001b2')])
def test_a_damaged_record_is_said_in_one_line(root, change, capsys):
    get()
    (root / fetch.RECORD).write_text(change((root / fetch.RECORD).read_text()))
    with pytest.raises(ValueError, match=rf"{fetch.RECORD}: damaged; move the folder away to fetch it again"):
        get()
    assert main_status(["data", "fetch", "100style"]) == 2
    assert len(capsys.readouterr().err.splitlines()) == 1


@pytest.mark.parametrize("more", [{"100STYLE/Old.txt": b"", "100STYLE/Old.txt/a.bvh": b""},
                                  {"100STYLE/b.txt/a.bvh": b"", "100STYLE/B.txt": b""},
                                  {"100STYLE/" + "a" * 250 + ".bvh": b""}, {"100STYLE/a\x1b[31m.bvh": b""}])
def test_an_archive_that_no_disk_can_hold_does_not_stay(root, server, members, monkeypatch, more):
    right, server.content = server.content, zipped(members | more)
    publish(monkeypatch, server)
    with pytest.raises(ValueError, match=r"refused, .*refused .removed; the same"):
        get()
    assert left(root) == []
    server.content = right
    publish(monkeypatch, server)
    assert get()["files"] == 5


def special(kind: int) -> zipfile.ZipInfo:
    info = zipfile.ZipInfo("100STYLE/Frame_Cuts.bvh")
    info.create_system, info.external_attr = 3, (kind | 0o777) << 16
    return info


HARM = {
    "up": ("100STYLE/../../evil.bvh", "leads out of the folder"),
    "absolute": ("/tmp/evil.bvh", "leads out of the folder"),
    "backslash": ("..\\evil.bvh", "leads out of the folder"),
    "drive": ("C:evil.bvh", "leads out of the folder"),
    "left out": ("../readme", "leads out of the folder"),
    "link": (special(stat.S_IFLNK), "is a link or a device"),
    "device": (special(stat.S_IFCHR), "is a link or a device"),
    "twice": ("100STYLE/FRAME_cuts.csv", "twice"),
    "deep": (f"100STYLE/{'a/' * 1500}evil.bvh", "a name that no file should have"),
}


@pytest.mark.parametrize("how", HARM)
def test_an_archive_that_means_harm_is_refused(root, tmp_path, members, how):
    member, problem = HARM[how]
    bad = tmp_path / "bad.zip"
    bad.write_bytes(zipped(members))
    with zipfile.ZipFile(bad, "a") as file:
        file.writestr(member, "/etc/passwd")
    before = bad.read_bytes()
    with pytest.raises(ValueError, match=rf"{problem}.*refused .nothing was changed"):
        get(source=bad, sha256=hashlib.sha256(before).hexdigest())
    assert bad.read_bytes() == before
    assert not root.exists()
    assert not list(root.parent.rglob("*.bvh"))
    assert not list(tmp_path.rglob("*evil*"))


def test_a_bomb_and_damaged_archives_are_refused(root, tmp_path, members, monkeypatch, server):
    bad = tmp_path / "bad.zip"

    def refused(data: bytes, problem: str):
        bad.write_bytes(data)
        with pytest.raises(ValueError, match=problem):
            get(source=bad, sha256=hashlib.sha256(data).hexdigest())
        assert not root.exists()

    refused(zipped(members | {"100STYLE/bomb.txt": bytes(5_000_000)}), "would unpack to .* more than the 4,000,000")
    whole = zipped(members)
    refused(whole[: len(whole) // 2], "not a whole zip archive")
    refused(b"<!DOCTYPE html><title>Log in</title>", r"not a whole zip archive .*<!DOCTYPE html>")
    refused(b"", "not a whole zip archive")
    middle = whole.index(b"100STYLE/Frame_Cuts.csv") + 200
    refused(whole[:middle] + bytes([whole[middle] ^ 255]) + whole[middle + 1 :], "not a whole zip archive")
    refused(zipped({"readme.txt": b"nothing"}), "no Frame_Cuts.csv|no matching BVH")
    refused(zipped({"readme": b"nothing"}), "no Frame_Cuts.csv|no matching BVH")
    lying = whole.replace(len(members["100STYLE/Dataset_List.csv"]).to_bytes(4, "little"), (20).to_bytes(4, "little"))
    refused(lying, "not a whole zip archive")  # a member says that it is smaller than it is
    locked = bytearray(whole)
    at = locked.index(b"PK\x01\x02")
    locked[at + 8] |= 1
    refused(bytes(locked), "locked by a password")


def test_a_file_of_ones_own(root, tmp_path, server):
    own = tmp_path / "own.zip"
    own.write_bytes(server.content)
    assert get(source=own)["source"] == str(own)
    assert own.exists()
    assert not server.requests
    with pytest.raises(ValueError, match=r"nowhere.zip: no such file; an address starts with https"):
        get(root=tmp_path / "other", source=tmp_path / "nowhere.zip")
    own.write_bytes(b"junk")
    with pytest.raises(ValueError, match=r"own.zip: expected the sha256.*refused \(nothing was changed\)"):
        get(root=tmp_path / "other", source=own)
    assert own.read_bytes() == b"junk"
    assert not list(tmp_path.glob("other*")) + list(tmp_path.glob(".other.fetch"))


def test_no_room(root, server, monkeypatch):
    usage = shutil.disk_usage(root.parents[1])
    with monkeypatch.context() as full:
        full.setattr(shutil, "disk_usage", lambda _: usage._replace(free=1_000_000))
        with pytest.raises(OSError, match=r"bytes are needed to fetch and unpack 100style, the disk has 1,000,000 free"):
            get()
    assert not server.requests
    monkeypatch.setattr(download, "room", lambda folder, size, purpose: unpacking(purpose))
    with pytest.raises(OSError, match="unpack: no room"):
        get()
    assert not root.exists()
    monkeypatch.undo()


def unpacking(purpose):
    if purpose.startswith("unpack"):
        raise OSError("unpack: no room")


def test_what_came_before_the_disk_was_full_is_not_fetched_again(root, server, monkeypatch):
    with monkeypatch.context() as full:
        full.setattr(download, "room", lambda folder, size, purpose: unpacking(purpose))
        with pytest.raises(OSError, match="no room"):
            get()
    assert get()["files"] == 5
    assert len(server.requests) == 1


def test_a_folder_that_cannot_be_written(root, server, tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(OSError, match="file"):
        get(root=tmp_path / "file" / "100style")
    folder = tmp_path / "locked"
    folder.mkdir()
    folder.chmod(0o500)
    if not os.access(folder, os.W_OK):
        with pytest.raises(OSError, match="locked"):
            get(root=folder / "100style")
    assert not server.requests


def test_another_folder_is_never_overwritten(root):
    root.mkdir(parents=True)
    (root / "mine.txt").write_text("keep")
    with pytest.raises(ValueError, match="holds something else; move it away"):
        get()
    assert [p.name for p in root.iterdir()] == ["mine.txt"]
    (root / "mine.txt").unlink()
    known = get()  # an empty folder is filled
    (root / "notes.txt").write_text("mine")
    assert get() == known
    (root / "Frame_Cuts.csv").unlink()
    with pytest.raises(ValueError, match=r"5 files of .* bytes were fetched, 5 of .* are left|move the folder away"):
        get()


def test_two_at_once_do_not_mix(root, server):
    server.chunk = 20000
    results = []

    def one():
        try:
            results.append(get())
        except ValueError as error:
            results.append(str(error))

    threads = [threading.Thread(target=one) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(server.requests) == 1
    assert sorted(type(r).__name__ for r in results) == ["dict", "str"]
    assert "another process is fetching it" in next(r for r in results if isinstance(r, str))
    with filelock.FileLock(root.with_name(".100style.lock")), pytest.raises(ValueError, match="another process"):
        get()


def command(root: Path, server, *more: str, script: str = "") -> list[str]:
    digest = hashlib.sha256(server.content).hexdigest()
    code = f"import sys; from toolkit.__main__ import main; {script or 0}; sys.exit(main(sys.argv[1:]))"
    return [sys.executable, "-c", code, "data", "fetch", "100style", "--root", str(root), "--from", server.plain,
            "--sha256", digest, "--yes", *more]


def test_killed_while_downloading_the_same_command_goes_on(tmp_path, server):
    root = tmp_path / "100style"
    server.chunk = 1000
    with subprocess.Popen(command(root, server), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
        wait_for(lambda: server.sent > len(server.content) // 2)
        process.send_signal(signal.SIGKILL)
    assert not root.exists()
    part = tmp_path / ".100style.fetch" / "archive.part"
    assert 0 < part.stat().st_size < len(server.content)
    server.chunk = len(server.content) + 1
    done = subprocess.run(command(root, server), capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    assert int(server.requests[1]["Range"].removeprefix("bytes=").removesuffix("-")) > 0
    assert re.search(r"2 of the 2 takes of 2 styles.*\nsha256 of the archive: [0-9a-f]{64}", done.stdout)
    assert left(root) == ["100style"]


def test_killed_while_unpacking_nothing_is_taken_for_whole(tmp_path, server):
    root = tmp_path / "100style"
    hang = ("import shutil, time; copy = shutil.copyfileobj; "
            "shutil.copyfileobj = lambda a, b, n: (b.write(a.read(100)), b.flush(), time.sleep(60))")
    half = tmp_path / ".100style.fetch" / "unpacked"
    with subprocess.Popen(command(root, server, script=hang), stdout=subprocess.DEVNULL) as process:
        wait_for(lambda: any(p.is_file() and p.stat().st_size for p in half.rglob("*")))
        process.send_signal(signal.SIGKILL)
    assert not root.exists()
    done = subprocess.run(command(root, server), capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    assert len(server.requests) == 1  # the archive was whole
    assert len(tk.datasets.load("100style", root)) == 2
    assert left(root) == ["100style"]


def wait_for(condition):
    end = time.monotonic() + 60
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.01)


def test_the_command_shows_size_and_terms_and_asks(root, server, capsys, monkeypatch):
    assert main_status(["data", "fetch", "100style"]) == 2
    printed = capsys.readouterr()
    assert re.search(rf"from +{server.url}\n +size .*\n +terms +CC BY 4.0.*\n +into +{root}\n", printed.out)
    assert printed.err == "error: nothing was fetched: without a terminal to ask on, --yes accepts size and terms\n"
    for answer, status in (("n", 1), ("y", 0)):
        keyboard = io.StringIO(f"{answer}\n")
        keyboard.isatty = lambda: True
        monkeypatch.setattr(sys, "stdin", keyboard)
        assert main_status(["data", "fetch", "100style"]) == status
        assert root.exists() == (answer == "y")
    assert "(as published)" in capsys.readouterr().out
    assert main_status(["data", "fetch", "100style"]) == 0
    assert "is there already" in capsys.readouterr().out


@pytest.mark.parametrize(("arguments", "problem"), [
    (["xia"], "'xia' cannot be fetched; known: 100style, lpn-film-100style, bandai"),
    (["bandai", "--sha256", "abc"], "--sha256 expects 64 hexadecimal digits, got 'abc'"),
])
def test_bad_arguments(arguments, problem, capsys):
    assert main_status(["data", "fetch", *arguments]) == 2
    assert capsys.readouterr().err == f"error: {problem}\n"


def test_the_layouts_of_the_other_archives(shared, tmp_path, monkeypatch):
    monkeypatch.setenv("TOOLKIT_DATA", str(tmp_path / "home"))
    lpn = "local-phases-f779/animation-demo/Unity/Assets/Demo/Parameters/"
    files = {f"{lpn}{'Multiclip_All_Velocity_100_FC' if 'Velocities' in p.name else 'LPN'}/{p.name}": p.read_bytes()
             for p in (shared / "lpn_film_100style").glob("*.bin")}
    take = next((shared / "bandai" / "dataset-2").glob("*_walk_*.bvh"))
    top = "Bandai-Namco-Research-Motiondataset-master/"
    part = f"{top}dataset/Bandai-Namco-Research-Motiondataset-2/"
    moves = {f"{top}README.md": b"", f"{part}data/data/{take.name}": take.read_bytes(), f"{part}LICENSE": b"CC BY-NC",
             f"{part}data.zip": b"version https://git-lfs.github.com/spec/v1", f"{top}utils/blender/LICENSE": b"MIT"}
    for name, content in (("lpn-film-100style", files | {"local-phases-f779/ReadMe.md": b""}), ("bandai", moves)):
        (tmp_path / "copy.zip").write_bytes(zipped(content))
        if name == "bandai":  # a part of it
            with pytest.raises(ValueError, match="expected files of the checksum"):
                fetch.fetch(name, source=tmp_path / "copy.zip")
        given = {"sha256": hashlib.sha256((tmp_path / "copy.zip").read_bytes()).hexdigest()} if name == "bandai" else {}
        fetch.fetch(name, source=tmp_path / "copy.zip", **given)
    _, bank = tk.published.load()
    assert len(bank) == 100
    assert tk.published.available()
    assert tk.published.either(None, "lpn-film-100style").bank.names == bank.names
    (clip,) = tk.datasets.load("bandai")
    assert clip.gait == "walk"
    assert sorted(p.name for p in home.folder("bandai").rglob("*") if p.is_file()) == ["LICENSE", take.name, fetch.RECORD]
    pointer = {k: b"version https://git-lfs.github.com/spec/v1" if k.endswith(".bvh") else v for k, v in moves.items()}
    (tmp_path / "copy.zip").write_bytes(zipped(pointer))
    with pytest.raises(ValueError, match="expected HIERARCHY"):
        fetch.fetch("bandai", tmp_path / "elsewhere", tmp_path / "copy.zip")


def test_without_anything_set_the_users_data_folder_is_the_home(monkeypatch, tmp_path):
    monkeypatch.delenv("TOOLKIT_DATA", raising=False)
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    if sys.platform == "linux":
        assert home.home() == tmp_path / "toolkit"
    monkeypatch.setenv("TOOLKIT_DATA", str(tmp_path / "mine"))
    assert home.folder("lpn-film-100style") == tmp_path / "mine" / "lpn_film_100style"
    assert not tk.published.available()
    with pytest.raises(ValueError, match=r"lpn-film-100style: nothing at .*data fetch lpn-film-100style"):
        tk.published.load()
    with pytest.raises(ValueError, match=r"xia: nothing at .*its home"):
        tk.datasets.load("xia")
