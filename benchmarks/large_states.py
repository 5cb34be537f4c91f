"""Milliseconds per step in large states: by a list of rules, by trees, and with the whole state carried to and fro.

The last is the same domain with all static facts among the fluents, states as tuples and actions as lists, so that each
step hands over everything. The worlds: examples/library with up to 1000 books, and `watch`, in which telescopes may be
turned to any star, with up to 10,000 legal actions and 50,000 static facts. With NPPG_PDDL naming a folder like that of
the planning competition (NAME/domain.pddl, NAME/training, NAME/testing), also the largest problem of some of its
domains.
"""

from __future__ import annotations

import os
import tempfile
import time
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from benchmarks.common import Row
from nppg import Domain, LanguageBias, Policy, distill, language_bias_of, open_domain, options_of, train
from nppg.learning.episode import generate_episode
from nppg.worlds.state import facts_of, static_of

LIBRARY = Path(__file__).parent.parent / "examples" / "library"
STEPS = 100
EPISODES = 300
SMALLEST = 10  # problems of each world that its policy learns from
COMPETITION = ("ferry", "miconic", "satellite", "rovers")
WATCH = """(define (domain watch) (:requirements :strips :typing)
  (:types telescope star)
  (:predicates (sees ?t - telescope ?s - star) (near ?s ?r - star) (at ?t - telescope ?s - star) (seen ?s - star))
  (:action turn :parameters (?t - telescope ?from ?to - star)
    :precondition (and (at ?t ?from) (sees ?t ?to)) :effect (and (not (at ?t ?from)) (at ?t ?to)))
  (:action look :parameters (?t - telescope ?s - star)
    :precondition (at ?t ?s) :effect (seen ?s)))
"""


def rows() -> Iterator[Row]:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        yield from _library(folder)
        yield from _watch(folder)
        for data in filter(None, os.environ.get("NPPG_PDDL", "").split(os.pathsep)):
            for world in COMPETITION:
                if (Path(data) / world).is_dir():
                    yield from _competition(Path(data) / world)


