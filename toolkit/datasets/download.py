"""Downloading one file: going on after a cut, never stitching two files together, never waiting for ever.

By `requests`; pooch starts a file of a gigabyte again from its beginning after every cut.
"""

import json
import re
import time
from pathlib import Path

import requests
import urllib3
from tqdm import tqdm

from toolkit.io.files import atomic_write

CONNECT, STALL = 10.0, 30.0  # seconds without a connection, or without a byte, after which a try has failed
TRIES = 5  # in a row that brought nothing new
_Unreachable = urllib3.exceptions.MaxRetryError  # no connection was made


def notes(part: Path) -> dict:
    """What the server called the file that lies in ``part``, whole or not: url, validator, total; empty if not known."""
    file = part.with_suffix(".json")
    return json.loads(file.read_text(encoding="utf-8")) if part.exists() and file.exists() else {}


def download(
    url: str, part: Path, size: int | None, limit: int, *, trusted: bool, progress: bool = False, stall: float = STALL
) -> None:
    """Download a file, going on with what is there of it if it is still the same on the server.

    Parameters
    ----------
    url
        Of the file.
    part
        Where it grows; beside it, ``.json`` says what the server called it.
    size, limit
        Its bytes, if known, and how many it may have otherwise.
    trusted
        It has a known checksum: a server that cannot say whether the file has changed is then asked to go on, too.

    Raises
    ------
    ValueError
        If the server refuses, leads from https to http, or sends more or fewer bytes than known.
    OSError
        If nothing new came in `TRIES` tries.
    """
    best = failures = 0
    with requests.Session() as session, tqdm(
        total=size, unit="B", unit_scale=True, desc="download", disable=None if progress else True
    ) as bar:
        session.headers.update({"Accept-Encoding": "identity", "User-Agent": "toolkit (data fetch)"})
        while True:
            try:
                return _receive(session, url, part, size, limit, trusted, stall, bar)
            except (requests.ConnectionError, requests.Timeout, urllib3.exceptions.HTTPError) as error:
                have = part.stat().st_size if part.exists() else 0
                failures, best = (1, have) if have > best else (failures + 1, best)
                if failures >= TRIES:
                    kept = f"{have:,} bytes are kept, the same command goes on from there" if have else "nothing came"
                    lost = isinstance(error, requests.ConnectionError) and isinstance(error.__context__, _Unreachable)
                    said = "cannot be reached; is there a network?" if lost else str(error).splitlines()[0]
                    raise OSError(f"{url}: {said}; {kept}") from error
                time.sleep(min(stall / 30 * 2 ** (failures - 1), stall))
            except requests.RequestException as error:
                raise ValueError(f"{url}: {error}") from error


def _receive(
    session: requests.Session, url: str, part: Path, size: int | None, limit: int, trusted: bool, stall: float, bar: tqdm
) -> None:
    """One try: the rest of the file, or all of it where the server has another one now or cannot go on."""
    known, have, headers = notes(part), 0, {}
    if known.get("url") == url and (known["validator"] or trusted):
        have = part.stat().st_size
        if have and have == known["total"]:
            return
        headers = {"Range": f"bytes={have}-"} if have else {}
        if have and known["validator"]:
            headers["If-Range"] = known["validator"]
    with session.get(url, headers=headers, stream=True, timeout=(min(CONNECT, stall), stall)) as reply:
        code = f"{reply.status_code} {reply.reason}"
        if url.startswith("https:") and not reply.url.startswith("https:"):
            raise ValueError(f"{url}: the server leads to {reply.url}, which is not encrypted")
        if reply.status_code in (408, 425, 429) or reply.status_code >= 500:
            raise requests.ConnectionError(f"the server answers {code}")
        span = re.fullmatch(r"bytes (?:(\d+)-\d+|\*)/(\d+|\*)", reply.headers.get("Content-Range", ""))
        total = span[2] if span else reply.headers.get("Content-Length", "")
        total = int(total) if total.isdigit() else None
        validator = reply.headers.get("ETag", "")
        if not validator or validator.startswith("W/"):
            validator = reply.headers.get("Last-Modified", "")
        if (reply.ok or reply.status_code == 416) and size and total and total != size:
            raise ValueError(f"{url}: expected a file of {size:,} bytes, the server announces {total:,}")
        if reply.status_code == 416 and have and total == have:  # it ends here, whatever was announced
            return
        if reply.status_code in (206, 416):
            same = validator == known.get("validator") and known.get("total") in (None, total)
            if not span or span[1] != str(have) or not same:
                part.unlink(missing_ok=True)
                raise requests.ConnectionError(f"the server does not go on with the same file ({code})")
        elif reply.status_code == 200:
            have = 0
        else:
            raise ValueError(f"{url}: the server answers {code}")
        if (size or total or 0) > limit:
            raise ValueError(f"{url}: the server announces {total:,} bytes, more than the {limit:,} that it may have")
        with part.open("ab" if have else "wb") as file:
            with atomic_write(part.with_suffix(".json")) as out:
                out.write(json.dumps({"url": url, "validator": validator, "total": total}).encode())
            bar.total, bar.n = size or total, have
            while chunk := reply.raw.read1(1 << 16, decode_content=False):
                file.write(chunk)
                have += len(chunk)
                bar.update(len(chunk))
                if have > (size or limit):
                    file.truncate(0)
                    raise ValueError(f"{url}: more came than the {size or limit:,} bytes that it may have")
    if total and have != total:
        raise requests.ConnectionError(f"the server announced {total:,} bytes and sent {have:,}")
    if size and have != size:
        raise requests.ConnectionError(f"the file should have {size:,} bytes and ended after {have:,}")
