"""What examples have for targets, checked: classes by number, or numbers, with weights."""

from __future__ import annotations

import math
import warnings
from collections.abc import Hashable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from nppg.bridge.plain import alone
from nppg.errors import NppgError, Problem
from nppg.tilde.task import CLASSIFY, Task

_MOST = 20  # mistakes that are told
_PLAIN = (str, int, float)


class InputError(NppgError, ValueError):
    """A mistake in what an estimator is given; a ValueError for who expects one."""


@dataclass(frozen=True)
class Targets:
    """The targets of examples: the numbers of their classes in `values`, shape (examples,), where there are `classes`;
    else numbers, shape (examples, targets). `weights` are above 0."""

    values: np.ndarray
    weights: np.ndarray
    classes: tuple[Hashable, ...] = ()


def targets_of(task: Task) -> Targets:
    """Those of a task. Raises NppgError for those that cannot be, with the line of the example or its number."""
    if not task.examples:
        raise NppgError([Problem(task.examples_file, 0, 0, "there are no examples")])
    places = [
        Problem(task.examples_file, each.line, 0, f"example {i}{f' ({each.name})' if each.name else ''}")
        for i, each in enumerate(task.examples, 1)
    ]
    _no_twins(task)
    weights = weights_of([each.weight for each in task.examples], places)
    given = [each.target for each in task.examples]
    if task.settings.mode == CLASSIFY:
        return classes_of(given, weights, places, task.classes, task.target)
    return numbers_of(given, weights, places, task.target)


def classes_of(
    given: Sequence[Any],
    weights: np.ndarray,
    places: Sequence[Problem],
    classes: Sequence[Hashable] = (),
    what: str = "class",
) -> Targets:
    """Classes, which are in this order if it is given, else sorted. Raises NppgError."""
    names = [alone(each) for each in given]
    _raise(
        _at(place, message)
        for name, place in zip(names, places, strict=True)
        if (message := _no_class(name, what, bool(classes)))
    )
    known = list(classes) or sorted(set(names), key=lambda each: (isinstance(each, str), each))
    index = {name: i for i, name in enumerate(known)}
    strange = [
        _at(place, f"is of class {name}, and the classes are {', '.join(map(str, known))}")
        for name, place in zip(names, places, strict=True)
        if name not in index
    ]
    _raise(strange)
    labels = np.array([index[name] for name in names], np.intp)
    if len(set(labels.tolist())) == 1:
        warnings.warn(f"all {len(names)} examples are of class {names[0]}: the tree is one leaf", stacklevel=3)
    return Targets(labels, weights, tuple(known))


def numbers_of(given: Sequence[Any], weights: np.ndarray, places: Sequence[Problem], what: str = "target") -> Targets:
    """Numbers, one or the same number of them for each example. Raises NppgError."""
    rows = [list(each) if isinstance(each, tuple | list | np.ndarray) and np.ndim(each) else [each] for each in given]
    wrong = []
    for row, place in zip(rows, places, strict=True):
        found = next((message for each in row if (message := _no_number(alone(each), what))), "")
        if not found and len(row) != len(rows[0]):
            found = f"has {len(row)} targets, the first example {len(rows[0])}"
        wrong += [_at(place, found)] if found else []
    _raise(wrong)
    return Targets(np.array([[float(alone(each)) for each in row] for row in rows], float), weights)


def weights_of(given: Sequence[Any], places: Sequence[Problem]) -> np.ndarray:
    """Weights. Raises NppgError for those that are not above 0."""
    values = [alone(each) for each in given]
    _raise(
        _at(place, f"has the weight {value!r}: a weight is a finite number above 0")
        for value, place in zip(values, places, strict=True)
        if not isinstance(value, int | float) or isinstance(value, bool) or not 0 < value < math.inf
    )
    return np.array(values, float)


def _no_class(name: Any, what: str, are_given: bool) -> str:
    if name is None or name == "" or name != name:
        return f"has no {what}"
    if not isinstance(name, _PLAIN):
        return f"has {name!r}, which is no class"
    if isinstance(name, float) and not are_given and not name.is_integer():
        hint = "Unknown label type: continuous; to learn numbers, regress"
        return f"has infinity for its {what}" if math.isinf(name) else f"has {name!r} for its {what}: {hint}"
    return ""


def _no_number(value: Any, what: str) -> str:
    if value is None or value == "":
        return f"has no {what}"
    if not isinstance(value, int | float) or isinstance(value, bool):
        return f"has {value!r} for its {what}, which is no number: to tell classes apart, classify"
    if isinstance(value, float) and math.isnan(value):
        return f"has NaN for its {what}"
    if isinstance(value, float) and math.isinf(value):
        return f"has infinity for its {what}"
    return "" if abs(value) < 1e150 else f"has {value:g} for its {what}: squares of it are no floats"


def _no_twins(task: Task) -> None:
    """Warns of examples that are the same to all tests."""
    first: dict[tuple, int] = {}
    twins = []
    for i, each in enumerate(task.examples):
        if each.key and not each.facts and first.setdefault(each.key, i) != i:
            twins.append((first[each.key], i))
    if twins:
        a, b = (task.examples[i] for i in twins[0])
        key = ", ".join(map(str, a.key))
        where = [f"on line {task.examples[i].line}" if a.line else f"number {i + 1}" for i in twins[0]]
        other = "" if a.target == b.target else f", with the targets {a.target} and {b.target}"
        more = f" [{len(twins) - 1} more]" if len(twins) > 1 else ""
        message = f"the key {key} has two examples, {where[0]} and {where[1]}{other}{more}"
        warnings.warn(str(Problem(task.examples_file, b.line, 0, message)), stacklevel=4)


def _at(place: Problem, message: str) -> Problem:
    return Problem(place.file, place.line, place.column, f"{place.message} {message}")


def _raise(problems: Any) -> None:
    found = list(problems)
    if found:
        more = [Problem("", 0, 0, f"{len(found) - _MOST} more mistakes")] if len(found) > _MOST else []
        raise InputError([*found[:_MOST], *more])
