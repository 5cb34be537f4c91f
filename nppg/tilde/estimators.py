"""TILDE in scikit-learn's manner, which need not be installed.

X is a sequence of examples: keys into the `facts`, or collections of facts, one for each example, under a language
`bias`, a text of YAML or its file; or, without a bias, a table whose columns are tested. See docs/tilde.md.
"""

from __future__ import annotations

import inspect
import warnings
from collections.abc import Collection, Sequence
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.plain import alone
from nppg.bridge.terms import Ground
from nppg.errors import NppgError, Problem, suggestion
from nppg.tilde import printing
from nppg.tilde.examples import Columns, columns_of, examples_of, table_examples
from nppg.tilde.knowledge import Knowledge
from nppg.tilde.learning import Learner
from nppg.tilde.model import Model, Passes
from nppg.tilde.own import language
from nppg.tilde.program import read_text
from nppg.tilde.targets import InputError, Targets, classes_of, numbers_of, weights_of
from nppg.tilde.task import CLASSIFY, REGRESS, SETTINGS, Example, Settings, Task

if TYPE_CHECKING:
    from typing_extensions import Self


class Estimator:
    """What classifier and regressor have in common. Fitted, it has `model_`."""

    _mode = ""

    def __init__(
        self,
        bias: LanguageBias | str | Path | None = None,
        background: str = "",
        facts: Collection[Ground] = (),
        *,
        heuristic: str = "",
        minimal_cases: int = 2,
        max_depth: int = 0,
        significance: float = 1.0,
        pruning: str = "",
        confidence: float = 0.25,
        validation_share: float = 0.25,
        granularity: int = 0,
        n_estimators: int = 1,
        learning_rate: float | None = None,
        random_state: int | None = 0,
    ):
        self.bias = bias
        self.background = background
        self.facts = facts
        self.heuristic = heuristic
        self.minimal_cases = minimal_cases
        self.max_depth = max_depth
        self.significance = significance
        self.pruning = pruning
        self.confidence = confidence
        self.validation_share = validation_share
        self.granularity = granularity
        self.n_estimators = n_estimators
        self.learning_rate = learning_rate
        self.random_state = random_state

    @classmethod
    def of(cls, task: Task) -> Self:
        """With the language, the knowledge and the settings of a task; to be fitted to `task.examples`."""
        given = {name: getattr(task.settings, name) for name in SETTINGS if name != "mode"}
        return cls(task.bias, task.background, task.facts, **given)

    def get_params(self, deep: bool = True) -> dict[str, Any]:
        """The arguments that it was made with, by name."""
        return {name: getattr(self, name) for name in _PARAMETERS}

    def set_params(self, **params: Any) -> Self:
        """Changes some of them. Raises InputError for a name that is none."""
        for name, value in params.items():
            if name not in _PARAMETERS:
                known = ", ".join(_PARAMETERS)
                what = f"Invalid parameter {name!r} for estimator {type(self).__name__}"
                raise InputError(f"{what}{suggestion(name, _PARAMETERS)}: there are {known}")
            setattr(self, name, value)
        return self

    def __repr__(self) -> str:
        given = {
            name: value
            for name, value in self.get_params().items()
            if not _is_same(value, inspect.signature(Estimator).parameters[name].default)
        }
        return f"{type(self).__name__}({', '.join(f'{name}={_short(value)}' for name, value in given.items())})"

    def fit(self, X: Any, y: Any = None, sample_weight: Any = None) -> Self:
        """Learns from examples and their targets. Raises InputError with the number, from 0, of a wrong example."""
        settings = self.settings()
        columns = None if self.bias is not None else columns_of(X)
        bias = columns.bias if columns else self._bias()
        examples = self._examples(X, bias, columns)
        targets, kept = self._targets(y, sample_weight, len(examples))
        examples = [examples[i] for i in kept]
        task = Task(type(self).__name__, bias, tuple(examples), tuple(self.facts), self.background, settings=settings)
        self._columns = columns
        if columns:
            self.n_features_in_ = len(columns.names)
            if columns.are_named:
                self.feature_names_in_ = np.array(columns.names, object)
        self._learned(Learner(task, targets).model(settings), targets)
        return self

    def settings(self) -> Settings:
        """Its own, checked. Raises InputError."""
        given = {name: alone(getattr(self, name)) for name in SETTINGS if name != "mode"}
        given["random_state"] = _seed(self.random_state)
        try:
            return Settings(mode=self._mode, **given)
        except NppgError as error:
            raise InputError(error.problems) from None

    def _bias(self) -> LanguageBias:
        if isinstance(self.bias, LanguageBias):
            return self.bias
        if isinstance(self.bias, str) and ("\n" in self.bias or ": " in self.bias):
            return language(self.bias)
        if isinstance(self.bias, str | Path):
            return language(read_text(Path(self.bias)), str(self.bias))
        raise InputError(f"bias is a text of YAML, the path of one, or None for a table, not {self.bias!r}")

    def _examples(self, X: Any, bias: LanguageBias, columns: Columns | None) -> list[Example]:
        if columns:
            return table_examples(X, columns, type(self).__name__)
        return examples_of(X, len(bias.actions[0].types))

    def _targets(self, y: Any, sample_weight: Any, count: int) -> tuple[Targets, list[int]]:
        """The targets of those examples that have some weight, and which these are."""
        if y is None:
            raise InputError(f"{type(self).__name__} requires y to be passed, but the target y is None")
        rows = _target_rows(y)
        if len(rows) != count:
            raise InputError(f"Found input variables with inconsistent numbers of samples: [{count}, {len(rows)}]")
        if sample_weight is None:
            weights = [1.0] * count
        else:
            given = np.asarray(sample_weight)
            weights = given.tolist() if given.ndim else [given.item()] * count
            if given.ndim > 1:
                raise InputError("Sample weights must be 1D array or scalar")
            if len(weights) != count:
                raise InputError(f"there are {len(weights)} weights of {count} examples")
        kept = [i for i, weight in enumerate(weights) if weight != 0]
        if not kept:
            raise InputError("all sample weights are zero: there is no example with a weight above 0")
        places = [Problem("", 0, 0, f"example {i}") for i in kept]
        checked = weights_of([weights[i] for i in kept], places)
        find = classes_of if self._mode == CLASSIFY else numbers_of
        return find([rows[i] for i in kept], checked, places), kept

    def _learned(self, model: Model, targets: Targets) -> None:
        self.model_ = model

    def outputs(self, X: Any) -> np.ndarray:
        """What the model says of examples, shape (examples, outputs): probabilities of classes, or numbers."""
        if not hasattr(self, "model_"):
            message = f"This {type(self).__name__} instance is not fitted yet: call fit first"
            raise _of_sklearn("exceptions", "NotFittedError", InputError)(message)
        examples = self._examples(X, self.model_.bias, self._columns)
        task = Task("", self.model_.bias, tuple(examples), tuple(self.facts), self.background)
        knowledge = Knowledge(task, self.model_.predicates)
        return Passes(knowledge, self.model_.bias, examples).outputs(self.model_, np.arange(len(examples)))

    def tree_text(self, number: int = 0) -> str:
        """A tree of the model as people read it."""
        return printing.tree_text(self.model_.trees[number], self.model_)

    def rules_text(self, number: int = 0) -> str:
        """A tree of the model as ordered clauses, of which the first that holds counts."""
        return printing.rules_text(self.model_.trees[number], self.model_)

    def __sklearn_is_fitted__(self) -> bool:
        return hasattr(self, "model_")

    def __sklearn_tags__(self) -> Any:
        """For scikit-learn, which asks for them."""
        tags = import_module("sklearn.utils")
        found = tags.Tags(
            estimator_type="classifier" if self._mode == CLASSIFY else "regressor",
            target_tags=tags.TargetTags(required=True, multi_output=self._mode == REGRESS),
            classifier_tags=tags.ClassifierTags() if self._mode == CLASSIFY else None,
            regressor_tags=tags.RegressorTags() if self._mode == REGRESS else None,
            input_tags=tags.InputTags(allow_nan=True, string=True, categorical=True),
        )
        return found


