"""RIB and TRENDI: instances, all together or in the leaves of a tree.

TRENDI (Driessens and Dzeroski 2005) is a tree as TG grows it, whose leaves hold RIB regressors and split on the
examples that these hold. RIB is the same without any test.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from statistics import fmean
from typing import Any

import numpy as np

from nppg.answers.coverage import Coverage
from nppg.answers.table import Table
from nppg.bias.declarations import TreeLimits
from nppg.bias.refinement import Refiner
from nppg.errors import NppgError, Problem
from nppg.policy.policy import Policy
from nppg.rrl.distance import PairDistance
from nppg.rrl.instances import Instances
from nppg.rrl.numbered_tree import NumberedTree
from nppg.rrl.options import InstanceOptions, RIBOptions, TrendiOptions
from nppg.rrl.qfunction import Example, QFunction
from nppg.trees.tilde import best_split
from nppg.trees.tree import Tree
from nppg.worlds.state import static_of
from nppg.worlds.world import Action, State


class _Held:
    """A leaf's instances, the examples that they were met as, and how many examples it has seen since it was looked at
    for a split."""

    def __init__(self, distance: PairDistance, options: InstanceOptions):
        self.options = options
        self.instances = Instances(distance, options)
        self.met: dict[int, tuple[State, Action]] = {}
        self.seen = 0

    def examples(self) -> list[tuple[int, float, State, Action]]:
        """Class, value, state and action of each instance."""
        pairs = zip(self.instances.pairs.tolist(), self.instances.values.tolist(), strict=True)
        return [(number, value, *self.met[number]) for number, value in pairs]

    def update(self, number: int, example: Example) -> None:
        """Learns from an example of this class."""
        self.seen += 1
        self.met.setdefault(number, (example.state, example.action))
        self.instances.update(number, example.value)
        if len(self.met) > 2 * self.options.max_instances:  # of most classes no instance is kept
            self.met = {each: self.met[each] for each in self.instances.pairs.tolist()}

    def store(self, number: int, value: float, state: State, action: Action) -> None:
        """Takes an instance over."""
        self.instances.store(number, value)
        self.met[number] = (state, action)

    def saved(self) -> dict[str, Any]:
        """All of it, to be stored. The numbers of classes are another process's affair: pairs stand for them."""
        places = {number: at for at, number in enumerate(self.met)}
        classes = [places[each] for each in self.instances.pairs.tolist()]
        met = list(self.met.values())
        return {"met": met, "classes": classes, "seen": self.seen, "instances": self.instances.saved()}

    def resume(self, saved: dict[str, Any], distance: PairDistance) -> None:
        """Goes on with that."""
        numbers = [int(distance.describe(state, [action])[0]) for state, action in saved["met"]]
        self.met = dict(zip(numbers, saved["met"], strict=True))
        self.seen = saved["seen"]
        self.instances.resume([numbers[at] for at in saved["classes"]], saved["instances"])


