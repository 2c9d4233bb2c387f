"""A short soak: the embedded model passes, and a failure is an exit status."""

import pytest
import typer
from robustness import soak

import toolkit as tk


def test_the_embedded_model_passes_and_says_so(capsys):
    soak.run(model=None, parameters=None, skip=None, seconds=3.0, seed=0)
    assert "| embedded | 25 | 4,500 | 0 | 0 | 0 | 0 |" in capsys.readouterr().out


def test_a_failure_is_an_exit_status(monkeypatch, capsys):
    monkeypatch.setattr(soak, "STUCK", 5.0)
    monkeypatch.setattr(soak, "WINDOW", 1.0)
    with pytest.raises(typer.Exit) as stopped:
        soak.run(skip=",".join(tk.pretrained().bank.names[4:]), seconds=4.0)
    assert stopped.value.exit_code == 1
    assert "stuck from" in capsys.readouterr().out
