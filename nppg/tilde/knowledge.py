"""Background knowledge and facts, loaded: what tests are asked of.

A file of clauses is written and loaded as a domain file is, under the same guard. The facts that hold for all examples
are its static ones, those of one example its fluents. A predicate that is given in more than one of these ways, by
clauses too, is put together from them.
"""

from __future__ import annotations

import tempfile
from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import cached_property
from pathlib import Path
from typing import TypeVar

from nppg.bias.declarations import Argument, Follower
from nppg.bias.language_bias import LanguageBias
from nppg.bias.names import written
from nppg.bridge.prolog import ask
from nppg.bridge.terms import Ground, ground, plain
from nppg.errors import NppgError
from nppg.logic.query import OPEN, Constant, constant
from nppg.tilde.task import Example, Task
from nppg.worlds.domain import Domain
from nppg.worlds.state import Interpretation, Static, standard_order

Indicator = tuple[str, int]
_Arg = TypeVar("_Arg", bound="int | Argument")

_NAME = "background"


def indicator(fact: Ground) -> Indicator:
    """The name and the number of arguments of a fact."""
    return (str(fact[0]), len(fact) - 1) if isinstance(fact, tuple) else (str(fact), 0)


class Knowledge:
    """The background of a task with all its predicates, `known` ones among them that this task may have no facts of.
    Raises NppgError for what is wrong with the background, located in the task's file."""

    def __init__(self, task: Task, known: Iterable[Indicator] = ()):
        self.task = task
        shared = {indicator(fact) for fact in task.facts}
        own = {indicator(fact) for each in task.examples for fact in each.facts}
        by_clauses = _defined(task.background)
        given = defaultdict(list)
        for kind, indicators in (("static", shared), ("fluent", own)):
            for each in sorted(indicators):
                given[each].append(kind)
        self._names: dict[tuple[str, Indicator], str] = {}  # under which facts are kept, by how they are given
        header, links = [f":- module({_NAME}, []). :- background."], []
        for each, kinds in given.items():
            apart = len(kinds) > 1 or each in by_clauses
            for kind in kinds:
                name = f"{each[0]} ({kind})" if apart else each[0]
                self._names[kind, each] = name
                header.append(f":- {kind}(/({written(name)}, {each[1]})).")
                links += [_link(each, name)] if apart else []
        header += [f":- discontiguous(/({written(name)}, {arity}))." for name, arity in sorted(by_clauses)]
        lacking = {*known} - {*given} - by_clauses
        self.missing = lacking - _pure(lacking)  # those that the task has nothing of
        header += [f":- fluent(/({written(name)}, {arity}))." for name, arity in sorted(self.missing)]
        self.domain = self._load(" ".join(header) + " " + task.background + "\n" + "\n".join(links) + "\n")
        self._static = Static(dict.fromkeys(self._renamed("static", task.facts)))

    def _load(self, text: str) -> Domain:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, f"{_NAME}.pl")
            path.write_text(text, encoding="utf-8")
            try:
                domain = Domain(path)
            except NppgError as error:
                file = self.task.background_file or "the background knowledge"
                own = str(path)
                raise NppgError(
                    replace(each, file=each.file.replace(own, file), message=each.message.replace(own, file))
                    for each in error.problems
                ) from None
        domain.path = Path(self.task.background_file or path.name)
        return domain

    def _renamed(self, kind: str, facts: Iterable[Ground]) -> list[Ground]:
        found = [each[0] if isinstance(each, tuple) and len(each) == 1 else each for each in plain(facts)]
        if not any(kind == each and name != own[0] for (each, own), name in self._names.items()):
            return found
        names = {own: name for (each, own), name in self._names.items() if each == kind}
        return [
            (names[indicator(fact)], *fact[1:]) if isinstance(fact, tuple) else names[indicator(fact)] for fact in found
        ]

    @cached_property
    def predicates(self) -> set[Indicator]:
        """All that a test may be about: what is given, and what Prolog has that only looks at its arguments."""
        found = {*self.domain.predicates, *self.domain.fluents, *self.domain.static}
        found |= _pure({*self.asked(self.task.bias)} - found)
        return found - {(name, own[1]) for (_, own), name in self._names.items() if name != own[0]}

    @staticmethod
    def asked(bias: LanguageBias) -> tuple[Indicator, ...]:
        """The predicates that the tests of a bias are about."""
        found = {(mode.name, len(mode.args)) for mode in bias.modes}
        found |= {(each.name, len(each.args)) for lookahead in bias.lookaheads for each in lookahead.followers}
        return tuple(sorted(each for each in found if each[0] not in ("=", *OPEN)))

    def states(self, examples: Sequence[Example]) -> list[Interpretation]:
        """In which each example's tests are asked; those without facts of their own share one."""
        common = Interpretation((), self._static)
        return [
            Interpretation(sorted({*self._renamed("fluent", each.facts)}, key=standard_order), self._static)
            if each.facts
            else common
            for each in examples
        ]

    def actions(self, examples: Sequence[Example]) -> list[Ground]:
        """The keys, as what the table of tests takes for actions."""
        name = self.task.bias.actions[0].name
        return [(name, *each.key) if each.key else name for each in examples]

    def solutions(self, name: str, arity: int, example: Example | None = None) -> list[tuple[Ground, ...]]:
        """All answers of a predicate, asked with all arguments free, in order: of what holds for one example, or all.
        Raises NppgError where it cannot be asked so."""
        (state,) = self.states([example or Example()])
        self.domain.visit(state)
        return [ground(each) for each in ask("answers_of", self.domain.module, name, arity)]

    def complete(self, bias: LanguageBias) -> LanguageBias:
        """The bias with the constants that the data has in place of `#` without any."""
        found: dict[tuple[str, int, int], tuple[Constant, ...]] = {}

        def completed(name: str, args: tuple[_Arg, ...]) -> tuple[_Arg, ...]:
            own = list(args)
            for i, arg in enumerate(own):
                if isinstance(arg, Argument) and arg.kind == "#" and not arg.constants and name not in OPEN:
                    place = name, len(own), i
                    if place not in found:
                        found[place] = self._constants(*place)
                    own[i] = replace(arg, constants=found[place])
            return tuple(own)

        return replace(
            bias,
            modes=tuple(replace(each, args=completed(each.name, each.args)) for each in bias.modes),
            lookaheads=tuple(
                replace(template, followers=tuple(Follower(name, completed(name, args)) for name, args in parts))
                for template in bias.lookaheads
                if (parts := [(each.name, each.args) for each in template.followers])
            ),
        )

    def _constants(self, name: str, arity: int, place: int) -> tuple[Constant, ...]:
        """What stands in a place of the answers of a predicate, over all examples."""
        if (name, arity) not in self.predicates:
            return ()
        facts = [*self.task.facts, *(fact for each in self.task.examples for fact in each.facts)]
        if all(own != (name, arity) or new == name for (_, own), new in self._names.items()) and any(
            own == (name, arity) for _, own in self._names
        ):
            values = {fact[1 + place] for fact in facts if isinstance(fact, tuple) and indicator(fact) == (name, arity)}
        else:
            examples = [each for each in self.task.examples if each.facts] or [Example()]
            values = {answer[place] for each in examples for answer in self.solutions(name, arity, each)}
        return tuple(constant(each) for each in sorted(values, key=standard_order) if not isinstance(each, tuple))


def _pure(predicates: Iterable[Indicator]) -> set[Indicator]:
    """Those that Prolog has and that only look at their arguments."""
    return {(name, arity) for name, arity in ask("harmless_built_in", [list(each) for each in sorted(predicates)])}


def _defined(background: str) -> set[Indicator]:
    """The predicates that a text of Prolog has clauses of."""
    rows = ask("source", background, []) if background.strip() else []
    return {indicator(ground(head)) for _, kind, head, *_ in rows if kind in ("fact", "rule")}


def _link(each: Indicator, name: str) -> str:
    """The clause that adds facts kept under another name to a predicate."""
    args = ", ".join(f"A{i}" for i in range(each[1]))
    head, body = (f"{written(own)}({args})" if args else written(own) for own in (each[0], name))
    return f"{head} :- {body}."