class InstanceTree:
    """The regressor. A description is the class of the pair, behind the answers to the tests where there are any."""

    def __init__(
        self,
        table: Table,
        refiner: Refiner,
        distance: PairDistance,
        options: InstanceOptions,
        tree: Tree | None = None,
    ):
        self.table = table
        self.distance = distance
        self.options = options
        self.growth = options if isinstance(options, TrendiOptions) else None
        self.tree = NumberedTree(table, refiner, tree)
        self.leaves = [_Held(distance, options) for _ in range(len(self.tree))]

    @property
    def width(self) -> int:
        return 1 + len(self.table) if self.growth else 1

    def describe(self, state: State, actions: Sequence[Action]) -> np.ndarray:
        classes = self.distance.describe(state, actions)[:, None]
        return np.hstack([self.table.answers(state, actions), classes]) if self.growth else classes

    def _leaves_of(self, descriptions: np.ndarray) -> np.ndarray:
        if self.growth:
            return self.tree.leaf_of(descriptions[:, :-1].astype(bool))
        return np.zeros(len(descriptions), int)

    def predict(self, descriptions: np.ndarray) -> np.ndarray:
        leaves = self._leaves_of(descriptions)
        values = np.empty(len(descriptions))
        for leaf in np.unique(leaves).tolist():
            members = leaves == leaf
            values[members] = self.leaves[leaf].instances.predict(descriptions[members, -1])
        return values

    def update(self, examples: Sequence[Example]) -> None:
        """Each leaf that saw an example splits at most once."""
        leaves = self._leaves_of(np.stack([each.description for each in examples])).tolist()
        for number, each in zip(leaves, examples, strict=True):
            leaf, pair = self.leaves[number], int(each.description[-1])
            leaf.update(pair, each)
        for number in dict.fromkeys(leaves):
            if self.growth and self.leaves[number].seen >= self.growth.min_sample:
                self._look_for_split(number, self.growth)

    def _look_for_split(self, number: int, growth: TrendiOptions) -> None:
        leaf = self.leaves[number]
        leaf.seen = 0
        held = leaf.examples()
        if self.tree.depths[number] >= growth.max_depth or len(held) < growth.min_instances:
            return
        candidates = self.tree.candidates(number)
        coverage = Coverage(self.table, [state for *_, state, _ in held], [action for *_, action in held])
        answers, _ = coverage.matrix(candidates, np.arange(len(held)), {})
        limits = TreeLimits(min_examples=1, significance=growth.significance)
        best = best_split(answers, np.array([value for _, value, *_ in held]), limits, leaf.instances.unit)
        if best is None:
            return
        self.tree.split(number, candidates[best.candidate])
        failed, passed = _Held(self.distance, self.options), _Held(self.distance, self.options)
        failed.instances.unit = passed.instances.unit = leaf.instances.unit
        for each, holds in zip(held, best.covered(answers), strict=True):
            (passed if holds else failed).store(*each)
        self.leaves[number] = failed
        self.leaves.append(passed)

    def sizes(self) -> dict[str, int]:
        tree = {"trees": 1, "leaves": len(self.tree)} if self.growth else {}
        return tree | {"instances": sum(len(leaf.instances) for leaf in self.leaves)}

    def stored(self) -> tuple[Policy, list[tuple]]:
        """The rules of the tree give the mean of their instances; instance(Rule, Action, Value, State) are these."""
        policy = Policy(self.table.domain, self.table.bias, self.table)
        policy.add(self.tree.with_values(lambda leaf: fmean(self.leaves[leaf].instances.values.tolist() or [0.0])))
        facts: list[tuple] = [("learner", self.options.learner), ("mismatch", self.options.mismatch)]
        facts += [("power", self.options.power)] if self.options.power != 1 else []
        for rule, leaf in enumerate(self.tree.in_order(), 1):
            for _, value, state, action in self.leaves[leaf].examples():
                facts.append(
                    ("instance", ("instance", rule, action, value, ("state", *static_of(state).facts, *state)))
                )
        return policy, facts

    def saved(self) -> dict[str, Any]:
        return {"tree": self.tree.saved(), "leaves": [leaf.saved() for leaf in self.leaves]}

    def resume(self, saved: dict[str, Any]) -> None:
        self.tree.resume(saved["tree"])
        self.leaves = [_Held(self.distance, self.options) for _ in saved["leaves"]]
        for leaf, each in zip(self.leaves, saved["leaves"], strict=True):
            leaf.resume(each, self.distance)


def restored(policy: Policy, path: Path) -> QFunction:
    """The value function of which a model file, read from `path`, has the tree and the instances. Raises NppgError for
    instances that are none."""
    facts, tree = policy.facts, policy.trees[0]
    instances = facts.get("instance", [])
    options = {each.learner: each for each in (RIBOptions, TrendiOptions)}[facts["learner"][0]](
        max_instances=max(2, len(instances)),
        mismatch=facts.get("mismatch", [1.0])[0],
        power=facts.get("power", [1.0])[0],
    )
    distance = PairDistance(policy.domain, policy.bias, options.mismatch)
    regressor = InstanceTree(policy.table, Refiner(policy.bias), distance, options, tree)
    for fact in instances:
        match fact:
            case ("instance", int(rule), action, float(value), ("state", *facts_of_state)) if 1 <= rule <= len(
                regressor.leaves
            ) and _is_pair(policy, tuple(facts_of_state), action):
                state = policy.domain.interpreted(tuple(facts_of_state))
                number = int(distance.describe(state, [action])[0])
                regressor.leaves[rule - 1].store(number, value, state, action)
            case _:
                raise NppgError([Problem(str(path), 1, 0, f"this is no instance of the model's domain: {fact}")])
    found = QFunction(regressor, options)
    found.add(tree, comment=policy.comments[0])
    found.facts = facts
    return found


def _is_pair(policy: Policy, state: State, action: Action) -> bool:
    """Whether facts and action are the domain's, as far as their names and arities go."""
    known = {(each.name, len(each.types)) for each in policy.bias.actions}
    return _indicator(action) in known and all(
        _indicator(fact) in policy.domain.fluents | policy.domain.static for fact in state
    )


def _indicator(term: object) -> tuple:
    return (term[0], len(term) - 1) if isinstance(term, tuple) else (term, 0)
