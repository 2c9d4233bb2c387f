"""Bytes of Python by room and words of pages, beside what they may be."""

from pathlib import Path

HERE = Path(__file__).parents[1]
#: The largest number of bytes of Python files in a folder, without those of a folder in it.
ROOMS = {
    "core": (680_000, "toolkit", "toolkit/extra"),
    "extra": (320_000, "toolkit/extra", None),
    "tests": (700_000, "tests", None),
    "experiments": (280_000, "experiments", None),
}
WORDS = 30_000
NOT_OURS = {".git", ".pytest_cache", ".venv", "out", "build", "dist", "node_modules"}


def python(folder: str, without: str | None = None) -> int:
    """Bytes of the Python files in a folder, without those of another folder."""
    files = (HERE / folder).rglob("*.py")
    return sum(path.stat().st_size for path in files if without is None
               or HERE / without not in path.parents)


def words() -> int:
    """Words of all pages in Markdown."""
    pages = (path for path in HERE.rglob("*.md")
             if not NOT_OURS & set(path.relative_to(HERE).parts))
    return sum(len(path.read_text(encoding="utf-8").split()) for path in pages)


def run() -> None:
    """Bytes of Python by room and words of pages, beside what they may be."""
    print(f"{'':<34}{'is':>10}{'at most':>10}")
    for name, (most, folder, without) in ROOMS.items():
        found = python(folder, without)
        print(f"{name:<34}{found:>10,}{most:>10,}{' too much' if found > most else ''}")
        for room in sorted(path for path in (HERE / folder).iterdir() if path.is_dir()):
            inside = room.relative_to(HERE).as_posix()
            if inside != without and (size := python(inside)):
                print(f"  {inside:<32}{size:>10,}")
    found = words()
    print(f"{'words of pages':<34}{found:>10,}{WORDS:>10,}{' too much' if found > WORDS else ''}")
