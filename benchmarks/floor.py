"""The floor: policy gradients on on(A,B) without any logic, the least time that such a learner can take.

States are taken up to renaming the blocks other than A and B, and the truth of some 40 tests over the X and Y of
the move and the A and B of the goal is tabled for every state and action beforehand. What is left is Algorithm 1
itself, in NumPy. It can express nothing else: it is there to hold the real system's time against.

    python -m benchmarks.floor [--episodes 2000] [--seed 0] [--blocks 10]
"""

from __future__ import annotations

import argparse
from collections import Counter
from dataclasses import dataclass
from math import factorial, prod

import numpy as np

from benchmarks.common import timed

Towers = tuple[str, ...]  # from the bottom up, sorted: A, B, and o for every other block
FLOOR = (-1, -1)  # a place is (tower, level)


@dataclass(frozen=True, slots=True)
class Tables:
    """All states of the world, and their legal actions: those of state s stand from first[s] to first[s + 1].

    `weights` has the number of labelled states that each state stands for, `moves_left` the least number of moves
    to a goal state; `tests` has shape (actions, tests).
    """

    weights: np.ndarray
    moves_left: np.ndarray
    first: np.ndarray
    state: np.ndarray
    following: np.ndarray
    tests: np.ndarray

    @property
    def optimal(self) -> np.ndarray:
        """Whether each action is one of the best in its state."""
        return self.moves_left[self.following] == self.moves_left[self.state] - 1

    @property
    def starts(self) -> np.ndarray:
        return np.flatnonzero(self.moves_left > 0)

    def start_distribution(self) -> np.ndarray:
        return self.weights[self.starts] / self.weights[self.starts].sum()


def tables(blocks: int = 10) -> Tables:
    """Explores the world from all blocks on the floor."""
    world: dict[Towers, list[tuple[int, int, Towers]]] = {}
    unseen = [tuple(sorted("AB" + "o" * (blocks - 2)))]
    while unseen:
        state = unseen.pop()
        if state not in world:
            world[state] = list(_moves(state))
            unseen += [following for _, _, following in world[state]]
    states = sorted(world)
    number = {state: i for i, state in enumerate(states)}
    tests = np.array([_tests(state, x, y) for state in states for x, y, _ in world[state]])
    sizes = [len(world[state]) for state in states]
    following = np.array([number[each] for state in states for _, _, each in world[state]])
    came_from = np.repeat(np.arange(len(states)), sizes)
    goal = np.array([any("BA" in tower for tower in state) for state in states])
    return Tables(
        weights=np.array([_labelled(state, blocks) for state in states], float),
        moves_left=_moves_left(goal, came_from, following),
        first=np.cumsum([0, *sizes]),
        state=came_from,
        following=following,
        tests=tests[:, tests.any(axis=0) & ~tests.all(axis=0)],
    )


def _moves(state: Towers) -> list[tuple[int, int, Towers]]:
    """(tower of X, tower of Y or -1 for the floor, following state) of each move of a clear block."""
    result = []
    for x, source in enumerate(state):
        for y, target in [*enumerate(state), (-1, "")]:
            if x != y and (y >= 0 or len(source) > 1):
                others = [tower for i, tower in enumerate(state) if i not in (x, y)]
                moved = [*others, source[:-1], target + source[-1]]
                result.append((x, y, tuple(sorted(tower for tower in moved if tower))))
    return result


def _labelled(state: Towers, blocks: int) -> int:
    """The number of states of distinguishable blocks with this shape, A and B fixed."""
    alike = Counter(tower for tower in state if set(tower) == {"o"})
    return factorial(blocks - 2) // prod(map(factorial, alike.values()))


def _moves_left(goal: np.ndarray, state: np.ndarray, following: np.ndarray) -> np.ndarray:
    """Breadth-first search backwards from the goal states."""
    moves = np.where(goal, 0, -1)
    while (moves < 0).any():
        reached = state[(moves[following] == moves.max()) & (moves[state] < 0)]
        moves[reached] = moves.max() + 1
    return moves


def _tests(state: Towers, x: int, y: int) -> list[bool]:
    """The truth of every test for moving the top of tower x onto that of tower y."""
    top = [(i, len(tower) - 1) for i, tower in enumerate(state)]
    find = {block: (i, tower.index(block)) for block in "AB" for i, tower in enumerate(state) if block in tower}
    place = {"X": top[x], "Y": FLOOR if y < 0 else top[y], **find}

    def above(v: str, w: str) -> bool:
        return FLOOR not in (place[v], place[w]) and place[v][0] == place[w][0] and place[v][1] > place[w][1]

    def on(v: str, w: str) -> bool:
        if place[w] == FLOOR:
            return place[v][1] == 0
        return above(v, w) and place[v][1] == place[w][1] + 1

    pairs = [(v, w) for v in "XYAB" for w in "XYAB" if v != w]
    equal = [place[v] == place[w] for v, w in ("XA", "XB", "YA", "YB")]
    heights = [(place[v][1], place[w][1]) for v, w in ("XY", "XA", "XB", "YA", "YB", "AB")]
    return [
        *equal,
        place["Y"] == FLOOR,
        *(above(v, w) for v, w in pairs),
        *(on(v, w) for v, w in pairs),
        *(truth for v in "AB" for truth in (place[v] in top, place[v][1] == 0)),
        place["X"][1] == 0,
        *(truth for v, w in heights for truth in (v > w, v == w)),
    ]


