"""Motion files of other programs, where they are at hand, compared with a key made by hand."""

import pytest

from experiments import foreign


@pytest.mark.parametrize("name", foreign.KEY)
def test_a_foreign_file_is_understood_or_refused_or_doubted(shared, name):
    path = shared / "foreign" / name
    if not path.exists():
        pytest.skip(f"{name} is not at hand")
    row = foreign.judge(path, foreign.KEY[name])
    assert row.wrong == []
    assert row.verdict == foreign.KEY[name].verdict, row.said
    assert "\n" not in row.said
