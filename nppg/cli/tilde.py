"""nppg tilde."""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from nppg.errors import NppgError
from nppg.tilde import printing
from nppg.tilde.knowledge import Knowledge
from nppg.tilde.learning import Learner, cross_validated
from nppg.tilde.model import Model, Passes
from nppg.tilde.model_file import read_model, write_model
from nppg.tilde.reading import data_sets, read_task
from nppg.tilde.retargeting import retargeted
from nppg.tilde.targets import Targets
from nppg.tilde.task import HEURISTICS, PRUNING, Task

_OPTIONS = {  # of nppg tilde fit, by the settings that they give
    "heuristic": (str, [*HEURISTICS["classify"], *HEURISTICS["regress"]], "what tests are judged by"),
    "minimal_cases": (int, None, "examples in each leaf, at least"),
    "max_depth": (int, None, "tests on the longest path, at most; 0: any number"),
    "significance": (float, None, "level of the F-test that a test must pass to regress; 1: no F-test"),
    "pruning": (str, PRUNING, "by C4.5's estimate, only where the classes stay, by examples kept aside, or none"),
    "confidence": (float, None, "of C4.5's estimate"),
    "validation_share": (float, None, "of the examples, kept aside to prune by"),
    "granularity": (int, None, "thresholds of a bound that are tried at a node, at most; 0: all"),
    "n_estimators": (int, None, "trees"),
    "learning_rate": (float, None, "add trees up, so much of each; without it, trees of samples vote"),
}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """What to do, with the arguments of each."""
    verbs = parser.add_subparsers(dest="verb", metavar="fit | predict | show", required=True)
    fit = verbs.add_parser("fit", help="learn a tree from examples, and print it", allow_abbrev=False)
    _add_data(fit)
    fit.add_argument("--target", metavar="LITERAL", help="what is told of what: 'logp(+mol, -number)'")
    for name, (kind, choices, help) in _OPTIONS.items():
        metavar = None if choices else kind.__name__.upper()
        fit.add_argument(f"--{name.replace('_', '-')}", type=kind, choices=choices, metavar=metavar, help=help)
    fit.add_argument("--seed", type=int, dest="random_state", metavar="N", help="of what is drawn (default: 0)")
    fit.add_argument("--cross-validate", type=int, metavar="FOLDS", help="say what trees get right in folds left out")
    fit.add_argument("--output", type=Path, metavar="FILE", help="write the model there")
    predict = verbs.add_parser("predict", help="say what a model says of examples", allow_abbrev=False)
    predict.add_argument("model", type=Path, help="a file that fit has written")
    _add_data(predict)
    show = verbs.add_parser("show", help="print a model's trees and rules", allow_abbrev=False)
    show.add_argument("model", type=Path, help="a file that fit has written")


def _add_data(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("data", nargs="+", type=Path, help="a folder, or files of ACE, of Aleph or of nppg convert")


def run(options: argparse.Namespace) -> int:
    """Raises NppgError."""
    if options.verb == "fit":
        return _fit(options)
    return _predict(options) if options.verb == "predict" else _show(options)


def _fit(options: argparse.Namespace) -> int:
    """Of each data set where a folder has several; what is wrong with one of these does not keep from the others."""
    sets = data_sets(options.data)
    if len(sets) > 1 and options.output:
        raise NppgError(f"--output takes one model: name one of {', '.join(str(path) for path, in sets)}")
    status = 0
    for number, data in enumerate(sets):
        if len(sets) > 1:
            print(*["\n"] * (number > 0), f"{data[0]}:", sep="")
        try:
            _fit_one(options, data)
        except NppgError as error:
            if len(sets) == 1:
                raise
            print(error, file=sys.stderr)
            status = 2
    return status


def _fit_one(options: argparse.Namespace, data: Sequence[Path]) -> None:
    begun = time.perf_counter()
    task = read_task(data)
    if options.target:
        task = retargeted(task, options.target)
    given = {name: value for name in (*_OPTIONS, "random_state") if (value := getattr(options, name)) is not None}
    settings = replace(task.settings, **given)
    task = replace(task, settings=settings)
    for problem in task.left_out:
        print(f"left out: {problem}")
    learner = Learner(task)
    read = time.perf_counter()
    print(_told(task, learner.targets), f"{len(learner.coverage.table)} tests at the root", sep=", ")
    model = learner.model(settings)
    learned = time.perf_counter()
    print("", *_trees(model), sep="\n")
    print("\nof the training examples:")
    _judge(learner.targets, learner.passes.outputs(model, learner.all))
    if options.cross_validate is not None:
        outputs = cross_validated(learner, settings, options.cross_validate, lambda _: None)
        print(f"\nof {options.cross_validate} folds, each left out in turn:")
        _judge(learner.targets, outputs)
    if options.output:
        write_model(options.output, model)
        print(f"\nwritten to {options.output}")
    print(f"\nread in {read - begun:.2f} s, learned in {learned - read:.2f} s")


def _told(task: Task, targets: Targets) -> str:
    what = f"{len(targets.classes)} classes" if targets.classes else "a number"
    if not targets.classes and targets.values.shape[1] > 1:
        what = f"{targets.values.shape[1]} numbers"
    return f"{task.name}: {len(task.examples)} examples, {what} to tell"


def _trees(model: Model) -> list[str]:
    trees = model.trees
    if len(trees) > 1:
        return [f"{len(trees)} trees, the first of them:", "", printing.tree_text(trees[0], model)]
    return [printing.tree_text(trees[0], model), "", printing.rules_text(trees[0], model)]


def _judge(targets: Targets, outputs: np.ndarray) -> None:
    if not targets.classes:
        print(printing.errors_text(targets.values, outputs))
        return
    said = outputs.argmax(axis=1)
    right = int((said == targets.values).sum())
    print(f"accuracy {right / len(said):.4f} = {right}/{len(said)}")
    print(printing.confusion(targets.values, said, targets.classes))


def _predict(options: argparse.Namespace) -> int:
    model = read_model(options.model)
    task = read_task(options.data)
    knowledge = Knowledge(task, model.predicates)
    outputs = Passes(knowledge, model.bias, task.examples).outputs(model, np.arange(len(task.examples)))
    for example, output in zip(task.examples, outputs, strict=True):
        name = example.name or ", ".join(map(str, example.key))
        print(name, *_said(output, model), sep="\t")
    return 0


def _said(output: np.ndarray, model: Model) -> Sequence[str]:
    if model.classes:
        best = int(output.argmax())
        return str(model.classes[best]), f"{output[best]:.4f}"
    return [f"{value:.6g}" for value in output]


def _show(options: argparse.Namespace) -> int:
    model = read_model(options.model)
    for i, tree in enumerate(model.trees, 1):
        parts = [printing.tree_text(tree, model), "", printing.rules_text(tree, model), ""]
        print(*([f"% tree {i}"] if len(model.trees) > 1 else []), *parts, sep="\n")
    return 0
