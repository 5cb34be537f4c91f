"""A loaded domain file, and which state is current there."""

from __future__ import annotations

import tempfile
from collections.abc import Iterable, Mapping, Sequence
from operator import is_
from pathlib import Path
from weakref import WeakValueDictionary

from nppg.bridge.bounds import bounded
from nppg.bridge.files import write_files
from nppg.bridge.prolog import ask, drop_with
from nppg.bridge.terms import Compound, Ground, compounds, ground, plain, texts
from nppg.errors import NppgError, Problem, suggestion
from nppg.worlds.state import (
    NOTHING,
    FactNumbers,
    Interpretation,
    Static,
    interpretation_of,
    static_facts,
)
from nppg.worlds.world import Outcome

_TRUTH = {True: "true", False: "false"}


class Loaded:
    """A loaded domain file: its module in Prolog, which stays until the last Domain of it is dropped, and which of the
    states that these Domains visit is the current one."""

    def __init__(self, path: Path, given: Mapping[str, int | float | str], source: bytes, trust: bool):
        if not trust:
            ask("dictionaries", _TRUTH[bounded(source, str(path))])
        self.module, entries = ask("load", str(path.resolve()), [list(each) for each in given.items()], _TRUTH[trust])
        drop_with(self, "unload", self.module)
        self.used = {name: Path(file).read_bytes() for name, file in ask("used_files", self.module)}
        self.origin = (path, given, source, trust, self.used)
        self.description = dict(entries)
        self.current: Sequence[Ground] | None = None
        self.situation: list | None = None  # that of the current state, where it is known
        self._are_static: dict[tuple[str, int], bool] = {}  # predicates
        self.legal: list[Ground] = []  # its legal actions, where they are known
        self._answers: list = []  # a table's about these, where they are known
        self._table = ""  # the one that has been asked about these, and is likely to be asked in the next state, too
        self._static: WeakValueDictionary[int, Static] = WeakValueDictionary()
        self._names = {tuple(each) for each in self.description["static"]}
        self._actions = {tuple(each) for each in self.description["actions"]}  # empty where they cannot be told
        self._declared = self._names | {tuple(each) for each in self.description["fluents"]}
        self._made: tuple[object, Interpretation] = (None, Interpretation())  # what `interpreted` has been asked last

    def number(self, static: Static) -> int:
        """Under which Prolog keeps these static facts, which it is told when they are first needed."""
        if static is NOTHING:
            return 0
        if self not in static.numbers:
            self._keep(static, ask("keep_static", self.module, plain(static.facts)))
        return static.numbers[self]

    def _keep(self, static: Static, number: int) -> None:
        """Notes that Prolog keeps these static facts, for as long as somebody refers to them."""
        static.numbers[self] = number
        if number:
            self._static[number] = static
            drop_with(static, "static_drop", self.module, number)

    def interpreted(self, state: Sequence[Ground]) -> Interpretation:
        """A state as an Interpretation: one that somebody has made of facts may have static ones among them."""
        if type(state) is Interpretation:
            return state
        if self._made[0] is not state or not isinstance(state, tuple):  # others may have changed
            found = interpretation_of(state)
            self.must_be_declared(found)
            static = [each for each in found if _indicator(each) in self._names]
            own = [each for each in found if _indicator(each) not in self._names]
            self._made = (state, Interpretation(own, static_facts(static)))
        return self._made[1]

    def must_be_declared(self, state: Interpretation) -> None:
        """Raises NppgError where a fact of a state is of no declared fluent, as those of another domain are."""
        if not {*map(_indicator, state.facts)} <= self._declared:
            wrong = next(each for each in state.facts if _indicator(each) not in self._declared)
            raise self._unknown(wrong, "fact of a fluent", self._declared)

    def action(self, action: Ground) -> Ground:
        """An action that somebody may have made. Raises NppgError for what is none of the domain's kinds."""
        if type(action) is not Compound:
            (action,) = plain([action])
            if self._actions and _indicator(action) not in self._actions:
                raise self._unknown(action, "action", self._actions)
        return action

    def _unknown(self, term: Ground, what: str, declared: Iterable[tuple[Ground, int]]) -> NppgError:
        known = sorted(f"{name}/{arity}" for name, arity in declared)
        near = suggestion("{}/{}".format(*_indicator(term)), known) or f"; it has {', '.join(known)}"
        shown = texts([term])[0] if isinstance(term, str | tuple) else term
        return NppgError([Problem(str(self.origin[0]), 0, 0, f"{shown} is no {what} of the domain{near}")])

    def begun(self, question: str, *args: int) -> Interpretation | None:
        """The state that a question makes current, which answers with its static facts' number and its facts."""
        held = list(self._static.values())  # none of them is to be dropped while its number is under way
        self.forget()
        start = ask(question, self.module, *args)
        if not start:
            return None
        number, facts = start
        static = self._static.get(number) if number else NOTHING
        if static is None:
            static = Static(lambda: ground(ask("static_of", self.module, number)))
            self._keep(static, number)
        self.current = state = Interpretation(ground(facts), static)
        held.clear()
        return state

    def visit(self, state: Sequence[Ground]) -> None:
        """Makes a state current in Prolog."""
        before = self.current
        if state is before and state is not None:
            return
        self.forget()
        change = None
        if isinstance(before, Interpretation) and isinstance(state, Interpretation):
            change = before.difference(state)
        if change:
            ask("step", self.module, *map(list, change))
        else:
            own = self.interpreted(state)
            self.must_be_declared(own)
            ask("visit", self.module, self.number(own.static), list(own.facts))
        self.current = state if isinstance(state, tuple | Interpretation) else None  # others may be changed

    def act(self, before: Interpretation, action: Ground, lean: bool) -> tuple[float, Interpretation]:
        """The reward for an action in the current state `before`, and the state that it leads to, which becomes the
        current one. Its situation is brought along, and what the table answers that was asked before."""
        self.forget()
        table, self._table = self._table, ""
        reward, gone, new, self.situation, answers = ask("act", self.module, lean, table, action)
        self._answers = [table, *answers] if answers else []
        self.current = following = before.changed(ground(gone), ground(new))
        return reward, following

    def outcomes(self, before: Interpretation, actions: Sequence[Ground]) -> list[list[Outcome]]:
        """What each of the actions may lead to from the current state `before`."""
        return [
            [Outcome(each, before.changed(ground(gone), ground(new))) for each, gone, new in found]
            for found in ask("outcomes_of", self.module, actions)
        ]

    def neighbours(self, before: Interpretation) -> list[tuple[Ground, list[Outcome]]]:
        """The same for every legal action, where the states' facts are wanted: they are made at once."""
        facts, found = ask("neighbours", self.module)
        own, static = ground(facts), before.static

        def successor(facts: list) -> Interpretation:
            return Interpretation((own[fact] if isinstance(fact, int) else ground(fact) for fact in facts), static)

        actions = compounds([action for action, _ in found])
        return [
            (action, [Outcome(probability, successor(facts)) for probability, facts in outcomes])
            for action, (_, outcomes) in zip(actions, found, strict=True)
        ]

    def answers_about(self, table: str, actions: Sequence[Ground]) -> tuple[list, list]:
        """What a table answers about actions in the current state."""
        if len(actions) == len(self.legal) and all(map(is_, actions, self.legal)):
            self._table = table
            if self._answers and self._answers[0] == table:
                return self._answers[1], self._answers[2]
        kinds, words = ask("answers", table, plain(actions))
        return kinds, words

    def answers_in(self, table: str, pairs: Sequence[tuple[Sequence[Ground], Sequence[Ground]]]) -> tuple[list, list]:
        """What a table answers about actions in each of some states, one after the other; the last becomes current."""
        states = [self.interpreted(state) for state, _ in pairs]
        given = [plain(actions) for _, actions in pairs]
        facts = FactNumbers()
        asked, before = [], frozenset(facts.of(states[0]))
        for state, actions in zip(states, given, strict=True):
            own = facts.of(state)
            now = frozenset(own)
            new = [each for each in own if each not in before]
            asked.append([self.number(state.static), [*(before - now)], new, actions])
            before = now
        self.visit(states[0])
        self.forget()
        kinds, words = ask("answers_in", table, facts.facts, asked)
        self.current = pairs[-1][0]
        return kinds, words

    def is_static(self, name: str, arity: int) -> bool:
        """Whether no answer of a predicate can depend on a fluent, as far as the program tells."""
        if (name, arity) not in self._are_static:
            self._are_static[name, arity] = ask("is_static", self.module, name, arity) == "true"
        return self._are_static[name, arity]

    def forget_answers(self) -> None:
        """To be called where a table will answer in another way."""
        self._answers = []

    def forget(self) -> None:
        """To be called by who makes another state current behind this object's back."""
        self.current = self.situation = None
        self.legal, self._answers = [], []

    def __copy__(self) -> Loaded:
        return self

    def __deepcopy__(self, memo: object) -> Loaded:
        return self

    def __reduce__(self) -> tuple:
        return _loaded_again, self.origin


def _indicator(fact: Ground) -> tuple[Ground, int]:
    return (fact[0], len(fact) - 1) if isinstance(fact, tuple) else (fact, 0)


def _loaded_again(
    path: Path, given: Mapping[str, int | float | str], source: bytes, trust: bool, used: Mapping[str, bytes]
) -> Loaded:
    """From the files, which may be others by now or be missing, else from what they were."""
    try:
        if all(path.parent.joinpath(name).read_bytes() == data for name, data in {path.name: source, **used}.items()):
            return Loaded(path, given, source, trust)
    except OSError:
        pass
    with tempfile.TemporaryDirectory() as folder:
        own = Path(folder, path.name)
        write_files(own.parent, {path.name: source, **used})
        return Loaded(own, given, source, trust)
