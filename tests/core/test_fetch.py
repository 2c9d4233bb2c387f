"""Fetching from a server that cuts and stalls, and harmful archives: all, or nothing."""

import dataclasses
import hashlib
import io
import json
import random
import re
import sys
import threading
import zipfile
from pathlib import Path

import filelock
import pytest
from archive_server import Server
from refusal import refusal

import toolkit as tk
from toolkit.datasets import download, fetch, home, procedural


def zipped(members: dict[str, bytes]) -> bytes:
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as out:
        for name, data in members.items():
            out.writestr(name, data)
    return file.getvalue()


def sha256(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()


@pytest.fixture(scope="session")
def members(tmp_path_factory) -> dict[str, bytes]:
    """What 100STYLE's archive holds, small: two styles, the tables, and what is left out."""
    folder = tmp_path_factory.mktemp("written")
    procedural.write(folder, ["Neutral", "Zombie"], ["FW"], seconds=1.0)
    files = {}
    for path in sorted(folder.iterdir()):
        style = f"{path.name.split('_')[0]}/" if path.suffix == ".bvh" else ""
        files[f"100STYLE/{style}{path.name}"] = path.read_bytes()
    noise = random.Random(0).randbytes(200_000)
    return {"100STYLE/": b"", **files, "100STYLE/noise.txt": noise, "__MACOSX/._x.bvh": b"junk"}


@pytest.fixture
def server(members):
    with Server(zipped(members)) as running:
        options = {"poll_interval": 0.02}
        thread = threading.Thread(target=running.serve_forever, kwargs=options, daemon=True)
        thread.start()
        yield running
        running.stop.set()
        running.shutdown()
        thread.join()


@pytest.fixture
def root(tmp_path, monkeypatch, server) -> Path:
    """An empty data home whose 100style comes from the server, its size and checksum known."""
    monkeypatch.setenv("TOOLKIT_DATA", str(tmp_path / "home"))
    monkeypatch.setattr(download, "STALL", 0.6)
    monkeypatch.setattr(download, "WAIT", 0.01)
    publish(monkeypatch, server)
    return tmp_path / "home" / "100style"


def publish(monkeypatch, server, **changes):
    known = {"size": len(server.content), "sha256": sha256(server.content), "unpacked": 1_000_000}
    origin = dataclasses.replace(fetch.ORIGINS["100style"], url=server.url, **(known | changes))
    monkeypatch.setitem(fetch.ORIGINS, "100style", origin)


def get(**options) -> dict:
    return fetch.fetch("100style", **options)


def left(root: Path) -> list[str]:
    """What lies in the data home, the lock left out."""
    return sorted(p.name for p in root.parent.iterdir() if not p.name.endswith(".lock"))


def test_fetched_data_is_found_without_a_root(root, server, command, members):
    assert not tk.datasets.available("100style")
    known = get()
    assert known["sha256"] == sha256(server.content)
    assert known["found"] == "2 of the 2 takes of 2 styles that its tables name"
    assert known["source"] == server.url
    assert "CC BY 4.0" in known["terms"]
    assert re.fullmatch(r"20\d\d-\d\d-\d\dT.*\+00:00", known["date"])
    assert json.loads((root / fetch.RECORD).read_text()) == known
    assert left(root) == ["100style"]
    kept = {name.removeprefix("100STYLE/"): data for name, data in members.items()
            if name.startswith("100STYLE") and name.endswith((".bvh", ".csv", ".txt"))}
    there = {p.relative_to(root).as_posix(): p.read_bytes() for p in root.rglob("*") if p.is_file()}
    assert there == kept | {fetch.RECORD: (root / fetch.RECORD).read_bytes()}
    assert command("data list 100style").err == f"100style: {root}\n"
    styles = [clip.style for clip in tk.datasets.load("100style")]
    assert styles == ["ProceduralNeutral", "ProceduralZombie"]
    assert tk.datasets.where("100style") == f"100style: {root}"
    assert get() == known  # there already
    assert len(server.requests) == 1


@pytest.mark.parametrize("plan", [["cut 98304"], ["stall 98304"], ["500", "429"],
                                  ["chunked 98304"], ["unannounced 98304"],
                                  ["cut 16384"] * (download.TRIES + 2)])
def test_a_bad_connection_is_tried_again(root, server, plan):
    server.plan.extend(plan)
    assert get()["files"] == 5
    assert len(server.requests) == len(plan) + 1
    if plan[0].endswith("98304"):
        assert server.requests[1]["Range"] == "bytes=98304-"


def cut(server, **options):
    """A download that is given up after 98,304 bytes."""
    server.plan.extend(["cut 98304"] + ["500"] * 20)
    with pytest.raises(OSError, match=r"answers 500.* 5 times; is there a network"):
        get(**options)
    assert len(server.requests) == download.TRIES
    server.plan.clear()
    server.requests.clear()


def test_a_server_that_stays_bad_is_given_up_and_gone_on_with_later(root, server):
    cut(server)
    right, server.content = server.content, bytes(reversed(server.content))
    with refusal(r"refused \(removed"):
        get()  # parts of two files
    server.content = right
    server.requests.clear()
    cut(server)
    assert get()["files"] == 5
    assert server.requests[-1]["Range"] == "bytes=98304-"
    with pytest.raises(OSError, match=r"/none\.zip: no connection.* 5 times; is there a net"):
        get(root=root.parent / "new", source="http://127.0.0.1:9/none.zip")


def test_a_server_without_ranges_sends_all_again(root, server):
    server.ranges = False
    server.plan.extend(["cut 98304", "unannounced"])
    assert get()["files"] == 5
    assert server.requests.pop()["Range"] == "bytes=98304-"


ALL = "ProceduralNeutral", "ProceduralZombie"


def test_single_styles_are_read_out_of_the_archive_on_the_server(root, server, command):
    known = get(styles="ProceduralZombie")
    assert known["styles"] == ["ProceduralZombie"]
    assert known["found"] == "1 of the 2 takes of 2 styles that its tables name"
    assert [clip.style for clip in tk.datasets.load("100style")] == ["ProceduralZombie"]
    assert tk.datasets.contents("100style") == {ALL[0]: {}, ALL[1]: {"FW": 1}}
    asked = len(server.requests)
    assert get(styles=[ALL[1]]) == known  # there already
    assert len(server.requests) == asked
    # another one is added; the whole dataset replaces both
    said = command("data fetch 100style --yes --styles", ALL[0]).out
    assert "size   about 15 MB of" in said
    assert {clip.style for clip in tk.datasets.load("100style")} == set(ALL)
    assert fetch.record(root)["styles"] == list(ALL)
    assert get()["styles"] == []
    assert get(styles=["Old"])["files"] == 5
    assert left(root) == ["100style"]


def test_a_single_style_costs_little_of_a_large_archive(root, server, monkeypatch, members):
    other = random.Random(1).randbytes(9_000_000)
    server.content = zipped({"100STYLE/Old/Old_FW.bvh": other} | members)
    publish(monkeypatch, server)
    assert get(styles=[ALL[1]])["files"] == 4
    first, *starts = [int(request["Range"][6:-1]) for request in server.requests]
    assert first == 0  # which asks for the size
    assert min(starts) > len(other)


@pytest.mark.parametrize(("plan", "changes", "problem"), [
    (["whole", "whole", "changed"], {}, "another file than before"),
    (["whole", "shifted"], {}, "sends another part than bytes from [0-9]+ on: 'bytes 0-"),
    ([], {"ranges": False}, "the server sends the whole file only; leave --styles out"),
    ([], {"content": b"another"}, r"expected \d+ bytes, got 7"),
])
def test_single_styles_are_refused(root, server, plan, changes, problem):
    server.plan.extend(plan)
    vars(server).update(changes)
    with refusal(rf"{problem}.*refused \(removed"):
        get(styles=ALL)
    assert left(root) == []


def test_a_damaged_member_or_an_unknown_style_is_refused(root, server, tmp_path, members):
    middle = server.content.index(b"100STYLE/noise.txt") + 10_000
    wrong = bytes([server.content[middle] ^ 255])
    server.content = server.content[:middle] + wrong + server.content[middle + 1 :]
    with refusal("not a whole zip archive"):
        get(styles=ALL)
    with refusal("unknown style 'Zombie'; did you mean ProceduralZombie"):
        get(styles="Zombie")
    assert left(root) == []
    with refusal("single styles are fetched of 100style, not of bandai"):
        fetch.fetch("bandai", styles="Old")
    own = tmp_path / "own.zip"
    own.write_bytes(zipped(members))
    known = get(styles=[ALL[0]], source=own, sha256=sha256(own.read_bytes()))
    assert known["styles"] == [ALL[0]]


def test_a_download_that_was_whole_when_it_was_stopped_stays_as_it_is(server, tmp_path):
    (tmp_path / "it.zip.part").write_bytes(server.content)
    download.download(server.url, tmp_path / "it.zip", known=True)
    assert (tmp_path / "it.zip").read_bytes() == server.content


def test_an_answer_that_stays_no(root, server):
    for plan, problem in ((["404"], "answers 404 Not Found"), (["302 /x"] * 40, "30 redirects")):
        server.plan.extend(plan)
        with refusal(problem):
            get()
        assert left(root) == []
        server.plan.clear()


def test_without_a_checksum_every_address_is_encrypted(root, server, monkeypatch):
    publish(monkeypatch, server, size=None, sha256=None)
    with refusal(r"http://\S+ is not encrypted; give an https address"):
        get(source="http://data.example/x.zip")
    assert not server.requests
    server.plan.append("302 http://data.example/x.zip")
    with refusal(r"leads to http://data.example/x.zip, which is not enc"):
        get()
    assert len(server.requests) == 1
    server.plan.append(f"302 {server.url}")
    assert get()["files"] == 5


def test_a_damaged_record_is_said_in_one_line(root, command):
    get()
    record = (root / fetch.RECORD).read_text()
    for text in ("7", record[:-9]):
        (root / fetch.RECORD).write_text(text)
        said = command("data fetch 100style", status=2).err
        assert f"{fetch.RECORD}: damaged; move the folder away to fetch it again" in said
        assert said.count("\n") == 1


def test_an_archive_that_means_harm_is_refused(root, tmp_path, members):
    bad = tmp_path / "bad.zip"
    for member in ("100STYLE/../../evil.bvh", "/tmp/evil.bvh", "..\\evil.bvh", "C:evil.bvh"):
        bad.write_bytes(before := zipped(members | {member: b"/etc/passwd"}))
        with refusal(r"leads out of the folder.*refused .nothing was"):
            get(source=bad, sha256=sha256(before))
        assert bad.read_bytes() == before
        assert left(root) == []
    assert not list(tmp_path.rglob("*evil*"))


def test_damaged_archives_are_refused(root, tmp_path, members):
    bad = tmp_path / "bad.zip"

    def refused(data: bytes, problem: str):
        bad.write_bytes(data)
        with refusal(problem):
            get(source=bad, sha256=sha256(data))
        assert not root.exists()

    whole = zipped(members)
    refused(b"<!DOCTYPE html><title>Log in</title>", r"not a whole zip archive .*<!DOCTYPE html>")
    # a member says that it is smaller than it is
    size = len(members["100STYLE/Dataset_List.csv"]).to_bytes(4, "little")
    refused(whole.replace(size, (20).to_bytes(4, "little")), "not a whole zip archive")


def test_a_file_of_ones_own(root, tmp_path, server):
    own = tmp_path / "own.zip"
    own.write_bytes(server.content)
    assert get(source=own)["source"] == str(own)
    assert own.exists()
    assert not server.requests
    with refusal(r"nowhere.zip: no such file; an address starts with"):
        get(root=tmp_path / "other", source=tmp_path / "nowhere.zip")
    own.write_bytes(b"junk")
    with refusal(r"own.zip: expected the sha256.*nothing was changed"):
        get(root=tmp_path / "other", source=own)
    assert own.read_bytes() == b"junk"


def test_another_folder_is_never_overwritten(root):
    root.mkdir(parents=True)
    (root / "mine.txt").write_text("keep")
    with refusal("holds something else; move it away"):
        get()
    assert [p.name for p in root.iterdir()] == ["mine.txt"]
    (root / "mine.txt").unlink()
    known = get()  # an empty folder is filled
    (root / "notes.txt").write_text("mine")
    assert get() == known


def test_two_at_once_do_not_mix(root):
    root.parent.mkdir()
    other = refusal("another process is fetching it")
    with filelock.FileLock(root.with_name(".100style.lock")), other:
        get()
    assert get()["files"] == 5


def test_the_command_shows_size_and_terms_and_asks(root, server, command, monkeypatch):
    printed = command("data fetch 100style", status=2)
    shown = rf"from +{server.url}\n +size .*\n +terms +CC BY 4.0.*\n +into +{root}\n"
    assert re.search(shown, printed.out)
    assert "error: nothing was fetched: without a terminal to ask on, --yes" in printed.err
    for answer, code in (("n", 1), ("y", 0)):
        keyboard = io.StringIO(f"{answer}\n")
        keyboard.isatty = lambda: True
        monkeypatch.setattr(sys, "stdin", keyboard)
        command("data fetch 100style", status=code)
        assert root.exists() == (answer == "y")
    assert "is there already" in command("data fetch 100style").out


def test_the_layouts_of_the_other_archives(shared, tmp_path, monkeypatch):
    monkeypatch.setenv("TOOLKIT_DATA", str(tmp_path / "home"))
    # the published parameters, spread over two folders of a repository
    folder = "local-phases-f779/animation-demo/Unity/Assets/Demo/Parameters"
    files = {"local-phases-f779/ReadMe.md": b""}
    for path in (shared / "lpn_film_100style").glob("*.bin"):
        part = "Multiclip_All_Velocity_100_FC" if "Velocities" in path.name else "LPN"
        files[f"{folder}/{part}/{path.name}"] = path.read_bytes()
    archive = tmp_path / "copy.zip"
    archive.write_bytes(zipped(files))
    fetch.fetch("lpn-film-100style", source=archive)
    _, bank = tk.published.load()
    assert len(bank) == 100
    assert tk.published.available()
    assert tk.published.either(None, "lpn-film-100style").bank.names == bank.names
    # a part of Bandai's repository, which the checksum of the whole refuses
    take = next((shared / "bandai" / "dataset-2").glob("*_walk_*.bvh"))
    top = "Bandai-Namco-Research-Motiondataset-master"
    part = f"{top}/dataset/Bandai-Namco-Research-Motiondataset-2"
    pointer = b"version https://git-lfs.github.com/spec/v1"
    moves = {f"{top}/README.md": b"", f"{part}/data/data/{take.name}": take.read_bytes(),
             f"{part}/LICENSE": b"CC BY-NC", f"{part}/data.zip": pointer,
             f"{top}/utils/blender/LICENSE": b"MIT"}
    archive.write_bytes(zipped(moves))
    fetch.fetch("bandai", source=archive)
    (clip,) = tk.datasets.load("bandai")
    assert clip.gait == "walk"
    there = sorted(p.name for p in home.folder("bandai").rglob("*") if p.is_file())
    assert there == ["LICENSE", take.name, fetch.RECORD]


def test_without_anything_set_the_users_data_folder_is_the_home(monkeypatch, tmp_path):
    monkeypatch.delenv("TOOLKIT_DATA", raising=False)
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    if sys.platform == "linux":
        assert home.home() == tmp_path / "toolkit"
    assert not tk.published.available()