class TildeClassifier(Estimator):
    """A relational classification tree, or several that vote (`n_estimators`) or are added up (`learning_rate`).

    Fitted, it has `classes_`, sorted."""

    _mode = CLASSIFY
    _estimator_type = "classifier"

    def _learned(self, model: Model, targets: Targets) -> None:
        super()._learned(model, targets)
        self.classes_ = np.array(targets.classes)

    def predict(self, X: Any) -> np.ndarray:
        """The most probable class of each example, the first of those."""
        best = self.predict_proba(X).argmax(axis=1)
        return self.classes_[best]

    def predict_proba(self, X: Any) -> np.ndarray:
        """Shape (examples, classes), in the order of `classes_`."""
        return self.outputs(X)

    def score(self, X: Any, y: Any, sample_weight: Any = None) -> float:
        """The share of examples whose class it predicts."""
        return float(np.average(self.predict(X) == np.asarray(y), weights=sample_weight))


class TildeRegressor(Estimator):
    """A relational regression tree of one target or several, or trees that vote or are added up."""

    _mode = REGRESS
    _estimator_type = "regressor"

    def _learned(self, model: Model, targets: Targets) -> None:
        super()._learned(model, targets)
        self.n_outputs_ = targets.values.shape[1]

    def predict(self, X: Any) -> np.ndarray:
        """Shape (examples,), or (examples, targets) where there are several."""
        found = self.outputs(X)
        return found[:, 0] if self.n_outputs_ == 1 else found

    def score(self, X: Any, y: Any, sample_weight: Any = None) -> float:
        """The share of the targets' variance that is explained (R2), the mean over the targets."""
        truth, said = np.asarray(y, float).reshape(len(X), -1), self.predict(X).reshape(len(X), -1)
        weights = np.ones(len(X)) if sample_weight is None else np.asarray(sample_weight, float)
        off = np.average((truth - said) ** 2, axis=0, weights=weights)
        spread = np.average((truth - np.average(truth, axis=0, weights=weights)) ** 2, axis=0, weights=weights)
        return float(np.mean(np.where(spread > 0, 1 - off / np.where(spread > 0, spread, 1.0), (off == 0) * 1.0)))


