.DEFAULT_GOAL := help
.PHONY: help setup demo test lint soak bench clean
bin := .venv/bin

help:   ## list these targets
	@sed -n 's/^\([a-z]*\):.*## \(.*\)/\1|\2/p' Makefile | while IFS='|' read -r name text; do printf 'make %-6s %s\n' "$$name" "$$text"; done

setup:  ## make ready what is still missing: SWI-Prolog, .venv, nppg in it
	@./setup

demo: setup  ## learn on(A, B) among ten blocks, distil it into rules, prove them over all starts
	$(bin)/nppg train blocks_world --seed 0 --episodes 2000 --evaluate-every 50 --output runs/demo
	$(bin)/nppg show runs/demo/model.pl --tree 500
	$(bin)/nppg evaluate runs/demo/model.pl --exact
	@echo "The learning curve is in runs/demo/curve.png, the policy in runs/demo/model.pl. Now its rules, distilled:"
	$(bin)/nppg distill runs/demo/model.pl
	$(bin)/nppg prove runs/demo/rules.pl --output runs/demo/proof.json

lint: setup  ## style, types, and the walls between the rooms of nppg/
	$(bin)/ruff check
	$(bin)/mypy nppg
	$(bin)/lint-imports --no-logo

test: lint  ## what lint does, then every test, on all cores
	$(bin)/pytest -q -n auto --dist worksteal

soak: setup  ## what takes minutes to show: runs that are killed, interrupted, damaged; a million steps
	NPPG_SOAK=200 $(bin)/pytest -q -n auto --dist worksteal tests/test_disk.py tests/test_seals.py tests/test_run_machine.py
	NPPG_SOAK=200 $(bin)/pytest -q -s tests/test_soak.py

bench: setup  ## the speed table of docs/performance.md
	$(bin)/python -m benchmarks

clean:  ## remove runs and caches, keep the set-up
	rm -rf runs build dist .coverage .hypothesis .mypy_cache .pytest_cache .ruff_cache .import_linter_cache
	find . -name __pycache__ -not -path './.venv/*' -not -path './.swipl/*' -prune -exec rm -rf {} +
