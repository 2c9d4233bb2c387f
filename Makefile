# make demo | make test | make lab | make docs — each builds the virtual environment .venv first if there is none.
VENV := .venv
BIN := $(VENV)/bin
PYTHON := python3
INSTALL := $(BIN)/pip install --no-deps
HASHED := $(INSTALL) --require-hashes --requirement
# On Linux, PyPI's torch needs 4.5 GB of CUDA. Without an NVIDIA GPU, we take the small one, if its index can be reached.
NVIDIA := $(shell command -v nvidia-smi)
TORCH := true
ifeq ($(shell uname -s),Linux)
TORCH := $(HASHED) constraints-cuda.txt
ifeq ($(NVIDIA),)
TORCH := $(HASHED) constraints-cpu.txt --retries 1 --index-url https://download.pytorch.org/whl/cpu 2> /dev/null || $(TORCH)
endif
endif

OPENGL := libegl1 libgl1-mesa-dri

# Python compiles a module once, not in each of the hundred processes that the tests start.
unexport PYTHONDONTWRITEBYTECODE

.PHONY: env opengl chromium demo test kernels types cases coverage lab docs wheel clean

env: $(VENV)/.complete

$(VENV)/.complete: pyproject.toml constraints.txt constraints-cpu.txt constraints-cuda.txt
	@echo "Installing into $(VENV): a few minutes, once. As root on Debian or Ubuntu, it also installs"
	@echo "$(OPENGL) into the system by apt-get, if pyvista finds no OpenGL."
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and "Python 3.11 or newer is needed, for example: make PYTHON=python3.12")'
	$(PYTHON) -m venv $(VENV)
	@echo "1 of 2: torch"
	$(TORCH)
	@echo "2 of 2: the other packages"
	$(HASHED) constraints.txt
	PYTHONWARNINGS=ignore $(INSTALL) --no-build-isolation --editable .
	@$(MAKE) --no-print-directory opengl
	touch $@

opengl:  # for pyvista; a failure is no error: without it, pictures show plain skeletons
	@$(BIN)/python -m toolkit.view.render.opengl || { [ "$$(id -u)" = 0 ] && command -v apt-get > /dev/null && \
	    echo "Installing OpenGL into the system, as root: apt-get install $(OPENGL)" && apt-get update -qq && \
	    DEBIAN_FRONTEND=noninteractive apt-get install -qq --no-install-recommends $(OPENGL) > /dev/null 2>&1; } || true

chromium:  # for tests/browser, which are skipped where there is none
	@for name in chromium chromium-browser google-chrome; do command -v $$name && exit; done; \
	if [ "$$(id -u)" = 0 ] && command -v apt-get > /dev/null; then \
	    echo "Installing Chromium into the system, as root: apt-get install chromium"; \
	    apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -qq --no-install-recommends chromium > /dev/null 2>&1; \
	else \
	    echo "Chromium is missing. Debian: sudo apt-get install chromium. Elsewhere: install it, or Google Chrome, on the PATH."; \
	    exit 1; \
	fi

demo: env
	$(BIN)/python -m toolkit demo --out out/demo

test: env
	$(BIN)/ruff check
	$(BIN)/lint-imports
	@$(MAKE) --no-print-directory --jobs 3 kernels types cases

kernels: env  # compiled once; the processes of cases look for their tests, and wait for them
	$(BIN)/python tests/compiled_runtime.py

types: env
	$(BIN)/mypy

cases: env  # three processes for two cores: each waits now and then for a kernel, a browser or a command
	$(BIN)/python -m pytest --numprocesses 3 --dist loadfile --no-loadscope-reorder --nbval-lax --nbval-current-env --nbval-cell-timeout 120 notebooks tests

coverage: env
	mkdir -p out/coverage
	$(BIN)/coverage run -m pytest --numprocesses 2 --dist loadfile --no-loadscope-reorder tests
	$(BIN)/coverage combine --quiet
	$(BIN)/coverage report

lab: env
	PYTHONPATH=$(CURDIR)/notebooks $(BIN)/jupyter lab --ServerApp.root_dir=$(CURDIR) --LabApp.default_url=/lab/tree/notebooks --ServerApp.jpserver_extensions="{'course.server': True}"

docs: env
	$(BIN)/sphinx-build -W --keep-going -b html docs out/docs

wheel: env
	rm -rf build  # setuptools packs what an earlier build left there, renamed modules too
	$(BIN)/pip wheel --quiet --no-deps --no-build-isolation --wheel-dir dist .

clean:
	rm -rf out build dist docs/api docs/docs docs/notebooks *.egg-info .mypy_cache .pytest_cache .ruff_cache .hypothesis
