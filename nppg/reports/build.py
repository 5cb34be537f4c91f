"""The report of runs: what was learned, how, and what the policy does and why."""

from __future__ import annotations

import shlex
import warnings
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from html import escape
from importlib.metadata import version
from pathlib import Path
from typing import Any

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.files import locate
from nppg.errors import NppgError
from nppg.experiments.progress import title
from nppg.policy.policy import Policy
from nppg.policy.sentences import sentences
from nppg.reports.chart import Line, chart, legend
from nppg.reports.episodes import Drawing, Player, played
from nppg.reports.made import made_html, tiles_of
from nppg.reports.page import Page, Section, note
from nppg.reports.proofs import certificates, proof_html, proof_of
from nppg.reports.reading import paths, rules_html, tree_html
from nppg.reports.runs import Run, experiments, lines_of, runs_in
from nppg.worlds.opening import language_bias_of, with_problems
from nppg.worlds.problems import sorted_out

EPISODES = 4  # of each policy
TREES = 12  # of a policy that are drawn


@dataclass(frozen=True)
class Wishes:
    """What a report is to have: so many `episodes` of each policy, from this seed, in the domain with these parameters
    and problems; and whether the policies are proved."""

    episodes: int = EPISODES
    seed: int = 0
    parameters: Mapping[str, int | float | str] = field(default_factory=dict)
    problems: Sequence[str] = ()
    prove: bool = False


@dataclass(frozen=True)
class Reading:
    """A policy that the page is about: what it is called, where it is, and whose sentences explain it."""

    name: str
    file: Path
    policy: Policy
    bias: LanguageBias


def report(folders: Sequence[Path], wishes: Wishes | None = None) -> str:
    """The page about the runs in these folders. Raises NppgError."""
    return page_of(folders, wishes or Wishes()).html()


def page_of(folders: Sequence[Path], wishes: Wishes) -> Page:
    """The same before it is HTML."""
    runs = runs_in(folders)
    best = max(runs, key=lambda run: run.merit, default=None)
    readings = [_reading(file.stem, file, wishes) for file in folders if file.is_file()]
    readings += _readings(best, wishes) if best else []
    player, drawn = Player(), _Trees()
    weights = []
    for reading in readings:
        episodes = played(reading.policy, wishes.episodes, wishes.seed)
        weights.append(player.add(reading.name, reading.policy, reading.bias, episodes))
    lines = lines_of(list(experiments(runs)), best.measure) if best else []
    proofs = _proofs(readings, wishes, player)
    sections = [
        Section("learned", "Rules", "What was learned", _learned(readings, weights, best, runs)),
        *([Section("curves", "Curves", "How it was learned", _curves(lines, best.measure))] if best and lines else []),
        *([Section("episodes", "Episodes", "What it does, and why", _PLAYER)] if wishes.episodes else []),
        Section("trees", "Trees", "The trees", drawn.html(readings, weights)),
        *([Section("proof", "Proof", "What is proven", proofs)] if proofs else []),
        Section("made", "Files", "How it was made", _made(folders, best, runs, readings)),
    ]
    lead = ", ".join(each.name for each in readings).capitalize()
    if best:
        lead = f"Learned by {best.learner}{f', in {len(runs)} runs' if len(runs) > 1 else ''}."
    name = best.title if best else title(readings[0].policy.domain)
    tiles = tiles_of(best, runs) if best else [(f"{size:,}", what) for what, size in readings[0].policy.sizes().items()]
    data = {**player.data(), "trees": drawn.data}
    foot = f"Written by nppg {version('nppg')}. This page needs no network and tells nobody that it is read."
    return Page(name, lead, tiles, sections, foot, data)


def _readings(run: Run, wishes: Wishes) -> list[Reading]:
    """The policies of a run: distilled rules, where there are some, and what it has learned."""
    found = []
    for name, file in (("the rules", run.folder / "rules.pl"), ("the learned policy", run.folder / "model.pl")):
        if file.is_file() or name != "the rules":
            found.append(_reading(name, file, wishes))
    return found


def _reading(name: str, file: Path, wishes: Wishes) -> Reading:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        policy = Policy.load(file, dict(wishes.parameters))
    policy.domain = with_problems(policy.domain, *sorted_out(list(wishes.problems)))
    return Reading(name, file, policy, _words(policy))


def _words(policy: Policy) -> LanguageBias:
    """The bias that has the sentences: the one that the model names, else the one that goes with its domain."""
    if "bias" in policy.facts:
        with suppress(NppgError):
            return LanguageBias.load(locate(policy.bias.file, "language_bias", ".yaml"))
    with suppress(NppgError):
        return language_bias_of(policy.domain)
    return policy.bias


