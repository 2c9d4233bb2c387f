"""Hostile files, names and machines: what comes from outside is refused in one line, or read without harm."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import toolkit as tk

LOADED = """
import warnings
with warnings.catch_warnings(record=True) as said:
    warnings.simplefilter("always")
    import toolkit as tk
    clip = tk.bvh.load({file!r}, unit=0.01, up="y")
    tk.bvh.save(clip, {copy!r})
    tk.phases.extract(clip)
print(tk.__file__, len(clip), *(one.message for one in said if "compiled code" in str(one.message)), sep="|")
"""


@pytest.fixture
def installed(tmp_path):
    """A folder with a copy of the package, without caches and without permission to write; a home like this."""
    site = tmp_path / "site"
    shutil.copytree(Path(tk.__file__).parent, site / "toolkit", ignore=shutil.ignore_patterns("__pycache__", "scene", "static"))
    folders = [site, *(path for path in site.rglob("*") if path.is_dir())]
    for folder in folders:
        folder.chmod(0o555)
    yield site
    for folder in folders:
        folder.chmod(0o755)


def as_another(command: list[str]) -> list[str]:
    """A command without the privileges of root, as which the tests may run."""
    if not hasattr(os, "geteuid") or os.geteuid():
        return command
    if shutil.which("setpriv") is None:
        pytest.skip("root may write everywhere, and setpriv is missing, which takes that away")
    return ["setpriv", "--inh-caps=-all", "--bounding-set=-all", *command]


def test_a_read_only_install_without_a_home_reads_and_says_where_a_cache_would_go(installed, walk_clip, tmp_path):
    tk.bvh.save(walk_clip.cut(0, 120), tmp_path / "walk.bvh")
    code = LOADED.format(file=str(tmp_path / "walk.bvh"), copy=str(tmp_path / "copy.bvh"))
    kept = {k: v for k, v in os.environ.items() if k not in ("NUMBA_CACHE_DIR", "XDG_CACHE_HOME", "PYTHONPATH")}
    env = kept | {"PYTHONPATH": str(installed), "HOME": str(installed / "nobody"), "OMP_NUM_THREADS": "1"}
    done = subprocess.run(as_another([sys.executable, "-B", "-c", code]), cwd=tmp_path, env=env, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    module, frames, *said = done.stdout.strip().split("|")
    assert module == str(installed / "toolkit" / "__init__.py")
    assert frames == "120"
    assert len(said) == 1, said
    assert "NUMBA_CACHE_DIR" in said[0]
