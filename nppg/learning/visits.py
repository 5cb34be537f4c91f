"""The steps that trees learn from, each with what its action was worth."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from nppg.learning.episode import Step
from nppg.learning.options import Options
from nppg.policy.policy import Policy


class Visit(NamedTuple):
    """A step and its value: its return, or its advantage. `guided`: an expert chose the action or a later one, so that
    the value is not the policy's."""

    step: Step
    value: float
    guided: bool = False


def kept(visits: Sequence[Visit], options: Options) -> list[Visit]:
    """Those that trees learn from. A value of 0 gives neither gradient nor curvature, so a second-order step learns
    nothing there, unless values are standardised."""
    keep = options.unrewarded == "keep" and (options.step == "gradient" or options.normalise == "yes")
    return [visit for visit in visits if visit.value != 0 or keep]


def normalised(visits: Sequence[Visit], options: Options) -> list[Visit]:
    """The same with values standardised, if the options say so: of mean 0 and, unless all are equal, deviation 1."""
    if options.normalise == "no":
        return list(visits)
    values = np.array([visit.value for visit in visits])
    values -= values.mean()
    values /= values.std() or 1.0
    return [visit._replace(value=value) for visit, value in zip(visits, values.tolist(), strict=True)]


def revisited(visit: Visit, policy: Policy) -> Visit:
    """The same step as the present policy would see it."""
    step = visit.step
    answers = step.answers
    if answers.shape[1] != len(policy.table):
        answers = policy.answers(step.state, step.actions)
    potentials = policy.potentials_of(answers)
    probabilities = policy.probabilities_of(potentials)
    return visit._replace(step=replace(step, answers=answers, potentials=potentials, probabilities=probabilities))
