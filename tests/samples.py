"""Random states, queries and trees; and the shipped domains' predicates and the truth of a query written down once
more, in Python and without Prolog, for the tests to hold the answers against."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Iterable, Sequence
from pathlib import Path
from random import Random

import numpy as np

from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import KIND, Refinement, Refiner
from nppg.bridge import home as prolog_home
from nppg.bridge.files import locate
from nppg.bridge.seals import sealed
from nppg.bridge.terms import Ground
from nppg.logic.query import OPEN, Query, Var
from nppg.trees.tree import Leaf, Node, Rule, Tree
from nppg.worlds.domain import Domain
from nppg.worlds.world import Action, State

Values = dict[Var, Ground | None]
Relations = dict[str, set[tuple[Ground, ...]]]


def resigned(path: Path, text: str | bytes) -> None:
    """Writes what a file of nppg's was changed to, as `nppg sign` would leave it."""
    path.write_bytes(sealed(text.encode(errors="surrogateescape") if isinstance(text, str) else text))


def visited(domain: Domain, count: int, seed: int = 0) -> list[State]:
    """Running states that random walks from random starts come by."""
    rng = np.random.default_rng(seed)
    found: list[State] = []
    while len(found) < count:
        state = domain.start(rng)
        for _ in range(3):
            situation = domain.situation(state)
            if situation.status == "running":
                found.append(state)
                state = domain.act(state, situation.actions[int(rng.random() * len(situation.actions))], rng)[1]
    return found[:count]


def pairs(domain: Domain, states: Sequence[State]) -> tuple[list[State], list[Action]]:
    """Every state with each of its legal actions."""
    found = [(state, action) for state in states for action in domain.situation(state).actions]
    return [state for state, _ in found], [action for _, action in found]


def random_query(refiner: Refiner, steps: int, rng: Random) -> Query:
    """A path of success branches; new variables are preferred, which make queries that are not just root tests."""
    query: Query = ()
    for _ in range(steps):
        candidates = refiner.refinements(query)
        about_new = [each for each in candidates if len(each.test) > 1 or _has_new(each.test, refiner.root_count)]
        if not candidates:
            break
        query += with_threshold(rng.choice(about_new if about_new and rng.random() < 0.6 else candidates), rng).literals
    return query


def with_threshold(refinement: Refinement, rng: Random) -> Refinement:
    """Closed by a random one, if it is to have one."""
    return refinement.closed(rng.choice([-4.5, -3.0, -1.5, 0.0, 1.5, 2.0, 3.0])) if refinement.is_open else refinement


def _has_new(query: Query, roots: int) -> bool:
    return any(var.index >= roots for literal in query for var in literal.variables())


def random_tree(refiner: Refiner, depth: int, rng: Random, query: Query = ()) -> Tree:
    candidates = refiner.refinements(query)
    if depth == 0 or rng.random() < 0.1 or not candidates:
        return Leaf(rng.gauss(0, 1))
    about_new = [each for each in candidates if _has_new(each.test, refiner.root_count)]
    chosen = with_threshold(rng.choice(about_new if about_new and rng.random() < 0.6 else candidates), rng)
    return Node(
        chosen.literals,
        (chosen.test,),
        random_tree(refiner, depth - 1, rng, query + chosen.literals),
        random_tree(refiner, depth - 1, rng, query),
    )


def some_blocks(folder: Path, blocks: int, least: int, most: int) -> Domain:
    """The blocks world in which each start has others of so many blocks, from `least` to `most` of them."""
    shipped = locate("blocks_world", "domains", ".pl").read_text()
    name = "some_blocks"
    text = shipped.replace("module(blocks_world,", f"module({name},", 1).replace(
        "    parameter(blocks, N),\n    N >= 2,\n",
        f"    random_between({least}, {most}, N),\n    parameter(blocks, All), numlist(1, All, Names),\n"
        "    random_permutation(Names, Shuffled), length(Few, N), append(Few, _, Shuffled), !,\n",
    )
    text = text.replace("member(I, Numbers), atom_concat", "member(I, Few), atom_concat")
    assert text.count("Few") == 3
    path = folder / f"{name}.pl"
    path.write_text(text)
    return Domain(path, {"blocks": blocks})


def relations(state: State) -> Relations:
    """The predicates of the blocks world or of delivery in a state, as sets of tuples."""
    result: Relations = {}
    for name, *args in state:
        result.setdefault(name, set()).add(tuple(args))
    if "goal_on" not in result:
        result["empty_handed"] = set() if result.get("holding") else {()}
        return result
    below = dict(result["on"])
    towers = {block: [below[block]] for block in below}
    for tower in towers.values():
        while tower[-1] != "floor":
            tower.append(below[tower[-1]])
    height = {"floor": 0, **{block: len(tower) for block, tower in towers.items()}}
    result["clear"] = {(block,) for block in below if block not in below.values()}
    result["above"] = {(block, lower) for block, tower in towers.items() for lower in tower}
    result["compheight"] = {
        (x, y, "same" if height[x] == height[y] else "higher" if height[x] > height[y] else "lower")
        for x in height
        for y in height
    }
    return result


