"""Curriculum: problems from the smallest on, more of them as success rises."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from nppg.worlds.domain import Domain
from nppg.worlds.state import interpretation_of

FIRST = 4  # problems that it begins with
_PART = 3  # the newest are the largest one of so many parts
_GROWTH = 1.25  # of the problems that are open
_LATELY = 20  # episodes on the newest problems that it looks back on
_ENOUGH = 0.75  # share of them that succeeds, from which on there is more to learn in larger ones
_PATIENCE = 200  # episodes on the newest problems after which it goes on if any of them has succeeded


@dataclass
class Curriculum:
    """The open problems are the `opened` smallest ones of `order`. Half of the steps are for all of them, half for the
    newest, the largest third, and within these each problem has the same share: it is drawn by a chance that is inverse
    to its horizon.

    More are opened when three of four of the last 20 episodes on the newest succeed. So that a few problems beyond the
    policy hold up no others, 200 episodes are enough where some succeed, or where none ever has, for then there is
    nothing to wait for. An expert's episodes do not count.

    Its fields are all that there is to save."""

    order: tuple[int, ...]
    horizons: tuple[int, ...]
    opened: int = FIRST
    newest: list[bool] = field(default_factory=list)  # whether the episodes on the newest succeeded, since it widened
    any_success: bool = False

    def draw(self, rng: np.random.Generator, opened: int) -> int:
        """A problem, where so many are open."""
        chances = self._chances(opened).cumsum()
        return self.order[min(int(chances.searchsorted(rng.random() * chances[-1], "right")), opened - 1)]

    def note(self, problem: int, success: bool) -> None:
        """Learns how an episode of the policy's on a problem has ended."""
        self.any_success |= success
        if problem not in self.order[_first_of_newest(self.opened) : self.opened]:
            return
        self.newest.append(success)
        lately = self.newest[-_LATELY:]
        ready = len(lately) == _LATELY and sum(lately) >= _ENOUGH * _LATELY
        long = len(self.newest) >= _PATIENCE and (any(self.newest[-_PATIENCE:]) or not self.any_success)
        if (ready or long) and self.opened < len(self.order):
            self.opened = min(len(self.order), max(self.opened + 1, int(_GROWTH * self.opened)))
            self.newest = []
        del self.newest[:-_PATIENCE]

    def __str__(self) -> str:
        return f"{self.opened}/{len(self.order)}"

    def _chances(self, opened: int) -> np.ndarray:
        newest = _first_of_newest(opened)
        shares = np.full(opened, 1 / opened)
        shares[newest:] += 1 / (opened - newest)
        return shares / np.maximum(1, self.horizons[:opened])


def _first_of_newest(opened: int) -> int:
    return opened - -(-opened // _PART)


def curriculum_of(domain: Domain) -> Curriculum | None:
    """Of the problems that start states are drawn from, by horizon, and where that is the same by the number of facts;
    none where there are no more than it begins with, or success is not what is learned."""
    problems = domain.chosen
    if len(problems) <= FIRST or not domain.has_goal:
        return None
    sizes = []
    for number in problems:
        state = interpretation_of(domain.problem(number))
        sizes.append((domain.horizon(state), len(state.static.facts) + len(state.facts)))
    order = sorted(range(len(problems)), key=sizes.__getitem__)
    return Curriculum(tuple(problems[at] for at in order), tuple(sizes[at][0] for at in order))
