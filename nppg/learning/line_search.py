"""How far to go along a tree: a fixed step, or the best of several by what the iteration's own steps tell."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from nppg.learning.options import Options
from nppg.learning.visits import Visit, revisited
from nppg.policy.forest import Forest
from nppg.policy.gibbs import gibbs_of_groups
from nppg.policy.policy import Policy
from nppg.trees.tree import Tree, tests

_TIE = 1e-12  # estimates this near to the best one, relatively to what they sum up, count as equal


def step_size(tree: Tree, visits: Sequence[Visit], policy: Policy, options: Options) -> float:
    """The eta by which the tree is to be multiplied when it is added to the policy.

    With `line_search` k that is the one among 0 and step_size * 2^-k, ..., step_size * 2^k whose `estimate` on the
    policy's own visits is the highest; among equals the fixed step size, then the smallest."""
    own = [visit for visit in visits if not visit.guided]
    if options.line_search == 0 or not own:
        return options.step_size
    policy.table.add(tests(tree))
    forest = Forest()
    forest.add(tree, policy.table.place)
    steps = [revisited(visit, policy).step for visit in own]
    climb = forest.sums(np.concatenate([step.answers for step in steps]))
    potentials = np.concatenate([step.potentials for step in steps])
    starts = np.cumsum([0, *(len(step.actions) for step in steps[:-1])])
    chosen = starts + [step.chosen for step in steps]
    values = np.array([visit.value for visit in own])
    old = gibbs_of_groups(potentials, starts)[chosen]
    powers = range(-options.line_search, options.line_search + 1)
    tried = [options.step_size, 0.0, *(options.step_size * 2.0**power for power in powers)]
    ratios = [gibbs_of_groups(potentials + eta * climb, starts)[chosen] / old for eta in tried]
    estimates = np.array([estimate(each, values, options.ratio_clip) for each in ratios])
    best = estimates.max()
    return tried[int(np.argmax(estimates >= best - _TIE * float(np.abs(values).mean())))]


def estimate(ratios: np.ndarray, values: np.ndarray, clip: float) -> float:
    """The mean over steps t of min(w_t Q_t, clip(w_t, 1 - clip, 1 + clip) Q_t), with the importance weights
    w_t = pi_eta(s_t, a_t) / pi_old(s_t, a_t): PPO's clipped surrogate (Schulman et al. 2017). Unclipped it is the
    importance-weighted estimate of the return, highest for a policy that repeats the lucky actions for certain."""
    clipped = np.clip(ratios, 1 - clip, 1 + clip)
    return float(np.minimum(ratios * values, clipped * values).mean())
