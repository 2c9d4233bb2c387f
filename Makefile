# make demo | make test | make lab — each builds the virtual environment .venv first if there is none.
VENV := .venv
BIN := $(VENV)/bin

.PHONY: env demo test lab lint clean

env: $(VENV)/.complete

$(VENV)/.complete: pyproject.toml constraints.txt
	python3 -m venv $(VENV)
	$(BIN)/pip install --quiet --constraint constraints.txt pip setuptools
	$(BIN)/pip install --quiet --constraint constraints.txt torch
	$(BIN)/pip install --quiet --constraint constraints.txt --no-build-isolation --editable ".[dev]"
	$(BIN)/python -m toolkit.view.opengl
	touch $@

demo: env
	$(BIN)/python -m toolkit demo --out out/demo

test: env
	$(BIN)/ruff check
	$(BIN)/python -m pytest --numprocesses 2 --dist loadfile --nbval-lax --nbval-current-env --nbval-cell-timeout 120 tests notebooks

lab: env
	$(BIN)/jupyter lab notebooks --ServerApp.jpserver_extensions="{'toolkit.view.server': True}"

clean:
	rm -rf out build dist *.egg-info .pytest_cache .ruff_cache .hypothesis
