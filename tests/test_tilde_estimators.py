"""TILDE on its own: classes, several targets, weights, pruning, trees together, and what it says of mistakes."""

from __future__ import annotations

import warnings

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from nppg import NppgError
from nppg.bias.refinement import Refiner
from nppg.logic.query import Literal, Var
from nppg.tilde import Settings, Task, TildeClassifier, TildeRegressor, language
from nppg.tilde.knowledge import Knowledge
from nppg.tilde.learning import Learner, cross_validated, folds
from nppg.tilde.model_file import read_model, write_model
from nppg.tilde.task import Example
from nppg.trees.pruning import added_errors, expected_errors, pessimistic, safe
from nppg.trees.tree import Leaf, Node, leaves

LANGUAGE = """
example: m(+mol)
types: {atom: [mol, id, element, charge], bond: [mol, id, id]}
modes:
  - {literal: "atom(+mol, -id, #element, -charge)", lookahead: 1}
  - {literal: "bond(+mol, +id, -id)", lookahead: 1}
  - "+charge >= #"
"""
BIAS = language(LANGUAGE)
NUMBERED = "example: e(+k)\nmodes: ['p(+k, #n)']"


def molecules(count: int, seed: int = 0) -> tuple[list[int], list[tuple], list[str]]:
    """Keys, facts, and whether there is a nitrogen of a charge of at least 0.5."""
    rng = np.random.default_rng(seed)
    facts: list[tuple] = []
    classes = []
    for key in range(count):
        own = [(str(rng.choice(["c", "n", "o"])), round(float(rng.random()), 3)) for _ in range(2)]
        facts += [("atom", key, f"a{i}", *each) for i, each in enumerate(own)] + [("bond", key, "a0", "a1")]
        classes.append("yes" if any(element == "n" and charge >= 0.5 for element, charge in own) else "no")
    return list(range(count)), facts, classes


def models(keys: list[int], facts: list[tuple]) -> list[list[tuple]]:
    return [[(name, *args) for name, own, *args in facts if own == key] for key in keys]


WITHOUT_KEY = LANGUAGE.replace("m(+mol)", "example").replace("+mol, ", "").replace("[mol, ", "[")


def test_keys_and_models_give_one_tree_that_is_exact():
    keys, facts, classes = molecules(60)
    by_key = TildeClassifier(BIAS, facts=facts).fit(keys, classes)
    own = models(keys, facts)
    by_model = TildeClassifier(WITHOUT_KEY).fit(own, classes)
    assert by_key.score(keys, classes) == by_model.score(own, classes) == 1
    assert leaves(by_key.model_.tree) == leaves(by_model.model_.tree) == 2
    assert by_key.rules_text().splitlines()[0].startswith("m(A, yes) :- atom(A, B, n, C), C >= 0.")
    more, others, expected = molecules(40, 1)
    assert by_model.predict(models(more, others)).tolist() == expected


def test_facts_of_all_and_of_one_and_clauses_make_one_predicate():
    examples = [Example((1,), "a", facts=(("p", 1, 5),)), Example((2,), "b"), Example((3,), "a"), Example((4,), "b")]
    bias = language(NUMBERED)
    task = Task("t", bias, tuple(examples), (("p", 2, 4), ("q", 4)), "p(3, 5). p(X, 4) :- q(X).")
    knowledge = Knowledge(task)
    assert sorted(knowledge.solutions("p", 2)) == [(2, 4), (3, 5), (4, 4)]
    assert sorted(knowledge.solutions("p", 2, examples[0])) == [(1, 5), (2, 4), (3, 5), (4, 4)]
    assert knowledge.complete(bias).modes[0].args[1].constants == (4, 5)
    assert ("p", 2) in knowledge.predicates and ("p (static)", 2) not in knowledge.predicates
    learner = Learner(task)
    model = learner.model(task.settings)
    assert learner.passes.outputs(model, learner.all).argmax(axis=1).tolist() == [0, 1, 0, 1]


def test_a_name_of_the_contract_is_a_name_like_others():
    bias = "example: e(+k)\nmodes: ['cost(+k, #n)']"
    model = TildeClassifier(bias, facts=[("cost", "a", 1), ("cost", "b", 1), ("goal",)], minimal_cases=1)
    assert model.fit(["a", "b", "c"], [1, 1, 0]).predict(["b", "c"]).tolist() == [1, 0]


def test_recall_and_lookahead_templates():
    text = """
modes:
  - {literal: t(+-o), recall: 1}
  - in(+o, -o)
lookaheads: ["in(A, B), t(B), c(B, [up])"]
lookahead: 1
"""
    first, inside = (Literal("t", (Var(0),)),), Literal("in", (Var(0), Var(1)))
    found = {each.literals for each in Refiner(language(text)).refinements(first)}
    assert (inside,) in found
    assert not any(each[0].name == "t" for each in found)  # recall 1
    assert not any(len(each) > 1 for each in found)  # the template's t is one too many, too
    found = {each.literals for each in Refiner(language(text.replace(", recall: 1", ""))).refinements(first)}
    assert (inside, Literal("t", (Var(1),)), Literal("c", (Var(1), "up"))) in found


