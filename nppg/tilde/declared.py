"""What readers of formats share: which modes can be asked, and a language bias of what they found."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from nppg.bias.declarations import Argument, Lookahead, Mode, Template, TreeLimits
from nppg.bias.language_bias import LanguageBias
from nppg.bridge.prolog import ask
from nppg.errors import NppgError, Problem, suggestion
from nppg.logic.query import OPEN
from nppg.tilde.program import Background
from nppg.tilde.terms import (
    Indicator,
)

NO_BOUND = 10_000  # existential variables of a query: neither ACE nor Aleph knows a bound
_BUILT_IN = ("=", *OPEN)


def askable(
    modes: Sequence[Mode],
    lookaheads: Sequence[Lookahead],
    base: Background,
    given: Collection[Indicator],
    file: Path,
    left_out: list[Problem],
) -> tuple[tuple[Mode, ...], tuple[Lookahead, ...]]:
    """The modes and templates about predicates that are there: in the background, among the examples' facts `given`, or
    Prolog's own. The others are told. Raises NppgError where no mode is left."""
    wanted = {(mode.name, len(mode.args)) for mode in modes}
    wanted |= {(each.name, len(each.args)) for template in lookaheads for each in template.followers}
    wanted = {each for each in wanted if each[0] not in _BUILT_IN}
    there = base.defined | set(given)
    own = {tuple(each) for each in ask("harmless_built_in", [list(each) for each in sorted(wanted - there)])}
    lacking = {}
    for name, arity in wanted - there - own:
        same = sorted(f"{other}/{n}" for other, n in there if other == name)
        hint = f" (there is {same[0]})" if same else suggestion(name, {other for other, _ in there})
        lacking[name, arity] = base.missing.get((name, arity), f"there is no fact or rule of it{hint}")
    kept = tuple(mode for mode in modes if (mode.name, len(mode.args)) not in lacking)
    left_out += [
        Problem(str(file), mode.line, 0, f"the mode {mode} is left out: {lacking[mode.name, len(mode.args)]}")
        for mode in modes
        if mode not in kept
    ]
    if not kept:
        what = "no mode declares what to test" if not modes else "no mode can be asked"
        raise NppgError([*left_out, Problem(str(file), 0, 0, what)])
    templates = tuple(
        template
        for template in lookaheads
        if not any((each.name, len(each.args)) in lacking for each in template.followers)
    )
    return kept, templates


def looking_ahead(modes: Iterable[Mode], steps: Mapping[Indicator, int], everywhere: int = 0) -> tuple[Mode, ...]:
    """The modes with their lookahead: that of the predicate, or what holds everywhere."""
    return tuple(replace(mode, lookahead=max(everywhere, steps.get((mode.name, len(mode.args)), 0))) for mode in modes)


def bias_of(
    file: Path,
    template: Template,
    types: Mapping[Indicator, tuple[str, ...]],
    modes: tuple[Mode, ...],
    lookaheads: tuple[Lookahead, ...],
    max_lookahead: int,
) -> LanguageBias:
    """A language bias, as if it had been read from a file."""
    found: dict[Indicator, tuple[str, ...]] = {(template.name, len(template.types)): template.types}
    for mode in modes:
        if mode.name not in _BUILT_IN:
            predicate = mode.name, len(mode.args)
            found.setdefault(predicate, types.get(predicate, tuple(arg.type for arg in mode.args)))
    for each in (each for template in lookaheads for each in template.followers):
        predicate = each.name, len(each.args)
        if each.name not in _BUILT_IN and predicate not in found:
            own = tuple(arg.type if isinstance(arg, Argument) else "_" for arg in each.args)
            found[predicate] = types.get(predicate, own)
    by_name: dict[str, tuple[str, ...]] = {}
    for (name, arity), its in found.items():
        by_name[name if name not in by_name else f"{name}/{arity}"] = its
    return LanguageBias(
        file=str(file),
        actions=(template,),
        goal=None,
        types=by_name,
        subtypes={},
        modes=modes,
        max_lookahead=max_lookahead,
        max_variables=NO_BOUND,
        tree=TreeLimits(),
        lookaheads=lookaheads,
    )