_PARAMETERS = tuple(inspect.signature(Estimator).parameters)


def _target_rows(y: Any) -> Sequence[Any]:
    """One target, or one list of several, for each example."""
    if hasattr(y, "tocsr"):
        raise InputError("y is a sparse matrix: a dense one is wanted")
    array = y if isinstance(y, list | tuple) else np.asarray(y)
    if isinstance(array, np.ndarray):
        if array.dtype.kind == "c":
            raise InputError("Complex data not supported: y has complex numbers")
        if array.ndim == 2 and array.shape[1] == 1:
            kind = _of_sklearn("exceptions", "DataConversionWarning", UserWarning)
            message = "A column-vector y was passed when a 1d array was expected: give y of the shape (n_samples,)"
            warnings.warn(message, kind, stacklevel=4)
            array = array[:, 0]
        if array.ndim not in (1, 2):
            raise InputError(f"y should be a 1d array, got an array of shape {array.shape} instead.")
        return array.tolist()
    return list(array)


def _of_sklearn(module: str, name: str, otherwise: type) -> Any:
    """A class of scikit-learn's, where that is installed."""
    try:
        return getattr(import_module(f"sklearn.{module}"), name)
    except ImportError:
        return otherwise


def _seed(random_state: Any) -> int:
    if random_state is None:
        return int(np.random.default_rng().integers(2**31))
    if hasattr(random_state, "randint"):
        return int(random_state.randint(2**31 - 1))
    return alone(random_state)


def _is_same(value: Any, default: Any) -> bool:
    return type(value) is type(default) and value == default


def _short(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 60 else f"{text[:57]}..."
