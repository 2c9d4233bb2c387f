"""How bad input is refused."""

import pytest


def refusal(match: str):
    """A ValueError of one printable line, in which the pattern is found."""
    return pytest.raises(ValueError, match=match, check=lambda error: str(error).isprintable())
