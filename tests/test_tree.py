"""Trees and ordered lists of rules are the same functions."""

from __future__ import annotations

from itertools import count
from random import Random

import pytest
from samples import pairs, random_query, random_tree, value_of_list, value_of_tree, visited

from nppg.logic.forms import Forms
from nppg.logic.query import Literal, Query, Var
from nppg.trees.tree import Leaf, Node, Rule, Tree, from_rules, leaves, rules


@pytest.fixture
def tests_of(setting):
    _, bias, _, _ = setting
    return bias.forms.deciding_tests


@pytest.fixture
def examples(setting):
    states, actions = pairs(setting[0], visited(setting[0], 6))
    return list(zip(states, actions, strict=True))


@pytest.mark.parametrize("seed", range(6))
def test_the_decision_list_is_the_tree(setting, tests_of, examples, seed: int) -> None:
    _, bias, refiner, _ = setting
    tree = random_tree(refiner, 5, Random(seed))
    ordered = list(rules(tree))
    again = from_rules(ordered, tests_of)
    assert leaves(tree) == len(ordered) and not ordered[-1].query
    values = set()
    for state, action in examples:
        value = value_of_tree(tree, bias, state, action)
        assert value == value_of_list(ordered, bias, state, action)
        assert value == value_of_tree(again, bias, state, action)
        values.add(value)
    assert len(values) > 1 or leaves(tree) == 1


@pytest.mark.parametrize("seed", range(6))
def test_a_list_that_comes_from_no_tree_keeps_its_meaning(setting, tests_of, examples, seed: int) -> None:
    _, bias, refiner, _ = setting
    random, value = Random(seed), count()
    queries: list[Query] = []
    for _ in range(8):
        shared = random.choice(queries) if queries and random.random() < 0.5 else ()
        queries.append(shared[: random.randint(0, len(shared))] or random_query(refiner, random.randint(1, 3), random))
    queries += [(), random_query(refiner, 2, random), ()]  # the last two are never reached
    ordered = [Rule(query, float(next(value))) for query in queries]
    tree = from_rules(ordered, tests_of)
    for state, action in examples:
        assert value_of_tree(tree, bias, state, action) == value_of_list(ordered, bias, state, action)


def test_rules_that_share_literals_share_a_node() -> None:
    p, q, r = (Literal(name, (Var(0),)) for name in "pqr")
    tree: Tree = Node(
        (p,),
        ((p,),),
        Node((q,), ((q,),), Leaf(1.0), Node((r,), ((r,),), Leaf(2.0), Leaf(3.0))),
        Node((q,), ((q,),), Leaf(4.0), Leaf(5.0)),
    )
    assert from_rules(list(rules(tree)), Forms(1).deciding_tests) == tree


@pytest.mark.parametrize("ordered", [[], [Rule((Literal("p", (Var(0),)),), 1.0)]])
def test_a_list_that_does_not_cover_everything_is_refused(ordered) -> None:
    with pytest.raises(ValueError, match="the last rule"):
        from_rules(ordered, lambda query, literals: (literals,))
