"""nppg play."""

from __future__ import annotations

import argparse

import numpy as np

from nppg.cli import loading
from nppg.cli.arguments import add_model, add_parameters, add_problems
from nppg.learning.episode import generate_episode
from nppg.learning.options import at_least
from nppg.policy.policy import Policy
from nppg.worlds.world import State


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The model, and the seed."""
    add_model(parser)
    add_parameters(parser)
    add_problems(parser)
    parser.add_argument("--seed", type=int, default=0, help="of the episode (default: 0)")


def run(options: argparse.Namespace) -> int:
    """Draws each state with the actions. Raises NppgError."""
    at_least("seed", options.seed, 0)
    policy = loading.policy(options)
    episode = generate_episode(policy, np.random.default_rng(options.seed))
    for number, step in enumerate(episode.steps, 1):
        print(*policy.domain.picture(step.actual), "", *_seen(policy, step.state), f"step {number}", sep="\n")
        pairs = zip(step.actions, step.potentials if policy.greedy else step.probabilities, strict=True)
        for action, value in sorted(pairs, key=lambda pair: -pair[1]):
            mark = "->" if action is step.actions[step.chosen] else "  "
            print(f"  {mark} {value:6.4f}  {_text(action)}")
        print()
    print(*policy.domain.picture(episode.actual), "", sep="\n")
    if policy.domain.has_goal:
        end = "the goal is reached" if episode.success else "the goal is not reached"
    else:
        end = f"the return is {episode.undiscounted:g}"
    print(f"{end} after {len(episode.steps)} steps")
    return 0


def _seen(policy: Policy, observation: State) -> list[str]:
    """What the policy sees, where that is not the state."""
    if not policy.domain.has_observation:
        return []
    return ["seen: " + ", ".join(map(_text, observation)), ""]


def _text(term: object) -> str:
    return f"{term[0]}({', '.join(map(_text, term[1:]))})" if isinstance(term, tuple) else str(term)
