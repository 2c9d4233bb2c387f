"""What the other tests here rely on: a notebook that fails is seen to fail."""

import pytest


def test_an_error_in_a_cell_is_raised(open_notebook):
    notebook = open_notebook("fails.ipynb", ["print(1)", "raise ValueError('no such thing')", "print(2)"])
    with pytest.raises(AssertionError, match="ValueError: no such thing"):
        notebook.run_all()
