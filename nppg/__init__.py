"""Relational reinforcement learning by non-parametric policy gradients.

The names below are the public interface; they are loaded, and Prolog with them, when they are first used.
"""

from importlib import import_module
from importlib.metadata import version
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from nppg.domain import Domain
    from nppg.episode import Episode, generate_episode
    from nppg.errors import NppgError
    from nppg.evaluation import Evaluation, evaluate, evaluate_exactly
    from nppg.language_bias import LanguageBias
    from nppg.learners import train
    from nppg.opening import language_bias_of, open_domain
    from nppg.options import Options
    from nppg.policy import Policy
    from nppg.runs import run

    __version__: str

_HOME = {
    "Domain": "domain",
    "Episode": "episode",
    "Evaluation": "evaluation",
    "LanguageBias": "language_bias",
    "NppgError": "errors",
    "Options": "options",
    "Policy": "policy",
    "evaluate": "evaluation",
    "evaluate_exactly": "evaluation",
    "generate_episode": "episode",
    "language_bias_of": "opening",
    "open_domain": "opening",
    "run": "runs",
    "train": "learners",
}
__all__ = [
    "Domain",
    "Episode",
    "Evaluation",
    "LanguageBias",
    "NppgError",
    "Options",
    "Policy",
    "evaluate",
    "evaluate_exactly",
    "generate_episode",
    "language_bias_of",
    "open_domain",
    "run",
    "train",
]


def __getattr__(name: str) -> object:
    if name == "__version__":
        return version("nppg")
    if name not in _HOME:
        raise AttributeError(f"module 'nppg' has no attribute '{name}'")
    return getattr(import_module(f"nppg.{_HOME[name]}"), name)
