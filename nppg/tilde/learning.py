"""From a task to a model: one tree, many that vote, or many that are added up."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np

from nppg.answers.coverage import Coverage, root_table
from nppg.bias.declarations import TreeLimits
from nppg.bias.refinement import Refiner
from nppg.errors import NppgError, Problem
from nppg.tilde.knowledge import Knowledge
from nppg.tilde.model import Model, Passes, probabilities
from nppg.tilde.targets import Targets, targets_of
from nppg.tilde.task import Settings, Task
from nppg.trees import pruning
from nppg.trees.classes import Classes
from nppg.trees.growing import Criterion, grown
from nppg.trees.several import Several
from nppg.trees.tilde import Newton, grow
from nppg.trees.tree import Leaf, Tree

_REGULARISATION, _CLIP = 1.0, 4.0  # of the scores of classes


@dataclass(frozen=True)
class Grown:
    """A tree as it was grown, and what pruning has made of it."""

    whole: Tree
    safe: Tree  # the same classes for all examples
    pruned: Tree


class Learner:
    """The examples of a task, loaded, with the answers to the tests that a root may ask. Raises NppgError for what is
    wrong with the task."""

    def __init__(self, task: Task, targets: Targets | None = None):
        self.task = task
        self.targets = targets or targets_of(task)
        self.knowledge = Knowledge(task, Knowledge.asked(task.bias))
        _check_predicates(self.knowledge)
        self.bias = self.knowledge.complete(task.bias)
        self.refiner = Refiner(self.bias)
        if not self.refiner.refinements(()):
            message = f"there is no test of {task.template}: no mode has + arguments of its types alone, and constants"
            raise NppgError([Problem(task.bias.file, 0, 0, message)])
        self.passes = Passes(self.knowledge, self.bias, task.examples)
        table = root_table(self.knowledge.domain, self.bias, self.refiner)
        self.coverage = Coverage(table, self.passes.states, self.passes.actions)
        self.all = np.arange(len(task.examples))

    def tree(self, settings: Settings, members: np.ndarray, weights: np.ndarray | None = None) -> Grown:
        """One tree of the examples `members`."""
        rng = np.random.default_rng(settings.random_state)
        kept = np.empty(0, np.intp)
        how = settings.pruning or ("c45" if self.targets.classes else "none")
        if how == "validation":
            kept = np.sort(rng.permutation(members)[: int(len(members) * settings.validation_share)])
            members = np.setdiff1d(members, kept)
        criterion = self.criterion(settings, self.targets.weights if weights is None else weights)
        whole = grown(criterion, self.coverage, self.refiner, settings.max_depth or None, members)
        safe = pruning.safe(whole) if self.targets.classes else whole
        pruned = safe if how == "safe" else whole
        if how == "c45":
            pruned = pruning.pessimistic(safe, settings.confidence)
        elif how == "validation":
            self.passes.ask([whole])
            errors = self._wrong if self.targets.classes else self._squared
            pruned = pruning.by_validation(whole, members, kept, criterion.leaf, errors, self.passes.passes)
        return Grown(whole, safe, pruned)

    def criterion(self, settings: Settings, weights: np.ndarray) -> Criterion:
        """What splits are judged by."""
        targets, least = self.targets, settings.minimal_cases
        if targets.classes:
            is_ratio = settings.heuristic in ("", "gain_ratio")
            return Classes(targets.values, weights, len(targets.classes), is_ratio, least, settings.granularity)
        return Several(targets.values, weights, least, settings.significance, settings.granularity)

    def _wrong(self, leaf: Leaf, rows: np.ndarray) -> float:
        return float(self.targets.weights[rows][self.targets.values[rows] != leaf.value].sum())

    def _squared(self, leaf: Leaf, rows: np.ndarray) -> float:
        off = ((self.targets.values[rows] - leaf.values) ** 2).sum(axis=1)
        return float((self.targets.weights[rows] * off).sum())

    def model(self, settings: Settings, members: np.ndarray | None = None) -> Model:
        """What is learned of the examples `members`."""
        members = self.all if members is None else members
        if settings.learning_rate is not None:
            return self._boosted(settings, settings.learning_rate, members)
        if settings.n_estimators == 1:
            return self._of([(self.tree(settings, members).pruned,)])
        return self._of([(tree,) for tree in self._bagged(settings, members)])

    def _of(self, rounds: list[tuple[Tree, ...]], rate: float | None = None, offset: tuple[float, ...] = ()) -> Model:
        classes, asked = self.targets.classes, self.knowledge.asked(self.bias)
        return Model(self.bias, tuple(rounds), self.task.target, classes, rate, offset, asked)

    def _bagged(self, settings: Settings, members: np.ndarray) -> Iterator[Tree]:
        """Trees of samples with replacement, as large as the whole (Breiman 1996)."""
        rng = np.random.default_rng(settings.random_state)
        for _ in range(settings.n_estimators):
            drawn = np.bincount(rng.choice(members, len(members)), minlength=len(self.all))
            own = replace(settings, random_state=int(rng.integers(2**31)))
            yield self.tree(own, np.flatnonzero(drawn), self.targets.weights * drawn).pruned

    def _boosted(self, settings: Settings, rate: float, members: np.ndarray) -> Model:
        """Trees that are added up, each a step against the gradient of what is lost by then (Friedman 2001)."""
        own = self.targets.values[members]
        weights = self.targets.weights[members][:, None]
        if self.targets.classes:
            count = len(self.targets.classes)
            hits = np.eye(count)[own]
            wanted = hits[:, 1:] if count == 2 else hits
            offset = np.zeros(wanted.shape[1])
            regularisation, clip = _REGULARISATION, _CLIP
        else:
            wanted, regularisation, clip = own, 0.0, np.inf
            offset = np.average(own, axis=0, weights=weights[:, 0])
        limits = TreeLimits(
            settings.max_depth or len(members), settings.minimal_cases, granularity=settings.granularity
        )
        scores = np.tile(offset, (len(members), 1))
        coverage, rounds = self._part(members), []
        for _ in range(settings.n_estimators):
            gradients, curvatures = self._slopes(wanted, scores)
            trees = []
            for k in range(wanted.shape[1]):
                newton = Newton(weights[:, 0] * curvatures[:, k], regularisation, clip)
                trees.append(grow(weights[:, 0] * gradients[:, k], coverage, self.refiner, limits, newton))
                scores[:, k] += rate * self.passes.values(trees[-1], members)[:, 0]
            rounds.append(tuple(trees))
        return self._of(rounds, rate, tuple(offset.tolist()))

    def _part(self, members: np.ndarray) -> Coverage:
        """The coverage of some examples."""
        if len(members) == len(self.all):
            return self.coverage
        states, actions = ([each[i] for i in members] for each in (self.passes.states, self.passes.actions))
        return Coverage(self.coverage.table, states, actions, self.coverage.bits[members])

    def _slopes(self, wanted: np.ndarray, scores: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The gradients of the log-likelihood of classes, or of half the squared error, and the curvatures."""
        if not self.targets.classes:
            return wanted - scores, np.ones_like(scores)
        found = probabilities(scores)
        found = found[:, 1:] if scores.shape[1] == 1 else found
        return wanted - found, found * (1 - found)


