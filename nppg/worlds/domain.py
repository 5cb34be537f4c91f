"""A domain as Python sees it: states, legal actions, what they lead to.

A fact or an action is a name, or a tuple of a name and its arguments: `on(a, b)` is `("on", "a", "b")`.
docs/domains.md is the reference of domain files.
"""

from __future__ import annotations

import copy
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, cast

import numpy as np

from nppg.bridge.bounds import checked
from nppg.bridge.files import locate, sha256
from nppg.bridge.plain import alone, named
from nppg.bridge.prolog import ask, exclusively, randomness
from nppg.bridge.terms import Ground, compounds, ground
from nppg.errors import NppgError, Problem
from nppg.worlds.legal import LegalActions
from nppg.worlds.loaded import Loaded
from nppg.worlds.problems import BESIDE, Problems, numbered, problems_in, problems_text
from nppg.worlds.state import Interpretation, facts_of, static_facts
from nppg.worlds.trust import trusting
from nppg.worlds.world import Action, Outcome, Situation, State

if TYPE_CHECKING:
    from typing_extensions import Self


@exclusively("start", "problem", "problems", "situation", "horizon", "observe", "expert_actions", "act", "outcomes")
@exclusively("cost", "reward", "neighbours", "picture", "parts", "binding", "kinds", "interpreted", "visit")
class Domain:
    """An instance of a domain file with its parameters; it has its own module in Prolog until it is dropped.

    Threads may share it. Its copies share the module, because all that they are asked is about a state that they are
    given. Pickled it takes the texts of its files along. `name_or_path` is a shipped domain's name or a file, which may
    do anything if it is to `trust`; see nppg.worlds.trust. Raises NppgError with every mistake that can be found in the
    file, and from all methods for mistakes that show only when the domain's code runs.
    """

    def __init__(
        self,
        name_or_path: str | Path,
        parameters: Mapping[str, int | float | str] | None = None,
        trust: bool | None = None,
    ):
        self.trusted = trusting(trust)
        self.path = locate(name_or_path, "domains", ".pl")
        self.given = named(parameters)
        try:
            self.source = self.path.read_bytes()
        except OSError as error:
            raise NppgError([Problem(str(self.path), 0, 0, f"cannot be read: {error.strerror}")]) from None
        self._loaded = Loaded(self.path, self.given, self.source, self.trusted)
        description = self._loaded.description
        self.name: str = description["name"]
        self.parameters: dict[str, int | float | str] = dict(description["parameters"])
        self.fluents = {tuple(each) for each in description["fluents"]}
        self.static = {tuple(each) for each in description["static"]}
        self.has_start: bool = description["start"] == "true"
        self.has_chance: bool = description["chance"] == "true"  # outcomes with probabilities
        self.has_costs: bool = description["cost"] == "true"
        self._numbers_problems: bool = description["problems"] == "true"
        self._problems: Problems | None = None
        self.pddl: str = description["pddl"]  # the PDDL file that it comes from, or empty
        self._chosen: list[int] = []
        self._chances = np.empty(0)  # of these, cumulated
        self.predicates = {tuple(each) for each in description["predicates"]}
        self.actions = {tuple(each) for each in description["actions"]}
        self.uniform_start: bool = description["uniform_start"] == "true"
        self.interchangeable: list[str] = description["interchangeable"]
        self.has_expert: bool = description["expert"] == "true"
        self.has_goal: bool = description["goal"] == "true"
        self.has_parts: bool = description["parts"] == "true"
        self.has_observation: bool = description["observation"] == "true"
        self.environment: str = description["environment"]  # of Gymnasium, which nppg.open_domain opens; or empty

    @property
    def module(self) -> str:
        """Its module in Prolog."""
        return self._loaded.module

    @property
    def loaded(self) -> Loaded:
        """Its file as Prolog has it, with the current state."""
        return self._loaded

    @property
    def is_countable(self) -> bool:
        """Whether it is for exact evaluation, if its states are few: it starts uniformly, has a goal, is seen whole."""
        return self.uniform_start and self.has_goal and not (self.has_observation or self.static or self.chosen)

    @property
    def hash(self) -> str:
        """SHA-256 of the file as it was loaded, in hexadecimal; of those that it uses, too, with their names."""
        return sha256(self.source + "".join(f"\n{k} {sha256(v)}" for k, v in sorted(self.used.items())).encode())

    @property
    def used(self) -> Mapping[str, bytes]:
        """The files that it is continued in, contents by their names from its folder."""
        return self._loaded.used

    def state(self, text: str) -> State:
        """The state of these facts, written as Prolog has them: "on(b1, b2), on(b2, floor)". Raises NppgError for what
        is no text of ground facts of declared fluents."""
        known = [f"{name}/{arity}" for name, arity in self.fluents | self.static]
        checked(f"[{text}]", "the state")
        static, facts = ask("state_of", self.module, text.strip().removesuffix("."), known)
        return Interpretation(ground(facts), static_facts(ground(static)))

    def visit(self, state: State) -> None:
        """Makes a state the current interpretation in Prolog."""
        self._loaded.visit(state)

    def interpreted(self, state: State) -> Interpretation:
        """A state that somebody may have made of facts, static ones among them."""
        return self._loaded.interpreted(state)

    def static_number(self, state: Interpretation) -> int:
        """Under which Prolog keeps the static facts of a state."""
        return self._loaded.number(state.static)

    def forget(self) -> None:
        """To be called by who makes another state current behind this object's back."""
        self._loaded.forget()

    def start(self, rng: np.random.Generator) -> State:
        """Draws a start state."""
        if self.chosen:
            return self.problem(self._drawn(rng))
        if not self.has_start:
            message = "the domain has no start states: neither start/1 nor problems (see --problems)"
            raise NppgError([Problem(str(self.path), 0, 0, message)])
        with randomness(rng):
            return cast("Interpretation", self._loaded.begun("draw"))

    @property
    def chosen(self) -> list[int]:
        """The problems that start states are drawn from; none where start/1 draws them."""
        if not (self._chosen or self.has_start):
            self._chosen = list(self.problems)
        return self._chosen

    @property
    def problems(self) -> Mapping[int, str]:
        """Its problems, the names by number; empty where it has none."""
        if self._problems is None:
            numbers = ask("problem_numbers", self.module) if self._numbers_problems else []
            self._problems = Problems({number: f"problem {number}" for number in numbers}, self._begin, given=False)
        return self._problems.names

    def _drawn(self, rng: np.random.Generator) -> int:
        """One of the chosen problems, by chances that are inverse to their horizons."""
        if len(self._chances) != len(self.chosen):
            weights = np.array([1 / max(1, self.horizon(self.problem(number))) for number in self.chosen])
            self._chances = weights.cumsum() / weights.sum()
        return self.chosen[min(int(self._chances.searchsorted(rng.random(), "right")), len(self.chosen) - 1)]

    def _begin(self, number: int) -> Interpretation:
        if (begun := self._loaded.begun("begin", number)) is None:
            raise self._no_problem(number)
        return begun

    def problem(self, number: int) -> State:
        """The start state of a problem. Raises NppgError where there is none of this number."""
        if number not in self.problems or self._problems is None:
            raise self._no_problem(number)
        return self._problems.state(alone(number))

    def with_problems(self, numbers: Iterable[int]) -> Self:
        """The same domain with start states drawn from these problems, those with a longer horizon less often. Raises
        NppgError for numbers that are none."""
        numbers = [*map(alone, numbers)]
        for number in numbers:
            if number not in self.problems:
                raise self._no_problem(number)
        other = copy.copy(self)
        other._chosen, other._chances = numbers, np.empty(0)
        return other

    def over(self, problems: Problems) -> Self:
        """The same domain with other problems, from which start states are drawn."""
        other = copy.copy(self)
        other._problems, other._chosen, other._chances = problems, list(problems.names), np.empty(0)
        return other

    def problems_of(self, files: Sequence[Path]) -> Problems:
        """The problems in files. Raises NppgError with every mistake."""
        found = [problems_in(file, self.module) for file in files]
        states = [each.state(number) for each in found for number in each.names]
        return numbered(states, [name for each in found for name in each.names.values()])

    @property
    def companions(self) -> Mapping[str, bytes]:
        """The files beside its own that it needs, contents by name: those that it is continued in, and that of the
        problems that it was given."""
        if self._problems is None or not self._problems.given:
            return self.used
        text = problems_text((self.problems[each], self.problem(each)) for each in self.chosen or self.problems)
        return {**self.used, f"{self.path.stem}{BESIDE}": text.encode()}

    def _no_problem(self, number: int) -> NppgError:
        known = list(self.problems)
        has = f"has problems {known[0]} to {known[-1]}" if known else "has no problems"
        return NppgError([Problem(str(self.path), 0, 0, f"there is no problem {number}; the domain {has}")])

    def situation(self, state: State, lean: bool = False) -> Situation:
        """Whether the state ends an episode, and its legal actions in a fixed order; if it is to be `lean`, these are
        found when they are asked for."""
        self.visit(state)
        status, actions, *serial = self._loaded.situation or ask("situation", self.module, lean)
        if serial:
            return Situation(status, LegalActions(self._loaded, state, actions, *serial))
        self._loaded.legal = found = compounds(actions)
        return Situation(status, found.copy())

    def horizon(self, state: State) -> int:
        """The number of steps after which an episode that starts here ends."""
        self.visit(state)
        return ask("horizon_of", self.module)

    def observe(self, state: State, rng: np.random.Generator) -> State:
        """What a policy sees in place of the state, a tuple of facts like it: the state itself, unless the domain
        defines observation/1, which may draw anew each time."""
        if not self.has_observation:
            return state
        self.visit(state)
        with randomness(rng):
            return Interpretation(ground(ask("observed", self.module)), self.interpreted(state).static)

    def expert_actions(self, state: State) -> list[Action]:
        """What the domain's expert would do, none if it has no advice."""
        self.visit(state)
        return compounds(ask("expert_actions", self.module))

    def act(self, state: State, action: Action, rng: np.random.Generator, lean: bool = False) -> tuple[float, State]:
        """Takes an action: the reward, and the state that it leads to; its situation, `lean` or not, comes along."""
        self.visit(state)
        with randomness(rng):
            return self._loaded.act(self.interpreted(state), self._loaded.action(action), lean)

    def outcomes(self, state: State, actions: Sequence[Action]) -> list[list[Outcome]]:
        """What each of these legal actions may lead to."""
        self.visit(state)
        return self._loaded.outcomes(self.interpreted(state), [*map(self._loaded.action, actions)])

    def certain(self, state: State, action: Action) -> State | None:
        """The state that an action leads to, None where that is left to chance."""
        (found,) = self.outcomes(state, [action])
        return found[0].state if len(found) == 1 else None

    def cost(self, state: State, action: Action) -> float:
        """What an action costs in the state: 1, unless the domain defines cost/2."""
        self.visit(state)
        return ask("cost_of", self.module, self._loaded.action(action))

    def reward(self, state: State, action: Action) -> float:
        """The reward for an action that has just led to the state."""
        self.visit(state)
        return ask("reward_of", self.module, self._loaded.action(action))

    def neighbours(self, state: State) -> list[tuple[Action, list[Outcome]]]:
        """Every legal action, also of a goal or terminal state, with all its outcomes."""
        self.visit(state)
        return self._loaded.neighbours(self.interpreted(state))

    def plan_step(self, action: Action) -> str:
        """An action as a line of a plan: (sail l1 l2)."""
        return f"({' '.join(map(str, action if isinstance(action, tuple) else (action,)))})"

    def picture(self, state: State) -> list[str]:
        """The state drawn for people, line by line."""
        self.visit(state)
        return ask("drawing", self.module)

    def parts(self, state: State) -> tuple[tuple[Ground, ...], ...]:
        """The sequences of terms that two states are compared by: what the domain's parts/1 says, else the facts."""
        if not self.has_parts:
            return tuple(fact if isinstance(fact, tuple) else (fact,) for fact in facts_of(state))
        self.visit(state)
        return ground(ask("parts_of", self.module))

    def binding(self, state: State, predicate: str, arity: int) -> tuple[Ground, ...]:
        """The arguments of a predicate's answer, which must be the only one: what the goal template is bound to."""
        self.visit(state)
        return ground(ask("binding_of", self.module, predicate, arity))

    def kinds(self, state: State) -> dict[Ground, str]:
        """The interchangeable objects of a state, with what tells those apart that are not members of the same
        predicates."""
        found: dict[Ground, str] = {}
        for name in self.interchangeable:
            self.visit(state)
            for each in ask("members", self.module, name):
                each = ground(each)
                found[each] = f"{found.get(each, '')} {name}"
        return found
