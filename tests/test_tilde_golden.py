"""ACE's own examples, in the folder that NPPG_TILDE names, against what ACE printed of them:

NPPG_TILDE=FOLDER pytest tests/test_tilde_golden.py
"""

import os
from dataclasses import replace
from pathlib import Path

import pytest
from ace_output import same, tree_of, value

from nppg.tilde.learning import Learner
from nppg.tilde.printing import tree_text
from nppg.tilde.reading import read_task
from nppg.trees.pruning import expected_errors, leaves_of, safe
from nppg.trees.tree import Leaf

FOLDER = Path(os.environ.get("NPPG_TILDE", ""))
pytestmark = pytest.mark.skipif("NPPG_TILDE" not in os.environ, reason="NPPG_TILDE names no folder with ACE's examples")

SOLVED = ["muta", "bongard/keys", "bongard/examples", "mach/keys", "mach/examples"]
ALEPH = {  # the trees by their numbers of leaves, and of examples that they get right
    "good": (3, 10), "features": (3, 10), "gcws": (4, 1600), "numbers/guess": (2, 7), "numbers/ineq": (2, 7),
    "numbers/line": (1, 4), "numbers/miline": (1, 6),
}  # fmt: skip


def literals(tree):
    return 0 if isinstance(tree, Leaf) else len(tree.literals) + literals(tree.yes) + literals(tree.no)


def ties_to_the_last(tree):
    """ACE gives a leaf whose classes tie to the last of them, nppg to the first: it shows where only what predicts the
    same is joined."""
    if isinstance(tree, Leaf):
        last = max(range(len(tree.values)), key=lambda i: (tree.values[i], i))
        return replace(tree, value=float(last))
    return replace(tree, yes=ties_to_the_last(tree.yes), no=ties_to_the_last(tree.no))


def right(tree):
    return sum(leaf.values[int(leaf.value)] for leaf in leaves_of(tree))


@pytest.mark.parametrize("name", SOLVED)
def test_what_ace_printed(name):
    (output,) = (FOLDER / name).glob("*.out.tilde")
    printed = output.read_text()
    task = read_task([FOLDER / name])
    learner = Learner(task)
    found = learner.tree(task.settings, learner.all)
    trees = {"compact": safe(ties_to_the_last(found.whole)), "pruned": found.pruned}
    for what, tree in trees.items():
        assert len(leaves_of(tree)) - 1 == value(printed, f"{what}_complexity")
        assert f"({literals(tree)} literals)" in printed
        assert right(tree) / len(task.examples) == pytest.approx(value(printed, f"{what}_training_accuracy"), abs=1e-12)
        errors = expected_errors(tree, task.settings.confidence)
        assert errors == pytest.approx(value(printed, f"{what}_C4.5_error_estimation"), abs=1e-9)
    model = learner.model(task.settings)
    theirs = tree_of(printed.split("Compact notation of pruned tree:")[1].split("Equivalent prolog program")[0])
    assert same(tree_of(tree_text(model.tree, model)), theirs, {"A": "A"} if task.bias.roots else {})


def test_probabilities_are_told():
    task = read_task([FOLDER / "mach" / "examples-experimental"])
    assert any("probabilities" in problem.message for problem in task.left_out)
    learner = Learner(task)
    assert right(learner.tree(task.settings, learner.all).pruned) == 14


@pytest.mark.parametrize("name", ALEPH)
def test_aleph(name):
    task = read_task([FOLDER / "aleph" / name])
    learner = Learner(task)
    tree = learner.tree(task.settings, learner.all).pruned
    assert (len(leaves_of(tree)), right(tree)) == ALEPH[name]
