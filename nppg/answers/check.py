"""Every mistake in a domain and its language bias that can be found without training."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from nppg.answers.coverage import root_table
from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import Refiner
from nppg.errors import NppgError, Problem
from nppg.worlds.domain import Domain

_STARTS = 10
_STEPS = 5  # at random; the domain's expert may take more, where it has one
_EXPERT_STEPS = 30


def check(
    load_domain: Callable[[], Domain],
    load_bias: Callable[[Domain | None], LanguageBias | None],
    check_bias: Callable[[LanguageBias], list[Problem]] = lambda bias: [],
) -> tuple[list[Problem], str]:
    """The problems of both files and of their fit, and a summary for where there are none. `load_bias` is given the
    domain, where that could be loaded; `check_bias` finds what else is wrong with the bias.

    Where the files are sound, all predicates are tried in some random episodes, and all tests of the bias.
    """
    domain, problems = _loaded(load_domain)
    bias, more = _loaded(lambda: load_bias(domain))
    problems = list(dict.fromkeys([*problems, *more]))  # both may find that there is no such file
    more = check_bias(bias) if bias else []
    if domain and bias and not problems:
        more = sorted([*more, *bias.check(domain.predicates, domain.actions)])
        problems = more or list(_tried(domain, bias))
    else:
        problems += more
    return problems, _summary(domain, bias) if domain and bias else ""


def _loaded(load: Callable) -> tuple:
    try:
        return load(), []
    except NppgError as error:
        return None, list(error.problems)


def _tried(domain: Domain, bias: LanguageBias) -> Iterator[Problem]:
    rng = np.random.default_rng(0)
    try:
        table = root_table(domain, bias, Refiner(bias))
        for start in range(_STARTS):
            state = domain.start(rng)
            domain.horizon(state)
            for step in range(_EXPERT_STEPS):
                situation = domain.situation(state)
                if situation.status != "running":
                    break
                advised = domain.expert_actions(state)
                domain.picture(state)
                domain.parts(state)
                table.answers(domain.observe(state, rng), situation.actions)
                if step >= _STEPS and (start % 2 or not advised):
                    break
                among = situation.actions if start % 2 or not advised else advised
                chosen = among[int(rng.random() * len(among))]
                tried = [chosen] if domain.environment else situation.actions  # an environment goes one way only
                state = {action: domain.act(state, action, rng)[1] for action in tried}[chosen]
    except NppgError as error:
        yield from error.problems


def _summary(domain: Domain, bias: LanguageBias) -> str:
    fluents = ", ".join(f"{name}/{arity}" for name, arity in sorted(domain.fluents))
    table = root_table(domain, bias, Refiner(bias))
    return f"{domain.path} and {bias.file}: no mistakes; fluents {fluents}; {len(table)} tests at a root"