def test_one_name_with_two_arities():
    bias = language("example: e(+k)\nmodes: ['p(+k)', 'p(+k, #n)']")
    assert bias.types_of("p", 2) == ("k", "n") and bias.types_of("p", 3) is None
    model = TildeClassifier(bias, facts=[("p", 1), ("p", 2), ("p", 2, 7), ("p", 3, 7)], minimal_cases=1, pruning="none")
    assert model.fit([1, 2, 3, 4], list("abcd")).predict([1, 2, 3, 4]).tolist() == list("abcd")


def test_several_targets_and_weights():
    keys, facts, classes = molecules(60)
    y = np.array([[2.0, -1.0] if each == "yes" else [0.0, 3.0] for each in classes])
    model = TildeRegressor(BIAS, facts=facts).fit(keys, y)
    assert model.predict(keys).tolist() == y.tolist() and model.score(keys, y) == 1
    assert leaves(model.model_.tree) == 2


@settings(max_examples=10, deadline=None)
@given(st.integers(0, 1000))
def test_a_weight_is_so_many_examples(seed):
    rng = np.random.default_rng(seed)
    X, y, weights = rng.integers(0, 4, (12, 2)), rng.integers(0, 2, 12), rng.integers(0, 3, 12)
    if len(set(y[weights > 0])) < 2:
        return
    for kind in (TildeClassifier, TildeRegressor):
        one = kind().fit(X, y, weights).outputs(X)
        many = kind().fit(np.repeat(X, weights, axis=0), np.repeat(y, weights)).outputs(X)
        assert np.allclose(one, many)


@pytest.mark.parametrize(
    "options", [{}, {"pruning": "validation"}, {"n_estimators": 5}, {"n_estimators": 8, "learning_rate": 0.5}]
)
def test_ways_to_learn(options):
    keys, facts, classes = molecules(60)
    model = TildeClassifier(BIAS, facts=facts, max_depth=3, **options).fit(keys, classes)
    assert model.score(keys, classes) > 0.95
    assert np.allclose(model.predict_proba(keys).sum(axis=1), 1)
    assert model.model_ == TildeClassifier(BIAS, facts=facts, max_depth=3, **options).fit(keys, classes).model_
    numbers = [float(each == "yes") for each in classes]
    assert TildeRegressor(BIAS, facts=facts, max_depth=3, **options).fit(keys, numbers).score(keys, numbers) > 0.9


def test_three_classes_added_up():
    X = np.arange(30)[:, None]
    y = np.repeat(["a", "b", "c"], 10)
    assert TildeClassifier(n_estimators=10, learning_rate=0.5).fit(X, y).score(X, y) == 1


def test_the_pessimistic_estimate_is_that_of_c45():
    """As ACE prints it of its tree of mutagenesis, and of mach."""
    errors = [(7, 1), (20, 0), (4, 0), (6, 2), (60, 11), (12, 5), (36, 7), (6, 0), (79, 24)]
    assert sum(wrong + added_errors(size, wrong, 0.25) for size, wrong in errors) == pytest.approx(66.6546112633088)
    found = expected_errors(Node((), (), Leaf(0.0, 6, (6.0, 0.0)), Leaf(1.0, 3, (0.0, 3.0))), 0.25)
    assert found + added_errors(6, 0, 0.25) == pytest.approx(3.58571211334849)


def test_pruning():
    same = Node((), (), Leaf(0.0, 5, (4.0, 1.0)), Leaf(0.0, 5, (5.0, 0.0)))
    assert safe(same) == Leaf(0.0, 10, (9.0, 1.0))
    kept = Node((), (), Leaf(0.0, 20, (20.0, 0.0)), Leaf(1.0, 20, (0.0, 20.0)))
    assert safe(kept) == pessimistic(kept, 0.25) == kept
    lonely = Node((), (), Leaf(0.0, 40, (30.0, 10.0)), Leaf(1.0, 2, (1.0, 1.0)))
    assert pessimistic(lonely, 0.25) == Leaf(0.0, 42, (31.0, 11.0))


def test_folds_have_all_examples_and_each_class():
    keys, facts, classes = molecules(50)
    task = Task("t", BIAS, tuple(Example((k,), c) for k, c in zip(keys, classes, strict=True)), tuple(facts))
    learner = Learner(task)
    parts = folds(learner.targets, 5, np.random.default_rng(0))
    assert sorted(np.concatenate(parts).tolist()) == keys
    shares = [np.mean(learner.targets.values[part]) for part in parts]
    assert max(shares) - min(shares) <= 0.1 + 1e-9
    said = cross_validated(learner, Settings(), 5, lambda _: None).argmax(axis=1)
    assert np.mean(said == learner.targets.values) > 0.9
    with pytest.raises(NppgError, match="folds must be"):
        folds(learner.targets, 51, np.random.default_rng(0))


