"""The report of runs: what was learned, how, and what the policy does and why."""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.files import locate
from nppg.errors import NppgError
from nppg.policy.policy import Policy
from nppg.reports.chart import chart, legend
from nppg.reports.made import made_html, tiles_of
from nppg.reports.page import Page, Section, note
from nppg.reports.reading import rules_html, tree_html
from nppg.reports.runs import Run, experiments, lines_of, runs_in

TREES = 12  # of a policy that are drawn


@dataclass(frozen=True)
class Reading:
    """A policy that the page is about: what it is called, where it is, and whose sentences explain it."""

    name: str
    file: Path
    policy: Policy
    bias: LanguageBias


def report(folders: Sequence[Path], parameters: Mapping[str, int | float | str] | None = None) -> str:
    """The page about the runs in these folders. Raises NppgError."""
    runs = runs_in(folders)
    groups = list(experiments(runs))
    best = max(runs, key=lambda run: run.merit)
    readings = readings_of(best, parameters or {})
    lines = lines_of(groups, best.measure)
    sections = [
        Section("learned", "Rules", "What was learned", _learned(readings, best, runs)),
        *([Section("curves", "Curves", "How it was learned", _curves(lines, best.measure))] if lines else []),
        Section("trees", "Trees", "The trees", _trees(readings)),
        Section("made", "Files", "How it was made", _made(best, runs, readings)),
    ]
    lead = f"{best.learner}, {len(runs)} runs" if len(runs) > 1 else f"{best.learner}, {best.folder}"
    return Page(
        best.title, lead, tiles_of(best, runs), sections, f"Written by nppg {version('nppg')}.", {}
    ).html()


def readings_of(run: Run, parameters: Mapping[str, int | float | str]) -> list[Reading]:
    """The policies of a run: distilled rules, where there are some, and what it has learned."""
    found = []
    for name, file in (("the rules", run.folder / "rules.pl"), ("the learned policy", run.folder / "model.pl")):
        if file.is_file() or name != "the rules":
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                policy = Policy.load(file, dict(parameters))
            found.append(Reading(name, file, policy, _words(policy)))
    return found


def _words(policy: Policy) -> LanguageBias:
    """The bias that has the sentences, if it is found: the one that the model names, or that goes with its domain."""
    with suppress(NppgError, OSError):
        return LanguageBias.load(locate(policy.bias.file, "language_bias", ".yaml"))
    return policy.bias


def _learned(readings: Sequence[Reading], best: Run, runs: Sequence[Run]) -> str:
    first = readings[0]
    count = len(first.policy.trees)
    parts = []
    if len(runs) > 1:
        parts.append(note(f"Of the {len(runs)} runs the one that is read here is the best by its greedy policy: {best.folder}."))
    if count == 1:
        parts.append(note("The first rule that holds decides; the action of the highest value is the best."))
        parts.append(rules_html(first.policy, 1, first.bias))
    elif count:
        parts.append(note(f"The policy is a sum of {count:,} trees. nppg distill makes few rules of it; here is the first tree."))
        parts.append(rules_html(first.policy, 1, first.bias))
    else:
        parts.append(note("The policy is no sum of trees: there are no rules to be read."))
    return "".join(parts)


def _curves(lines: Sequence, measure: str) -> str:
    return (
        f'<figure class="frame">{chart(lines, measure, style=False)}<ul class="legend">{legend(lines)}</ul>'
        "<figcaption>Solid: the stochastic policy that learns. Dashed: its greedy one. Of several runs the mean, with "
        "the standard deviation shaded.</figcaption></figure>"
    )


def _trees(readings: Sequence[Reading]) -> str:
    parts = []
    for reading in readings:
        count = len(reading.policy.trees)
        for number in range(1, min(count, TREES) + 1):
            comment = reading.policy.comments[number - 1]
            is_open = " open" if number == 1 else ""
            parts.append(
                f'<details class="card"{is_open}><summary>{reading.name}, tree {number} <small>{comment}</small></summary>'
                f"<div>{tree_html(reading.policy, number)}</div></details>"
            )
    return "".join(parts)


def _made(best: Run, runs: Sequence[Run], readings: Sequence[Reading]) -> str:
    files = [reading.file for reading in readings]
    files += [best.folder / str(each.get("file")) for each in (best.domain, best.summary.get("bias") or {})]
    return made_html(best, runs, files, [f"nppg show {readings[-1].file} --explain"])
