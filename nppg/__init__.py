"""Relational reinforcement learning by non-parametric policy gradients.

The names below are the public interface; they are loaded, and Prolog with them, when they are first used.
"""

TYPE_CHECKING = False  # typing takes time, in which Ctrl-C is not heeded yet: see nppg/__main__.py
if TYPE_CHECKING:
    from nppg import tilde as tilde
    from nppg.bias.language_bias import LanguageBias as LanguageBias
    from nppg.errors import NppgError as NppgError
    from nppg.experiments.learners import options_of as options_of
    from nppg.experiments.runs import run as run
    from nppg.experiments.train import train as train
    from nppg.judging import optimum as optimum
    from nppg.judging.evaluation import Evaluation as Evaluation
    from nppg.judging.evaluation import evaluate as evaluate
    from nppg.judging.evaluation import evaluate_exactly as evaluate_exactly
    from nppg.learning.episode import Episode as Episode
    from nppg.learning.episode import generate_episode as generate_episode
    from nppg.learning.options import Options as Options
    from nppg.policy.policy import Policy as Policy
    from nppg.rrl.options import RIBOptions as RIBOptions
    from nppg.rrl.options import TGOptions as TGOptions
    from nppg.rrl.options import TrendiOptions as TrendiOptions
    from nppg.rules.distill import distill as distill
    from nppg.rules.proof import prove as prove
    from nppg.worlds.domain import Domain as Domain
    from nppg.worlds.opening import language_bias_of as language_bias_of
    from nppg.worlds.opening import open_domain as open_domain

    __version__: str

_HOME = {
    "Domain": "nppg.worlds.domain",
    "Episode": "nppg.learning.episode",
    "Evaluation": "nppg.judging.evaluation",
    "LanguageBias": "nppg.bias.language_bias",
    "NppgError": "nppg.errors",
    "Options": "nppg.learning.options",
    "Policy": "nppg.policy.policy",
    "RIBOptions": "nppg.rrl.options",
    "TGOptions": "nppg.rrl.options",
    "TrendiOptions": "nppg.rrl.options",
    "distill": "nppg.rules.distill",
    "evaluate": "nppg.judging.evaluation",
    "evaluate_exactly": "nppg.judging.evaluation",
    "generate_episode": "nppg.learning.episode",
    "language_bias_of": "nppg.worlds.opening",
    "open_domain": "nppg.worlds.opening",
    "optimum": "nppg.judging",
    "options_of": "nppg.experiments.learners",
    "prove": "nppg.rules.proof",
    "run": "nppg.experiments.runs",
    "tilde": "nppg",
    "train": "nppg.experiments.train",
}
__all__ = sorted(_HOME)


def __getattr__(name: str) -> object:
    from importlib import import_module

    if name == "__version__":
        return import_module("importlib.metadata").version("nppg")  # which takes long to load
    if name not in _HOME:
        raise AttributeError(f"module 'nppg' has no attribute '{name}'")
    home = _HOME[name]
    found = vars(import_module(home)).get(name)
    return import_module(f"{home}.{name}") if found is None else found


def __dir__() -> list[str]:
    return [*_HOME, "__version__"]