def _learned(readings: Sequence[Reading], weights: Sequence[list[int]], best: Run | None, runs: Sequence[Run]) -> str:
    first = readings[0]
    count = len(first.policy.trees)
    parts = []
    if best and len(runs) > 1:
        parts.append(note(f"Of {len(runs)} runs this page reads the best one, by its greedy policy: {best.folder}."))
    if count == 1:
        parts.append(note("The first rule that holds of an action gives its value. The highest value is chosen."))
        parts.append(rules_html(first.policy, 1, first.bias))
    elif count:
        number = weights[0][0] + 1
        parts.append(
            note(
                f"The policy is a sum of {count:,} trees, each a list of rules. These are the rules of tree {number}, "
                "which weighs most in the episodes below; nppg distill makes few rules of all of them."
            )
        )
        parts.append(rules_html(first.policy, number, first.bias))
    else:
        parts.append(note("The policy is no sum of trees: there are no rules to be read."))
    return "".join(parts)


def _curves(lines: Sequence[Line], measure: str) -> str:
    several = " Of several runs the mean, with the standard deviation shaded." if any(x.runs > 1 for x in lines) else ""
    return (
        f'<figure class="frame">{chart(lines, measure, style=False)}<ul class="legend">{legend(lines)}</ul>'
        f"<figcaption>Solid: the stochastic policy that learns. Dashed: the greedy one.{several}</figcaption></figure>"
    )


_PLAYER = (
    note("Each state with the actions that are allowed in it and their probabilities. The rules below gave the chosen "
         "action its value; click another action for what gave it its own.")
    + '<div id="player" class="player"></div><p class="keys"><kbd>←</kbd> <kbd>→</kbd> step, <kbd>Home</kbd> '
    "<kbd>End</kbd> first and last, <kbd>space</kbd> play, <kbd>[</kbd> <kbd>]</kbd> other episodes</p>"
    "<noscript><p>The player needs JavaScript.</p></noscript>"
)


class _Trees:
    """The pictures, and what their leaves unfold to."""

    def __init__(self) -> None:
        self.data: list[dict[str, Any]] = []

    def html(self, readings: Sequence[Reading], weights: Sequence[list[int]]) -> str:
        """Those of each policy that weigh most."""
        parts = [note("Success goes to the left. Click a leaf for the way that leads there, its rule and examples.")]
        for index, (reading, order) in enumerate(zip(readings, weights, strict=True)):
            if not order:
                continue
            count = len(order)
            shown = f", the {TREES} of {count:,} trees that weigh most in the episodes" if count > TREES else ""
            parts.append(f"<h3>{escape(reading.name.capitalize())}{shown}</h3>")
            for place, tree in enumerate(order[:TREES]):
                comment = escape(reading.policy.comments[tree])
                is_open = " open" if place == 0 else ""
                picture = tree_html(reading.policy, tree + 1, len(self.data))
                head = f"<summary>Tree {tree + 1} <small>{comment}</small></summary>"
                parts.append(f'<details class="card"{is_open}>{head}<div>{picture}</div></details>')
                self.data.append(self._told(index, reading, tree))
        return "".join(parts)

    @staticmethod
    def _told(index: int, reading: Reading, tree: int) -> dict[str, Any]:
        policy, bias = reading.policy, reading.bias
        return {
            "policy": index,
            "tree": tree,
            "paths": list(paths(policy.trees[tree], policy.bias)),
            "rules": policy.rules(tree + 1),
            "said": sentences(policy, tree + 1, bias) if bias.sentences else [],
        }


def _proofs(readings: Sequence[Reading], wishes: Wishes, player: Player) -> str:
    parts = []
    for reading in readings:
        proofs = certificates(reading.file)
        if not proofs and wishes.prove:
            proofs = [proof_of(reading.policy, reading.file)]
        if proofs:
            drawing = Drawing(reading.policy.domain, [])
            parts.append(f"<h3>{escape(reading.name.capitalize())}</h3>")
            parts += [proof_html(proof, lambda state, own=drawing: player.drawn(own(state))) for proof in proofs]  # type: ignore[misc]
    return "".join(parts)


def _made(folders: Sequence[Path], best: Run | None, runs: Sequence[Run], readings: Sequence[Reading]) -> str:
    files = [reading.file for reading in readings]
    files += [reading.policy.domain.path for reading in readings] + [Path(reading.bias.file) for reading in readings]
    more = [["nppg", "show", str(readings[0].file), "--explain"], ["nppg", "report", *map(str, folders)]]
    return made_html(best, runs, list(dict.fromkeys(files)), list(map(shlex.join, more)))