def root_values(bias: LanguageBias, action: Action, known: Relations) -> tuple[int, Values]:
    """The kind of the action, and the values of the root variables; None for the arguments of other kinds."""
    name, *args = action if isinstance(action, tuple) else (action,)
    kind = [each.name for each in bias.actions].index(name)
    (goal,) = known[bias.goal.name] if bias.goal else [()]
    values = dict.fromkeys(map(Var, range(len(bias.roots))))
    values |= {Var(bias.offsets[kind] + i): each for i, each in enumerate(args)}
    return kind, values | {Var(bias.offsets[-1] + i): each for i, each in enumerate(goal)}


def holds(query: Query, kind: int, values: Values, known: Relations) -> bool:
    """Whether a query has an answer, by trying the literals from left to right on all tuples of their relations."""
    if not query:
        return True
    (name, args), rest = query[0], query[1:]
    if name == KIND:
        return args[0] == kind and holds(rest, kind, values, known)
    if name == "=":
        left, right = (values.get(arg, arg) if isinstance(arg, Var) else arg for arg in args)
        if isinstance(left, Var) or isinstance(right, Var):
            var, value = (left, right) if isinstance(left, Var) else (right, left)
            return holds(rest, kind, values | {var: value}, known)
        return left is not None and left == right and type(left) is type(right) and holds(rest, kind, values, known)
    if name in OPEN:
        value, limit = (values.get(arg, arg) if isinstance(arg, Var) else arg for arg in args)
        within = value is not None and (value <= limit if name == "=<" else value >= limit)
        return within and holds(rest, kind, values, known)
    for row in known.get(name, ()):
        bound = dict(values)
        if all(_matches(arg, value, bound) for arg, value in zip(args, row, strict=True)) and holds(
            rest, kind, bound, known
        ):
            return True
    return False


def _matches(arg: Var | Ground, value: Ground, bound: Values) -> bool:
    return bound.setdefault(arg, value) == value if isinstance(arg, Var) else arg == value


def truth(queries: Iterable[Query], bias: LanguageBias, state: State, actions: Sequence[Action]) -> np.ndarray:
    """Booleans of shape (actions, queries)."""
    known = relations(state)
    queries = list(queries)
    rows = [[holds(query, *root_values(bias, action, known), known) for query in queries] for action in actions]
    return np.array(rows, bool).reshape(len(actions), len(queries))


def value_of_list(ordered: Sequence[Rule], bias: LanguageBias, state: State, action: Action) -> float:
    """The value of the first rule whose query holds."""
    known = relations(state)
    kind, values = root_values(bias, action, known)
    return next(rule.value for rule in ordered if holds(rule.query, kind, values, known))


def value_of_tree(tree: Tree, bias: LanguageBias, state: State, action: Action) -> float:
    """The value of the leaf that the nodes' tests lead to, each asked by itself."""
    known = relations(state)
    kind, values = root_values(bias, action, known)
    while isinstance(tree, Node):
        tree = tree.yes if all(holds(test, kind, values, known) for test in tree.tests) else tree.no
    return tree.value


def term(fact: Ground) -> str:
    """A flat fact as Prolog reads it."""
    assert isinstance(fact, tuple)
    return f"{fact[0]}({', '.join(map(str, fact[1:]))})"


def in_plain_prolog(model: Path, states: Sequence[State]) -> list[tuple[str, float]]:
    """The greedy action and its potential in each state, as Prolog without nppg finds them in a model file."""
    goals = ", ".join(
        f"( state([{', '.join(map(term, state))}]), best_action(A{i}), potential(A{i}, P{i}), "
        f"format('~q ~15e~n', [A{i}, P{i}]) )"
        for i, state in enumerate(states)
    )
    swipl = prolog_home.linked().home
    assert swipl is not None
    binaries = [*swipl.glob("bin/*/swipl"), *swipl.parent.parent.glob("bin/swipl"), Path("/usr/bin/swipl")]
    result = subprocess.run(
        [next(each for each in binaries if each.exists()), "-g", goals, "-t", "halt", model.name],
        cwd=model.parent,
        env={**os.environ, "SWI_HOME_DIR": str(swipl)},
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert not result.stderr, result.stderr
    lines = [line.rsplit(" ", 1) for line in result.stdout.splitlines()]
    return [(action, float(potential)) for action, potential in lines]