def _library(folder: Path) -> Iterator[Row]:
    learned = _Learned(LIBRARY / "domain.pddl", sorted(LIBRARY.glob("p*.pddl"))[:SMALLEST])
    for books in (10, 100, 1000):
        yield learned.row(_library_problem(folder, books, max(3, books // 6)), f"library, {books} books", 0.7)


def _watch(folder: Path) -> Iterator[Row]:
    domain = folder / "watch.pddl"
    domain.write_text(WATCH)
    learned = _Learned(domain, [_watch_problem(folder, 2, stars, stars, 0) for stars in (2, 3, 4, 5, 6)])
    for telescopes, stars, near in ((2, 20, 10), (5, 200, 50), (10, 1000, 38)):
        problem = _watch_problem(folder, telescopes, stars, min(stars, 100), near)
        yield learned.row(problem, f"watch, {telescopes} telescopes, {stars} stars", 3)


def _competition(folder: Path) -> Iterator[Row]:
    training = sorted(folder.glob("training/**/*.pddl"), key=lambda file: file.stat().st_size)
    largest = max(folder.glob("testing/**/*.pddl"), key=lambda file: file.stat().st_size)
    learned = _Learned(folder / "domain.pddl", training[:SMALLEST])
    yield learned.row(largest, f"{folder.name}, its largest problem", 3)


class _Learned:
    """A policy that has learned on small problems of a world, and its rules."""

    def __init__(self, domain: Path, problems: Sequence[Path]):
        self.domain = open_domain(domain, problems=problems)
        self.bias = language_bias_of(self.domain)
        options = replace(options_of(self.bias), episodes=EPISODES)
        *_, last = train(self.domain, self.bias, options)
        self.policy = Policy(self.domain, self.bias)  # which asks no more tests than its trees have
        for tree in last.policy.trees:
            self.policy.add(tree)
        self.rules = distill(self.policy, self.bias)

    def row(self, problem: Path, what: str, target: float) -> Row:
        """A line about a large problem."""
        domain = self.domain.over(self.domain.problems_of([problem]))
        state = domain.problem(1)
        facts, static = len(facts_of(state)), len(static_of(state).facts)
        actions = len(domain.situation(state).actions)
        rules, trees = _milliseconds(self.rules, domain), _milliseconds(self.policy, domain)
        whole = _whole(self.policy, domain, self.bias)
        return Row(
            f"a step in {what}: {facts:,} facts, {static:,} static, {actions:,} actions",
            f"{rules:.2f} ms by {len(self.rules.rules(1))} rules, {trees:.2f} ms by {len(self.policy.trees)} trees",
            f"{whole / rules:.0f} and {whole / trees:.1f} times less than with the whole state ({whole:.2f} ms)",
            f"<= {target:g} ms by rules",
            rules <= target,
        )


def _milliseconds(policy: Policy, domain: Domain) -> float:
    """Per step of a greedy episode, cut off after some steps; the first ones, which compile tests, do not count."""
    policy.domain = domain
    state = domain.problem(1)
    for count in (5, STEPS):
        rng = np.random.default_rng(0)
        domain.visit(state)
        clock = time.process_time()
        episode = generate_episode(
            policy, rng, greedy=True, start=state, horizon_factor=count / max(domain.horizon(state), 1), scored=False
        )
        seconds = time.process_time() - clock
    return 1000 * seconds / len(episode.steps)


def _whole(policy: Policy, domain: Domain, bias: LanguageBias) -> float:
    """The same with all facts in the state, and everything handed over in each step."""
    text = domain.source.decode().replace(":- static", ":- fluent").replace(":- pddl(", "% (")
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "whole.pl")
        file.write_text(text + "start([]).\n")
        other = Domain(file)
    copy = Policy(other, bias)
    for tree in policy.trees:
        copy.add(tree)
    start = domain.problem(1)
    state = other.state(str(start)).facts
    rng = np.random.default_rng(0)
    steps = 10
    for count in (1, steps):
        clock = time.process_time()
        for _ in range(count):
            status, actions = other.situation(tuple(state))
            if status != "running":
                break
            action = actions[int(np.argmax(copy.potentials(tuple(state), list(actions))))]
            state = other.act(tuple(state), action, rng)[1].facts
        seconds = time.process_time() - clock
    return 1000 * seconds / steps


def _library_problem(folder: Path, books: int, shelves: int) -> Path:
    rng = np.random.default_rng(books)
    all_books, all_shelves = [f"b{i}" for i in range(books)], [f"s{i}" for i in range(shelves)]
    places = [rng.choice(shelves, 2, replace=False) for _ in all_books]
    at = " ".join(f"(at {book} s{here})" for book, (here, _) in zip(all_books, places, strict=True))
    goal = " ".join(f"(at {book} s{there})" for book, (_, there) in zip(all_books, places, strict=True))
    objects = f"{' '.join(all_books)} - book {' '.join(all_shelves)} - shelf"
    return _written(folder / f"library{books}.pddl", "library", objects, f"(cart-at s0) (cart-empty) {at}", goal)


def _watch_problem(folder: Path, telescopes: int, stars: int, wanted: int, near: int) -> Path:
    all_telescopes, all_stars = [f"t{i}" for i in range(telescopes)], [f"s{i}" for i in range(stars)]
    sees = " ".join(f"(sees {t} {s})" for t in all_telescopes for s in all_stars)
    pairs = " ".join(f"(near s{i} s{(i + j) % stars})" for i in range(stars) for j in range(1, near + 1))
    at = " ".join(f"(at {t} s0)" for t in all_telescopes)
    objects = f"{' '.join(all_telescopes)} - telescope {' '.join(all_stars)} - star"
    goal = " ".join(f"(seen {s})" for s in all_stars[:wanted])
    return _written(folder / f"watch{telescopes}-{stars}.pddl", "watch", objects, f"{sees} {pairs} {at}", goal)


def _written(file: Path, domain: str, objects: str, init: str, goal: str) -> Path:
    file.write_text(
        f"(define (problem {file.stem}) (:domain {domain}) (:objects {objects})\n"
        f"  (:init {init})\n  (:goal (and {goal})))\n"
    )
    return file