Tree = float | tuple[int, "Tree", "Tree"]


def train(
    world: Tables,
    episodes: int = 2000,
    seed: int = 0,
    guidance: float = 0.1,
    min_examples: int = 100,
    max_depth: int = 4,
    second_order: bool = False,
) -> tuple[np.ndarray, int]:
    """Algorithm 1 with the paper's settings, or with second-order steps: the potential of every action, and the number
    of trees."""
    rng = np.random.default_rng(seed)
    starts, distribution, optimal = world.starts, world.start_distribution(), world.optimal
    values = world.tests.astype(float)
    potential = np.zeros(len(world.state))
    everywhere = np.arange(len(potential))
    trees = 0
    rows: list[np.ndarray] = []
    gradients: list[np.ndarray] = []
    curvatures: list[np.ndarray] = []
    for _ in range(episodes):
        state = rng.choice(starts, p=distribution)
        guided = rng.random() < guidance
        steps = []
        for _ in range(world.moves_left[state]):
            a, b = world.first[state : state + 2]
            probabilities = np.exp(potential[a:b] - potential[a:b].max())
            probabilities /= probabilities.sum()
            chosen = rng.choice(np.flatnonzero(optimal[a:b])) if guided else rng.choice(b - a, p=probabilities)
            steps.append((a, b, probabilities, chosen))
            state = world.following[a + chosen]
            if world.moves_left[state] == 0:
                break
        won = float(world.moves_left[state] == 0)
        for a, b, probabilities, chosen in steps if won or not second_order else ():
            gradient = -won * probabilities[chosen] * probabilities
            gradient[chosen] += won * probabilities[chosen]
            rows.append(np.arange(a, b))
            gradients.append(gradient)
            if second_order:
                curvatures.append(probabilities * (1 - probabilities))
        if sum(map(len, rows)) > min_examples:
            weights = np.concatenate(curvatures) if second_order else None
            tree = _grow(world.tests, values, np.concatenate(rows), np.concatenate(gradients), weights, max_depth)
            _add(world.tests, tree, everywhere, potential)
            trees += 1
            rows, gradients, curvatures = [], [], []
    return potential, trees


def _grow(
    tests: np.ndarray,
    values: np.ndarray,
    rows: np.ndarray,
    targets: np.ndarray,
    curvatures: np.ndarray | None,
    depth: int,
) -> Tree:
    """A regression tree with at least two examples in a leaf, of means and split by weighted variance, or with
    curvatures of second-order steps (lambda 1, clipped to +-3) and split by their gain."""
    count, total = len(targets), targets.sum()
    if curvatures is None:
        whole, extra, leaf = count, 0.0, total / count
    else:
        whole, extra = curvatures.sum(), 1.0
        leaf = min(max(total / (whole + extra), -3.0), 3.0)
    if depth == 0 or count < 4 or targets.var() < 1e-6:
        return leaf
    held = values[rows]
    n1, s1 = held.sum(axis=0), targets @ held
    w1 = n1 if curvatures is None else curvatures @ held
    with np.errstate(all="ignore"):
        kept = s1**2 / (w1 + extra) + (total - s1) ** 2 / (whole - w1 + extra)
    kept[(n1 < 2) | (count - n1 < 2)] = -np.inf
    best = int(np.argmax(kept))
    if not kept[best] > total**2 / (whole + extra) + 1e-9:
        return leaf
    yes = tests[rows, best]
    branches = (
        _grow(tests, values, rows[mask], targets[mask], None if curvatures is None else curvatures[mask], depth - 1)
        for mask in (yes, ~yes)
    )
    return best, *branches


def _add(tests: np.ndarray, tree: Tree, rows: np.ndarray, potential: np.ndarray) -> None:
    """Adds the tree's predictions to the potential."""
    if isinstance(tree, tuple):
        test, yes, no = tree
        held = tests[rows, test]
        _add(tests, yes, rows[held], potential)
        _add(tests, no, rows[~held], potential)
    else:
        potential[rows] += tree


def success(world: Tables, potential: np.ndarray) -> float:
    """The share of all starts that the Gibbs policy solves in the least number of moves, by backward induction."""
    highest = np.maximum.reduceat(potential, world.first[:-1])[world.state]
    weights = np.exp(potential - highest)
    probabilities = weights / np.add.reduceat(weights, world.first[:-1])[world.state]
    solved = (world.moves_left == 0).astype(float)
    for distance in range(1, world.moves_left.max() + 1):
        now = (world.moves_left[world.state] == distance) & world.optimal
        np.add.at(solved, world.state[now], probabilities[now] * solved[world.following[now]])
    return float(world.start_distribution() @ solved[world.starts])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--episodes", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--blocks", type=int, default=10)
    parser.add_argument("--second-order", action="store_true")
    chosen = parser.parse_args()
    tabling, world = timed(lambda: tables(chosen.blocks))
    second = chosen.second_order
    training, (potential, trees) = timed(lambda: train(world, chosen.episodes, chosen.seed, second_order=second))
    share = success(world, potential)
    print(f"{training:.3f} s, after {tabling:.3f} s for the tables; {trees} trees, success {share:.6f}")


if __name__ == "__main__":
    main()
