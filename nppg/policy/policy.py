"""The policy: a Gibbs distribution over a potential that is a sum of relational regression trees."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Mapping, Sequence
from importlib.metadata import entry_points
from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from nppg.answers.coverage import table_of
from nppg.answers.table import Table, TestTable
from nppg.bias.language_bias import LanguageBias
from nppg.bridge.plain import number
from nppg.bridge.prolog import ask, drop_with, exclusively
from nppg.bridge.terms import Ground, compounds, plain
from nppg.errors import NppgError, Problem, suggestion
from nppg.logic.query import Var
from nppg.policy import model
from nppg.policy.forest import Forest
from nppg.policy.gibbs import TIE, best, gibbs
from nppg.trees.clauses import to_clause
from nppg.trees.tree import Tree, leaves, mapped, rules, tests
from nppg.worlds.domain import Domain
from nppg.worlds.world import Action, State


class Scores(NamedTuple):
    """What a policy makes of a state's actions: the answers to its tests about them, shape (actions, tests), and their
    potentials and probabilities, shape (actions,)."""

    answers: np.ndarray
    potentials: np.ndarray
    probabilities: np.ndarray


@exclusively("add", "name", "answers", "potentials_of", "preferred", "prefer", "prolog_potentials", "rules", "save")
class Policy:
    """Psi_m = Psi_{m-1} + eta_m h_m, and pi(s, a) = exp Psi(s, a) / sum_b exp Psi(s, b).

    The trees are stored in Prolog as clauses, once somebody asks for these; `potentials` is their sum, by way of each
    pair's answers to the tests of `table` (see nppg.policy.forest), `prolog_potentials` asks the clauses themselves.
    """

    greedy = False  # whether it takes an action of the highest potential wherever it does not learn

    def __init__(self, domain: Domain, bias: LanguageBias, table: Table | None = None):
        self.domain = domain
        self.bias = bias
        self.table = TestTable(domain, bias) if table is None else table
        self.trees: list[Tree] = []
        self.comments: list[str] = []
        self.facts: Mapping[str, list] = {}  # what the head of its model file says, where it was read from one
        self._leaves = 0
        self._open()

    def add(self, tree: Tree, step_size: float = 1.0, comment: str = "") -> None:
        """Adds step_size * tree to the potential. Raises NppgError where that would not be finite."""
        step_size = number("the step size", step_size)
        scaled = mapped(tree, lambda value: float(value * step_size))
        for rule in rules(scaled):
            number("the value of a leaf", rule.value)
        self._store(scaled)
        self.trees.append(scaled)
        self.comments.append(comment or f"{leaves(tree)} leaves")
        self._leaves += leaves(tree)

    def _open(self) -> None:
        """Makes the place in Prolog where the trees are stored, which goes with this object."""
        signatures = [(each.name, each.types) for each in self.bias.actions] + list(self.bias.types.items())
        self._name: str = ask("policy", self.domain.module, [[name, *types] for name, types in signatures])
        drop_with(self, "policy_drop", self._name)
        self._unstored: deque[Tree] = deque()  # those that Prolog does not have yet
        self._forest = Forest()

    @property
    def name(self) -> str:
        """Under which Prolog has the clauses of all trees."""
        while self._unstored:
            ask("tree", self._name, [to_clause(rule, self.bias) for rule in rules(self._unstored.popleft())])
        return self._name

    def _store(self, tree: Tree) -> None:
        self._unstored.append(tree)
        self.table.add(tests(tree))
        self._forest.add(tree, self.table.place)

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in vars(self).items() if name not in ("_name", "_unstored", "_forest")}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """A copy stores the trees for itself."""
        vars(self).update(state, trees=list(state["trees"]), comments=list(state["comments"]))
        self._open()
        for tree in self.trees:
            self._store(tree)

    def potentials(self, state: State, actions: Sequence[Action]) -> np.ndarray:
        """Psi(s, a) of each action, shape (actions,)."""
        return self.potentials_of(self.answers(state, actions))

    def answers(self, state: State, actions: Sequence[Action]) -> np.ndarray:
        """All that the potential depends on, a row for each action: the answers to the table's tests."""
        return self.table.answers(state, actions)

    @property
    def width(self) -> int:
        """The length of a row of `answers`; it changes where a tree has brought new tests."""
        return len(self.table)

    def potentials_of(self, answers: np.ndarray) -> np.ndarray:
        """The potentials of pairs with these answers, shape (pairs,)."""
        return self._forest.sums(answers)

    def probabilities_of(self, potentials: np.ndarray) -> np.ndarray:
        """pi(s, a), with which it takes the actions of a state that have these potentials, shape (actions,)."""
        return gibbs(potentials)

    def scores(self, state: State, actions: Sequence[Action]) -> Scores:
        """All of these for a state's legal actions."""
        return self.scored(self.answers(state, actions))

    def scored(self, answers: np.ndarray) -> Scores:
        """The same where the answers are known."""
        potentials = self.potentials_of(answers)
        return Scores(answers, potentials, self.probabilities_of(potentials))

    @property
    def is_rules(self) -> bool:
        """Whether it is one tree whose values are apart: a list of rules, of which the best one that some legal action
        meets can be found without scoring all actions."""
        if len(self.trees) != 1 or self.domain.environment or type(self) is not Policy:
            return False
        values = sorted({rule.value for rule in rules(self.trees[0])})
        least = 2 * TIE * max(map(abs, values))
        return all(higher - lower > least for lower, higher in pairwise(values))

    def preferred(self, state: State) -> list[Action]:
        """The legal actions of the highest potential, of a policy that `is_rules`."""
        self.domain.visit(state)
        return compounds(ask("preferred_actions", self.name))

    def prefer(self, state: State, rng: np.random.Generator) -> Action:
        """Draws one of these."""
        self.domain.visit(state)
        return compounds([ask("preferred_action", self.name, rng.random())])[0]

    def prolog_potentials(self, state: State, actions: Sequence[Action]) -> np.ndarray:
        """Psi(s, a) summed clause by clause in Prolog."""
        given = plain(actions)
        self.domain.visit(state)
        return np.array(ask("potentials", self.name, given))

    def distribution(self, state: State, actions: Sequence[Action]) -> np.ndarray:
        """pi(s, a) of each action, shape (actions,)."""
        return self.probabilities_of(self.potentials(state, actions))

    def act(self, state: State, rng: np.random.Generator, greedy: bool = False) -> Action:
        """Draws a legal action from the distribution, or one of those with the highest potential. Raises NppgError
        where there is none."""
        status, actions = self.domain.situation(state)
        if status != "running":
            raise NppgError(f"there is no action to choose: the state is a {status} state")
        seen = self.domain.observe(state, rng)
        potentials = self.potentials(seen, actions)
        if greedy or self.greedy:
            return actions[choose_best(potentials, rng)]
        return actions[choose(self.probabilities_of(potentials), rng)]

    def named(self) -> set[Ground]:
        """The constants that its tests name."""
        literals = (literal for test in self.table.tests for literal in test)
        return {arg for literal in literals for arg in literal.args if not isinstance(arg, Var)}

    def sizes(self) -> dict[str, int]:
        """What it consists of, with numbers."""
        return {"trees": len(self.trees), "leaves": self._leaves}

    def stored(self) -> tuple[Policy, list[tuple]]:
        """The policy as model files have it, and facts for the head of such a file."""
        return self, []

    def option(self, name: str, default: Any) -> Any:
        """The value of an option of the run that a loaded policy comes from, as its model file says."""
        for fact in self.facts.get("option", []):
            match fact:
                case ("=", str(known), value) if known == name:
                    return value
        return default

    def rules(self, tree: int) -> list[str]:
        """The clauses of a tree (from 1), one line each."""
        return ask("rules", self.name, tree)

    def save(self, path: str | Path, facts: Sequence[tuple] = (), sentences: Sequence[Sequence[str]] = ()) -> None:
        """Writes a model file, with `facts` in its head: pairs of a name and a term; and, if given, with `sentences`
        above its rules, for each tree one for each rule. A copy of the domain comes to stand beside it; raises
        NppgError where another file of that name is there. See nppg.policy.model and nppg.rules.explain."""
        model.write(self, Path(path), facts, sentences)

    @classmethod
    def load(
        cls,
        path: str | Path,
        parameters: dict | None = None,
        trust: bool | None = None,
        edited: bool = False,
    ) -> Policy:
        """Reads a model file, as data. `parameters` change those of its domain; one that was changed since it was
        written is refused, unless it is `edited` on purpose. A learner whose policies are more than
        their trees says how its files are read by an entry point `nppg.learners` of its own name. Raises NppgError."""
        domain, bias, trees, facts = model.read(Path(path), parameters or {}, trust, edited)
        policy = cls(domain, bias, table_of([test for tree in trees for test in tests(tree)], domain, bias))
        policy.facts = facts
        for tree in trees:
            policy.add(tree)
        for learner in facts.get("learner", ()):
            policy = _reader(str(learner), Path(path))(policy, Path(path))
        return policy


def _reader(learner: str, path: Path) -> Callable[[Policy, Path], Policy]:
    """What makes a learner's policy from the trees of its file. Raises NppgError where there is no such learner."""
    for known in entry_points(group="nppg.learners", name=learner):
        return known.load()
    names = entry_points(group="nppg.learners").names
    raise NppgError([Problem(str(path), 1, 0, f"there is no learner {learner}{suggestion(learner, names)}")])


def choose(probabilities: np.ndarray, rng: np.random.Generator) -> int:
    """Draws an index by its probability."""
    drawn = int(probabilities.cumsum().searchsorted(rng.random(), side="right"))
    return min(drawn, len(probabilities) - 1)


def choose_best(potentials: np.ndarray, rng: np.random.Generator) -> int:
    """Draws the index of one of the highest potentials, each as likely as the others."""
    highest = np.flatnonzero(best(potentials))
    return int(highest[int(rng.random() * len(highest))])
