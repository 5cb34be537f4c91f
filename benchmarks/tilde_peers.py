"""nppg tilde beside scikit-learn's trees on propositionalised columns, in ten folds of the same examples.

`NPPG_TILDE=FOLDER python -m benchmarks.tilde_peers`, where the folder has ACE's and Aleph's examples. The columns are
the answers to all tests of one literal, and of a second one behind it about a variable that it introduces.
"""

from __future__ import annotations

import os
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
from sklearn.tree import DecisionTreeClassifier, DecisionTreeRegressor

from nppg.bias.language_bias import LanguageBias
from nppg.tilde.declared import looking_ahead
from nppg.tilde.learning import Learner, cross_validated, folds
from nppg.tilde.reading import read_task
from nppg.tilde.task import REGRESS, Settings, Task

_FOLDS = 10
_SETS = ("muta", "bongard/keys", "mach/keys", "aleph/good", "aleph/gcws")


def main() -> None:
    """Prints a row for each data set."""
    folder = Path(os.environ["NPPG_TILDE"])
    print("| data | examples | nppg, right | seconds | columns | scikit-learn, right | seconds |")
    print("|---|---|---|---|---|---|---|")
    for name in _SETS:
        _row(name, read_task([folder / name]))
    _row("muta, log mutagenicity (R2)", _regression(read_task([folder / "muta"])))


def _regression(task: Task) -> Task:
    """The number that the classes of mutagenesis come from, to be told itself."""
    values = {fact[1]: fact[2] for fact in task.facts if isinstance(fact, tuple) and fact[0] == "logmutag"}
    examples = tuple(replace(each, target=values[each.key[0]]) for each in task.examples)
    settings = Settings(mode=REGRESS, minimal_cases=task.settings.minimal_cases, significance=0.05)
    return replace(task, examples=examples, classes=(), settings=settings, target="logmutag")


def _row(name: str, task: Task) -> None:
    count = min(_FOLDS, len(task.examples))
    begun = time.process_time()
    learner = Learner(task)
    ours = _judged(learner, cross_validated(learner, task.settings, count, lambda _: None))
    own = time.process_time() - begun
    begun = time.process_time()
    columns = Learner(replace(task, bias=_further(task.bias))).coverage.bits
    theirs = _judged(learner, _sklearn(learner, columns, count))
    other = time.process_time() - begun
    row = (name, len(task.examples), f"{ours:.3f}", f"{own:.1f}", columns.shape[1], f"{theirs:.3f}", f"{other:.1f}")
    print("| " + " | ".join(map(str, row)) + " |", flush=True)


def _further(bias: LanguageBias) -> LanguageBias:
    """With a second literal behind each that introduces a variable."""
    return replace(bias, modes=looking_ahead(bias.modes, {}, 1), max_lookahead=1)


def _sklearn(learner: Learner, columns: np.ndarray, count: int) -> np.ndarray:
    settings, targets = learner.task.settings, learner.targets
    least = settings.minimal_cases
    outputs = np.zeros((len(columns), max(1, len(targets.classes))))
    for fold in folds(targets, count, np.random.default_rng(settings.random_state)):
        rest = np.setdiff1d(np.arange(len(columns)), fold)
        if targets.classes:
            tree = DecisionTreeClassifier(criterion="entropy", min_samples_leaf=least, random_state=0)
            tree.fit(columns[rest], targets.values[rest])
            outputs[np.ix_(fold, tree.classes_)] = tree.predict_proba(columns[fold])
        else:
            regressor = DecisionTreeRegressor(min_samples_leaf=least, random_state=0)
            regressor.fit(columns[rest], targets.values[rest, 0])
            outputs[fold, 0] = regressor.predict(columns[fold])
    return outputs


def _judged(learner: Learner, outputs: np.ndarray) -> float:
    """The share of examples that are right, or R2."""
    values = learner.targets.values
    if learner.targets.classes:
        return float((outputs.argmax(axis=1) == values).mean())
    return float(1 - ((values - outputs) ** 2).sum() / ((values - values.mean(axis=0)) ** 2).sum())


if __name__ == "__main__":
    main()
