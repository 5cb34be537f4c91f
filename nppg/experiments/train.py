"""Every learner behind one door: which one learns is a matter of the options."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from nppg.bias.language_bias import LanguageBias
from nppg.experiments.experts import expert_of
from nppg.experiments.learners import options_of
from nppg.learning import training
from nppg.learning.options import Common, Options
from nppg.learning.training import Iteration
from nppg.rrl import training as q_learning
from nppg.rrl.options import RIBOptions, TGOptions, TrendiOptions
from nppg.worlds.domain import Domain

# What learns, by the name of the learner; experiments/learners.py has the options.
_GENERATORS: dict[str, Callable[..., Iterator[Iteration]]] = {
    Options.learner: training.train,
    **{each.learner: q_learning.train for each in (TGOptions, RIBOptions, TrendiOptions)},
}


def train(
    domain: Domain,
    bias: LanguageBias,
    options: Common | None = None,
    jobs: int = 1,
    is_over: Callable[[], bool] = lambda: False,
) -> Iterator[Iteration]:
    """Learns as the class of the options says: by policy gradients for Options, by relational Q-learning for TGOptions,
    RIBOptions or TrendiOptions. Left out, they are `options_of` the bias. By policy gradients up to `jobs` processes
    play the episodes of an iteration, if it has many, and the episode is the last after which it `is_over`.
    Yields as it learns, the first time before it has learned anything; by relational Q-learning after each episode.
    Raises NppgError."""
    options = options_of(bias) if options is None else options
    expert = expert_of(domain, options)
    if isinstance(options, Options):
        return training.train(domain, bias, options, jobs, is_over, expert)
    return _GENERATORS[options.learner](domain, bias, options, expert)