def test_a_model_comes_back_from_its_file(tmp_path):
    keys, facts, classes = molecules(40)
    model = TildeClassifier(BIAS, facts=facts).fit(keys, classes).model_
    write_model(tmp_path / "m.json", model)
    assert read_model(tmp_path / "m.json") == model
    text = (tmp_path / "m.json").read_text()
    for wrong, message in ((text.replace("0.5", "0.6"), "damaged"), ("{}", "is not a model"), ("", "is not a model")):
        (tmp_path / "m.json").write_text(wrong)
        with pytest.raises(NppgError, match=message):
            read_model(tmp_path / "m.json")


@pytest.mark.parametrize(
    ("y", "message"),
    [
        ([1.0, float("nan"), 2.0], "example 1 has NaN"),
        ([1.0, 2.0, float("inf")], "example 2 has infinity"),
        ([None, 1.0, 2.0], "example 0 has no target"),
        (["x", 1.0, 2.0], "which is no number"),
        ([(1.0, 2.0), (1.0,), (1.0, 2.0)], "example 1 has 1 targets, the first example 2"),
        ([1.0], "inconsistent numbers of samples"),
    ],
)
def test_wrong_targets(y, message):
    with pytest.raises(ValueError, match=message):
        TildeRegressor(BIAS, facts=[("atom", 1, "a", "c", 0.5), ("bond", 1, "a", "a")]).fit([1, 2, 3], y)


def test_mistakes_are_told():
    keys, facts, classes = molecules(10)
    with pytest.raises(NppgError, match=r"no predicate atm/4 \(did you mean 'atom'\?\)"):
        TildeClassifier(LANGUAGE.replace("atom", "atm"), facts=facts).fit(keys, classes)
    with pytest.raises(NppgError, match=r"no predicate bond/2 \(it has bond/3\)"):
        TildeClassifier("modes: ['bond(+-id, -id)']", facts=facts).fit([[("a",)]] * 10, classes)
    with pytest.warns(UserWarning, match=r"no predicate bond/3: it never holds"):
        TildeClassifier(BIAS, facts=[each for each in facts if each[0] == "atom"]).fit(keys, classes)
    with pytest.raises(NppgError, match="there are no examples"):
        TildeClassifier(BIAS, facts=facts).fit([], [])
    with pytest.raises(NppgError, match=r"example 0 of X is .* a key of 1 value is wanted"):
        TildeClassifier(BIAS, facts=facts).fit([[("atom", "a")]], ["x"])
    with pytest.raises(NppgError, match="max_depth must be"):
        TildeClassifier(BIAS, facts=facts, max_depth=-1).fit(keys, classes)
    with pytest.raises(NppgError, match="background knowledge:2"):
        TildeClassifier(BIAS, "p(1).\nq(X) :- r(X).", facts).fit(keys, classes)
    with pytest.warns(UserWarning, match="all 10 examples are of class x"):
        TildeClassifier(BIAS, facts=facts).fit(keys, ["x"] * 10)
    with pytest.raises(ValueError, match="call fit first"):
        TildeClassifier(BIAS, facts=facts).predict(keys)


def test_two_examples_with_one_key_are_told():
    keys, facts, _ = molecules(3)
    examples = [Example((0,), "a", line=3), Example((1,), "b", line=4), Example((0,), "b", line=7)]
    with pytest.warns(
        UserWarning, match=r"x.pl:7: the key 0 has two examples, on line 3 and on line 7, with the targets a and b"
    ):
        Learner(Task("t", BIAS, tuple(examples), tuple(facts), examples_file="x.pl"))
    assert keys


def test_parameters():
    model = TildeClassifier(max_depth=3)
    assert model.get_params()["max_depth"] == 3 and repr(model) == "TildeClassifier(max_depth=3)"
    assert model.set_params(max_depth=4) is model and model.max_depth == 4
    with pytest.raises(ValueError, match="did you mean 'max_depth'"):
        model.set_params(max_dept=1)


def test_scikit_learn_agrees():
    """check_estimator's general checks, cloning, cross-validation, and a pipeline of relational examples."""
    pytest.importorskip("sklearn")
    from sklearn.base import clone
    from sklearn.model_selection import cross_val_score
    from sklearn.pipeline import make_pipeline
    from sklearn.preprocessing import FunctionTransformer

    keys, facts, classes = molecules(30)
    model = TildeClassifier(BIAS, facts=facts, minimal_cases=1)
    assert clone(model).get_params()["facts"] == facts
    assert cross_val_score(model, keys, classes, cv=3).mean() > 0.8
    pipeline = make_pipeline(FunctionTransformer(lambda keys: list(keys)), model)
    assert pipeline.fit(keys, classes).score(keys, classes) == 1


@pytest.mark.parametrize("kind", [TildeClassifier, TildeRegressor])
def test_scikit_learns_checks(kind):
    checks = pytest.importorskip("sklearn.utils.estimator_checks")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = checks.check_estimator(kind(), on_skip=None, on_fail=None)
    assert [(each["check_name"], each["exception"]) for each in found if each["status"] == "failed"] == []