def _check_predicates(knowledge: Knowledge) -> None:
    """Raises NppgError for a predicate of the bias that is nowhere defined while one of a near name is, and warns of
    another one: these examples have no facts of it."""
    found = knowledge.task.bias.check(knowledge.predicates - knowledge.missing, ())
    problems = [replace(each, message=each.message.replace("the domain has", "the data has")) for each in found]
    if wrong := [each for each in problems if each.message.endswith(")")]:
        raise NppgError(wrong)
    for each in problems:
        warnings.warn(f"{each}: it never holds", stacklevel=4)


def folds(targets: Targets, count: int, rng: np.random.Generator) -> list[np.ndarray]:
    """The examples in folds, each class spread over them evenly. Raises NppgError where there are too few."""
    size = len(targets.weights)
    if not 2 <= count <= size:
        raise NppgError(f"folds must be at least 2 and at most the {size} examples, not {count}")
    order = rng.permutation(size)
    if targets.classes:
        order = order[np.argsort(targets.values[order], kind="stable")]
    return [np.sort(order[i::count]) for i in range(count)]


def cross_validated(learner: Learner, settings: Settings, count: int, told: Callable[[int], None]) -> np.ndarray:
    """What is said of each example by a model of the other folds; `told` hears of each fold that is done."""
    result = None
    for i, fold in enumerate(folds(learner.targets, count, np.random.default_rng(settings.random_state)), 1):
        model = learner.model(settings, np.setdiff1d(learner.all, fold))
        outputs = learner.passes.outputs(model, fold)
        result = np.empty((len(learner.all), outputs.shape[1])) if result is None else result
        result[fold] = outputs
        told(i)
    assert result is not None
    return result
