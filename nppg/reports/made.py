"""How runs were made: options, versions, hashes, and the commands that make them again."""

from __future__ import annotations

import shlex
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

from nppg.bridge.files import sha256
from nppg.experiments.learners import LEARNERS
from nppg.reports.page import command, table
from nppg.reports.runs import Run

_VERSIONS = ("nppg", "prolog", "python", "numpy")


def made_html(run: Run | None, runs: Sequence[Run], files: Sequence[Path], more: Sequence[str]) -> str:
    """All of it for one run, if there is one, the hashes of these files, and the commands: this run's, and what `more`
    there are."""
    hashes = [(file.name, sha256(file.read_bytes())) for file in files if file.is_file()]
    parts = ["<h3>SHA-256 of the files</h3>", table(hashes, "hash"), "<h3>Commands</h3>"]
    if run is None:
        return "".join([*parts, *map(command, more)])
    options, usual = changed(run)
    versions = [(name, run.summary[name]) for name in _VERSIONS if name in run.summary]
    made = [
        '<div class="two"><div><h3>Options that were set</h3>',
        table(options) if options else "<p>None: all are as they are by default.</p>",
        "</div><div><h3>Versions</h3>",
        table(versions),
        "</div></div>",
        '<details class="card"><summary>All other options <small>as they are by default</small></summary><div>',
        table(usual),
        "</div></details>",
    ]
    return "".join([*made, *parts, command(train_command(run, runs)), *map(command, more)])


def changed(run: Run) -> tuple[list[tuple[str, Any]], list[tuple[str, Any]]]:
    """The options of a run that are not as they are by default, with the seed, and those that are."""
    learner = LEARNERS.get(run.learner)
    usual = asdict(learner()) if learner else {}
    set_: list[tuple[str, Any]] = []
    left: list[tuple[str, Any]] = []
    for name, value in run.options.items():
        other = name not in usual or value != usual[name] or name in ("seed", "episodes")
        (set_ if other else left).append((name.replace("_", " "), value))
    return set_, left


def train_command(run: Run, runs: Sequence[Run]) -> str:
    """What trains again as this run was, with the seeds of all of `runs`."""
    words = ["nppg", "train", str(run.folder / str(run.domain.get("file", "")))]
    bias = run.summary.get("bias")
    if isinstance(bias, dict):
        words += ["--bias", str(run.folder / str(bias.get("file", "")))]
    parameters = run.domain.get("parameters")
    for name, value in parameters.items() if isinstance(parameters, dict) else ():
        words += ["--set", f"{name}={value}"]
    words += ["--learner", run.learner]
    seeds = sorted({int(each.options["seed"]) for each in runs if isinstance(each.options.get("seed"), int)})
    for name, value in _raw(run):
        if name == "seed":
            words += ["--seeds", ",".join(map(str, seeds))] if len(seeds) > 1 else ["--seed", str(value)]
        else:
            words += [f"--{name.replace('_', '-')}", str(value)]
    judging = run.summary.get("curve")
    for name, value in judging.items() if isinstance(judging, dict) else ():
        if value is not None:
            words += [f"--{name.replace('_', '-')}", str(value)]
    return shlex.join([*words, "--output", "runs/again"])


def _raw(run: Run) -> list[tuple[str, Any]]:
    names = {name for name, _ in changed(run)[0]}
    return [(name, value) for name, value in run.options.items() if name.replace("_", " ") in names]


def tiles_of(run: Run, runs: Sequence[Run]) -> list[tuple[str, str]]:
    """What a run, the best of `runs`, has come to in few numbers."""
    last: Mapping[str, str] = run.curve[-1] if run.curve else {}
    found = []
    names = {"success": ("greedy_success", "success"), "return": ("greedy_return", "mean_return")}[run.measure]
    for name, what in zip(names, ("greedy policy", "stochastic policy"), strict=True):
        if last.get(name):
            value = float(last[name])
            shown = f"{100 * value:.4g} %" if run.measure == "success" else f"{value:.4g}"
            exact = ", exact" if last.get("exact") == "1" else ", sampled"
            found.append((shown, f"{run.measure} of the {what}{exact}"))
    for name in ("episodes", "trees", "leaves"):
        if isinstance(run.summary.get(name), int):
            found.append((f"{run.summary[name]:,}", name))
    if len(runs) > 1:
        found.append((str(len(runs)), "runs"))
    if isinstance(run.summary.get("seconds"), int | float):
        found.append((f"{run.summary['seconds']:.3g} s", "of learning"))
    return found
