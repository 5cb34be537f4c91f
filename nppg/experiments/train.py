"""Every learner behind one door: which one learns is a matter of the options."""

from __future__ import annotations

from collections.abc import Iterator

from nppg.bias.language_bias import LanguageBias
from nppg.experiments.learners import options_of
from nppg.learning import training
from nppg.learning.options import Common, Options
from nppg.learning.training import Iteration
from nppg.rrl import training as q_learning
from nppg.rrl.options import QOptions
from nppg.worlds.domain import Domain


def train(domain: Domain, bias: LanguageBias, options: Common | None = None) -> Iterator[Iteration]:
    """Learns by policy gradients for Options, by relational Q-learning for TGOptions, RIBOptions or TrendiOptions; left
    out, they are `options_of` the bias.
    Yields as it learns, the first time before it has learned anything. Raises NppgError."""
    options = options_of(bias) if options is None else options
    if isinstance(options, QOptions):
        return q_learning.train(domain, bias, options)
    assert isinstance(options, Options)
    return training.train(domain, bias, options)
