"""The options of all learners as those of `nppg train`, in groups."""

from __future__ import annotations

import argparse
from collections.abc import Mapping
from dataclasses import Field, fields
from typing import Any

from nppg.errors import NppgError
from nppg.experiments.learners import LEARNERS, LIMITS, owners_of
from nppg.learning.options import Options, kind_of

FIRST = ("episodes", "seed")  # what most people need
GROUPS = {
    "policy gradients, as in the paper": (
        "guidance", "expert", "horizon_factor", "discount", "step_size", "min_examples", "episodes_per_iteration",
        "update", "unrewarded", "curriculum",
    ),
    "second-order steps, and other ways to make trees learn faster": (
        "step", "regularisation", "clip", "importance", "examples_growth", "regularisation_growth", "replay",
        "normalise", "line_search", "ratio_clip",
    ),
    "imitation of the run's own best episodes": ("imitation", "floor", "detours"),
    "critic": ("critic", "trace", "cut_off", "critic_step_size", "critic_trees"),
    "trees": (
        "regressor", "models", "max_depth", "min_leaf", "min_variance", "significance", "granularity",
    ),
}  # fmt: skip
OTHERS = f"other learners ({', '.join(name for name in LEARNERS if name != Options.learner)})"  # the options left
_LIMITS = {
    "max_depth": "tests on the longest path of a tree",
    "min_examples": "each leaf holds at least so many examples",
    "min_variance": "a node with less is a leaf; 1e-9 goes along with the returns' size, others do not",
    "significance": "level of the F-test that a split must pass; 1 switches it off",
    "granularity": "at most so many thresholds of a bound are tried at a node; 0: every cut point",
}


def add_training_options(parser: argparse.ArgumentParser, first: argparse._ArgumentGroup) -> None:
    """Those that most people need go into the group `first`."""
    first.add_argument(
        "--learner", choices=LEARNERS, help="what learns (default: the language bias's, or nppg, policy gradients)"
    )
    known = training_options()
    for name in FIRST:
        _add_option(first, name, known.pop(name))
    for title, names in GROUPS.items():
        group = parser.add_argument_group(title)
        for name in names:
            _add_option(group, name, known.pop(name))
    group = parser.add_argument_group(OTHERS)
    for name, owners in known.items():
        _add_option(group, name, owners)


def training_options() -> dict[str, dict[str, Field]]:
    """The options of `train` by name, each with its learners."""
    found: dict[str, dict[str, Field]] = {}
    for options in LEARNERS.values():
        found |= {field.name: owners_of(field.name) for field in fields(options)}
    for name, field in LIMITS.items():
        found.setdefault(name, {})[Options.learner] = field
    return found


def _add_option(parser: argparse._ArgumentGroup, name: str, owners: Mapping[str, Field]) -> None:
    defaults = {
        learner: str(each.default) if each.metadata else "the language bias's" for learner, each in owners.items()
    }
    if len(set(defaults.values())) == 1:
        shown = next(iter(defaults.values()))
    else:
        shown = ", ".join(f"{learner} {default}" for learner, default in defaults.items())
    only = "" if len(owners) == len(LEARNERS) else f"{', '.join(owners)}: "
    first = next(iter(owners.values()))
    choices = first.metadata.get("choices")
    parser.add_argument(
        f"--{name.replace('_', '-')}",
        dest=name,
        type=kind_of(first),
        choices=choices,
        metavar=None if choices else kind_of(first).__name__.upper(),
        help=f"{only}{first.metadata.get('help') or _LIMITS[first.name]}"
        + ("" if first.default is None else f" (default: {shown})"),
    )


def chosen_options(options: argparse.Namespace, learner: str) -> dict[str, Any]:
    """Those that were given. Raises NppgError for those that the learner does not have."""
    given: dict[str, Any] = {}
    for name, owners in training_options().items():
        value = getattr(options, name)
        if value is not None and learner not in owners:
            raise NppgError(
                f"--{name.replace('_', '-')} is no option of the learner {learner}, but of {', '.join(owners)}"
            )
        given |= {} if value is None else {name: value}
    return given
