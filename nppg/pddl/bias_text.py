"""The language bias that is written for a PDDL domain."""

from __future__ import annotations

import warnings
from collections.abc import Collection, Iterable, Sequence

from nppg.bias.language_bias import LanguageBias
from nppg.bias.names import atom, written
from nppg.bias.refinement import KIND, Refiner
from nppg.logic.query import Literal
from nppg.pddl.bias_modes import (
    GROUPS,
    Signature,
    Tested,
    action_types,
    constants,
    equalities,
    modes,
    signatures,
    supertypes,
)
from nppg.pddl.effects_text import features
from nppg.pddl.hierarchy import above
from nppg.pddl.model import Domain
from nppg.pddl.names import Names

MOST_TESTS = 400

_TEXT = """\
# Written for the PDDL domain {name}: what a policy may test. docs/language_bias.md is the reference.
# At the root of a tree there are {count} tests{each}.

action:
{actions}
{subtypes}
types:
{types}

modes:
{modes}

lookahead: 1
max_variables: {variables}
tree: {{max_depth: {depth}, min_examples: 2}}
options: {options}
"""

# Of worlds where an action has one outcome and the goal is all that is wanted, and of others.
WAYS = (
    "{imitation: self, step: second-order, models: per-action, discount: 0.95, floor: 0.1, min_examples: 200,\n"
    "  replay: 1000, detours: 3, regularisation_growth: 0.05}"
)
_RETURNS = "{step: second-order, discount: 0.95, min_examples: 500}"


def bias_text(
    domain: Domain,
    names: Names,
    goal_predicates: Iterable[str],
    roads: Collection[str] = (),
    most_tests: int = MOST_TESTS,
) -> str:
    """The text of the language bias. `roads`: predicates that are asked about known objects alone, for what one would
    ask of a neighbour, distances along them tell. `most_tests`: groups of modes are left out, in the order of
    bias_modes.GROUPS, until the tree of no kind of action has more tests at its root, or no group is left."""
    all_signatures = [*signatures(domain, names, goal_predicates)]
    used = {type_ for action in domain.actions for type_ in action_types(domain, action)}
    used |= {type_ for each in all_signatures for type_ in each.types if type_}
    types = [Signature(names.types[type_], (parent,), "type") for type_, parent in supertypes(domain, used).items()]
    all_signatures += types
    chosen = [mode for each in all_signatures for mode in modes(each)]
    chosen = [mode for mode in chosen if mode.name not in roads or "-" not in mode.kinds]
    steps = iter(GROUPS)
    while True:
        count = _root_tests(_text(domain, names, all_signatures, chosen, 0), most_tests)
        fewer, step = chosen, next(steps, None) if count > most_tests else None
        while step and fewer == chosen:
            fewer = [left for mode in chosen if (left := mode.without(*step))]
            step = next(steps, None) if fewer == chosen else None
        if not fewer or fewer == chosen:
            return _text(domain, names, all_signatures, chosen, count)
        chosen = fewer


def _root_tests(text: str, most: int) -> int:
    """The most tests at the root of a tree for one kind of action, or any number above `most` if it is above that."""
    bias = LanguageBias.parse(text, "bias.yaml")
    count = 0
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        refiner = Refiner(bias)
        for kind in sorted(range(len(bias.actions)), key=lambda kind: -len(bias.actions[kind].types)):
            query = (Literal(KIND, (kind,)),) if len(bias.actions) > 1 else ()
            count = max(count, len(refiner.refinements(query)))
            if count > most:
                break
    return count


def _text(
    domain: Domain, names: Names, all_signatures: Sequence[Signature], chosen: Sequence[Tested], count: int
) -> str:
    number, does = _number(names), features(domain)
    tested = {mode.name for mode in chosen}
    kept = [each for each in all_signatures if each.name in tested]
    actions = [(names.actions[action.name], action_types(domain, action)) for action in domain.actions]
    same = equalities(domain)
    used = {type_ for _, types in actions for type_ in types} | set(same)
    used |= {type_ for each in kept for type_ in each.types if type_}
    above_used = [
        f"  {names.types[type_]}: {names.types[parent]}"
        for type_, parent in supertypes(domain, used).items()
        if type_ in used and any(each in used for each in above(domain, type_)[1:])
    ]
    lines = [_mode(mode) for mode in chosen]
    lines += [f"  - equal(+{names.types[type_]}, +{names.types[type_]})" for type_ in same]
    lines += [_constants(names.types[type_], own) for type_, own in constants(domain).items() if type_ in used]
    lines += [f'  - "+{number} =< #"'] if any(mode.family == "number" for mode in chosen) else []
    subtypes = "\n".join(["", "subtypes:", *above_used, ""]) if above_used else ""
    types = "\n".join(
        f"  {each.name}: [{', '.join(names.types[type_] if type_ else number for type_ in each.types)}]"
        for each in kept
    )
    returns = does.chance or does.reward
    return _TEXT.format(
        name=domain.name,
        count=count,
        each=" for one kind of action at most" if len(actions) > 1 else "",
        actions="\n".join(
            f"  - {atom(name, [f'+{names.types[type_]}' for type_ in types])}" for name, types in actions
        ),
        subtypes=subtypes,
        types=types,
        modes="\n".join(lines),
        variables=4 if returns else 2,
        depth=4 if returns or len(actions) == 1 else 3,  # below the kind of action
        options=_RETURNS if returns else WAYS,
    )


def _inputs(names: Names, types: Iterable[str]) -> list[str]:
    return [f"+{names.types[type_]}" for type_ in types]


def _constants(type_: str, found: Sequence[str]) -> str:
    return f"  - equal(+{type_}, [{', '.join(map(written, found))}])"


def _mode(mode: Tested) -> str:
    return f'  - {{literal: "{mode}", lookahead: 1}}' if mode.lookahead else f"  - {mode}"


def _number(names: Names) -> str:
    """The type of numbers, which no type of the domain is called."""
    name = "number"
    while name in names.types.values():
        name += "_"
    return name
