import pytest

from toolkit.io.progress import progress_bar


@pytest.fixture
def clock(monkeypatch):
    """Time that passes only as a test says: seconds in a list of one."""
    now = [0.0]
    monkeypatch.setattr("tqdm.std.time", lambda: now[0])
    return now


@pytest.mark.parametrize(("steps", "seconds", "lines"),
                         [(500, 0.01, 0), (6_000, 0.1, 12), (4_320, 20.0, 70)])
def test_a_file_gets_few_lines_of_long_work(capsys, clock, steps, seconds, lines):
    counted = 0
    for _ in progress_bar(range(steps), desc="train", unit="step"):
        counted += 1
        clock[0] += seconds
    text = capsys.readouterr().err
    assert counted == steps
    assert (lines > 0) * 5 <= len(text.splitlines()) <= lines
    assert "\r" not in text
    assert not text or text.splitlines()[-1].startswith("train: 100%")


def test_a_bar_that_is_updated_by_hand_counts_once(capsys, clock):
    with progress_bar(total=100.0, desc="training") as bar:
        for _ in range(100):
            clock[0] += 1.0
            bar.update(1.0)
        assert bar.n == 100
    shown = capsys.readouterr().err.splitlines()
    assert 4 <= len(shown) <= 8
    assert "100%" in shown[-1]
    assert len(set(shown)) == len(shown)
