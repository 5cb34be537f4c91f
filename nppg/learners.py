"""Every learner behind one door: which one learns is a matter of the options."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from nppg.options import Common, Options
from nppg.rrl.options import QOptions, RIBOptions, TGOptions, TrendiOptions

if TYPE_CHECKING:
    from nppg.domain import Domain
    from nppg.language_bias import LanguageBias
    from nppg.training import Iteration

LEARNERS: dict[str, type[Common]] = {each.learner: each for each in (Options, TGOptions, RIBOptions, TrendiOptions)}


def train(domain: Domain, bias: LanguageBias, options: Common | None = None) -> Iterator[Iteration]:
    """Learns by policy gradients for Options, by relational Q-learning for TGOptions, RIBOptions or TrendiOptions.
    Yields as it learns, the first time before it has learned anything. Raises NppgError."""
    from nppg import training  # here, because the command line names the learners before it needs Prolog
    from nppg.rrl import training as q_learning

    options = options or Options()
    if isinstance(options, QOptions):
        return q_learning.train(domain, bias, options)
    assert isinstance(options, Options)
    return training.train(domain, bias, options)
