# `make demo` runs the main job on a bare machine, `make test` proves it; the rest is for daily work.
.PHONY: setup demo test run check lock bench clean

PYTHON := .venv/bin/python
# Two numeric threads at most: the machines are small and the tests run side by side.
export OMP_NUM_THREADS ?= 2
# A session is never overwritten, so every demonstration gets a folder of its own.
DEMO_OUT ?= out/demo_$(shell date +%Y%m%d_%H%M%S)

setup:
	@./tools/setup.sh

demo: setup
	@mkdir -p $(DEMO_OUT)
	$(PYTHON) -m beltgui.cli.main demo --table --out $(DEMO_OUT)

run: setup
	$(PYTHON) -m beltgui.cli.main gui --sim

test: setup
	QT_QPA_PLATFORM=offscreen $(PYTHON) -m pytest -n auto --dist loadfile -q

check: setup
	.venv/bin/ruff check .
	.venv/bin/mypy
	.venv/bin/lint-imports

bench: setup
	$(PYTHON) -m benchmarks

# Needs uv; the lock names versions and hashes and no place they come from.
lock:
	uv pip compile pyproject.toml --group dev --universal --python-version 3.11 \
	    --generate-hashes --no-emit-index-url --no-header --output-file requirements.lock

clean:
	rm -rf out build dist .mypy_cache .ruff_cache .pytest_cache .hypothesis .import_linter_cache
