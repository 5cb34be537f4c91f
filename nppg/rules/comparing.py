"""Where policies differ: states that one of them meets, and in which they do not want the same."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from html import escape

import numpy as np

from nppg.bridge.terms import texts
from nppg.errors import NppgError
from nppg.learning.episode import generate_episode
from nppg.policy.gibbs import best
from nppg.policy.policy import Policy
from nppg.worlds.state import interpretation_of
from nppg.worlds.world import State

EPISODES = 50


@dataclass(frozen=True, slots=True)
class Difference:
    """A state in which the best actions of one policy are all others than those of another one: as facts and drawn, the
    best actions of each, and how far the distributions are apart: the greatest total variation of two, from 0 to 1."""

    state: State
    picture: tuple[str, ...]
    choices: tuple[tuple[str, ...], ...]
    distance: float


@dataclass(frozen=True, slots=True)
class Comparison:
    """What was found in so many `states`: in how many all policies have a best action in common, how far apart the
    distributions are on average, and the differences, the greatest first."""

    states: int
    agreeing: int
    distance: float
    differences: tuple[Difference, ...]

    def __str__(self) -> str:
        same = f"the same best action in {self.agreeing:,}"
        lines = [f"{self.states:,} states: {same}, distance {self.distance:.4f} on average"]
        for each in self.differences[:3]:
            lines += ["", *each.picture, *(f"  policy {i}: {_listed(own)}" for i, own in enumerate(each.choices, 1))]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        """For notebooks."""
        rows = "".join(
            f'<tr><td><pre style="margin:0">{escape(chr(10).join(each.picture))}</pre></td>'
            + "".join(f'<td style="text-align:left"><code>{escape(_listed(own))}</code></td>' for own in each.choices)
            + f"<td>{each.distance:.4f}</td></tr>"
            for each in self.differences[:10]
        )
        count = len(self.differences[0].choices) if self.differences else 0
        named = "".join(f"<th>policy {i}</th>" for i in range(1, count + 1))
        told = f"<p>{self.states:,} states: the same best action in {self.agreeing:,}, {self.distance:.4f} apart</p>"
        return f"{told}<table><tr><th>state</th>{named}<th>distance</th></tr>{rows}</table>" if rows else told


def compare(policies: Sequence[Policy], episodes: int = EPISODES, seed: int = 0) -> Comparison:
    """Compares policies in the states of so many episodes of each. Raises NppgError for policies in different domains,
    and where there are not two."""
    if len(policies) < 2:
        raise NppgError("two policies are compared, or more")
    if len({(policy.domain.hash, tuple(policy.domain.parameters.items())) for policy in policies}) > 1:
        raise NppgError("the policies are in different domains, or in one with different parameters")
    if any(policy.domain.has_observation for policy in policies):
        raise NppgError("the policies see a state as it may look: they are compared where states are seen as they are")
    met: dict[int, State] = {}
    for number, policy in enumerate(policies):
        rng = np.random.default_rng([seed, number])
        for _ in range(episodes):
            for step in generate_episode(policy, rng).steps:
                met.setdefault(interpretation_of(step.actual).fingerprint, step.actual)
    agreeing, distances, differences = 0, [], []
    for state in met.values():
        actions = list(policies[0].domain.situation(state).actions)
        potentials = [policy.potentials(state, actions) for policy in policies]
        chances = [policy.probabilities_of(own) for policy, own in zip(policies, potentials, strict=True)]
        distances.append(max(float(np.abs(a - b).sum()) / 2 for i, a in enumerate(chances) for b in chances[:i]))
        wanted = [best(own) for own in potentials]
        if np.logical_and.reduce(wanted).any():
            agreeing += 1
        else:
            written = texts(actions)
            choices = tuple(tuple(written[i] for i in np.flatnonzero(own)) for own in wanted)
            picture = tuple(policies[0].domain.picture(state))
            differences.append(Difference(state, picture, choices, distances[-1]))
    differences.sort(key=lambda each: -each.distance)
    return Comparison(len(met), agreeing, float(np.mean(distances)) if distances else 0.0, tuple(differences))


def _listed(actions: Sequence[str]) -> str:
    return ", ".join(actions[:4]) + (f" and {len(actions) - 4} more" if len(actions) > 4 else "")
