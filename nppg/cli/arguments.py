"""What several verbs take, and what it stands for."""

from __future__ import annotations

import argparse
import math
import sys
import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NoReturn

from nppg.bias.names import number
from nppg.errors import NppgError, suggestion


class Parser(argparse.ArgumentParser):
    """Tells a wrong argument on one line, like every other mistake: raises NppgError."""

    def error(self, message: str) -> NoReturn:
        raise NppgError(f"{self.prog}: {message}")

    def parse_args(self, args: Sequence[str] | None = None, namespace: Any = None) -> Any:  # type: ignore[override]
        found, unknown = self.parse_known_args(args, namespace)
        if unknown:
            word = unknown[0].split("=")[0]
            options = [each for each in self._option_string_actions if each.startswith("--")]
            what = "option" if word.startswith("-") else "further argument"
            self.error(f"there is no {what} {word}{suggestion(word, options)}")
        return found


def add_domain(parser: argparse.ArgumentParser | argparse._ArgumentGroup, needed: bool = True) -> None:
    """The domain, if it is `needed` always, its parameters and its language bias."""
    parser.add_argument(
        "domain",
        nargs=None if needed else "?",
        help="a shipped domain's name, a file, in PDDL too, or gym:ID for an environment of Gymnasium",
    )
    parser.add_argument("--bias", help="language bias (default: the file of the domain's name, or a generated one)")
    add_parameters(parser)
    add_problems(parser)
    add_trust(parser)


def add_trust(parser: argparse.ArgumentParser | argparse._ArgumentGroup) -> None:
    """Whether the domain file is code that may do anything, and whether in a process of its own."""
    parser.add_argument(
        "--trust",
        action="store_true",
        help="let the domain file do anything on this machine: for those of authors whom you trust (SECURITY.md)",
    )
    parser.add_argument(
        "--isolate",
        action="store_true",
        help="run in a process of its own, which is ended where the domain hangs or takes more than 4 GB of memory",
    )


def add_problems(parser: argparse.ArgumentParser | argparse._ArgumentGroup) -> None:
    """By --problems."""
    parser.add_argument(
        "--problems",
        nargs="+",
        default=[],
        metavar="FILE",
        help="start states: the files of problems, or the numbers of the domain's own (1-20, or 3,5,8-10)",
    )


def add_acting(parser: argparse.ArgumentParser) -> None:
    """How far an episode goes, and whether it comes back."""
    parser.add_argument(
        "--horizon-factor", type=float, metavar="FLOAT", help="of the domain's horizon (default: as in training)"
    )
    add_no_revisits(parser)


def add_no_revisits(parser: argparse.ArgumentParser | argparse._ArgumentGroup) -> None:
    """Whether an episode comes back."""
    parser.add_argument(
        "--no-revisits",
        action="store_true",
        help="enter no state of the episode twice while there is another action",
    )


def add_search(parser: argparse.ArgumentParser) -> None:
    """Whether plans are searched for, and how long."""
    parser.add_argument(
        "--search",
        choices=("levin",),
        help="search for a plan where the policy alone may miss one: Levin tree search by its probabilities, in worlds "
        "where an action has one outcome",
    )
    parser.add_argument("--budget", type=int, metavar="N", help="expansions of a search (default: 10000)")


def checked_search(options: argparse.Namespace) -> bool:
    """Whether plans are searched for. Raises NppgError for options that do not go together."""
    if options.search is None and options.budget is not None:
        raise NppgError("--budget is for a search: --search levin")
    for name in ("stochastic", "no_revisits", "horizon_factor") if options.search else ():
        if getattr(options, name) not in (False, None):
            raise NppgError(f"--{name.replace('_', '-')} is about acting, not for --search")
    return options.search is not None


def add_seconds(parser: argparse.ArgumentParser | argparse._ArgumentGroup, help: str) -> None:
    """A limit of time; `help` says of what."""
    parser.add_argument("--seconds", type=float, metavar="S", help=help)


def checked_seconds(options: argparse.Namespace) -> float | None:
    """The limit of time, if there is one. Raises NppgError for what is none."""
    seconds: float | None = options.seconds
    if seconds is not None and not 0 < seconds < math.inf:  # so is NaN
        raise NppgError(f"seconds must be a finite number greater than 0, not {seconds:g}")
    return seconds


def add_parameters(parser: argparse.ArgumentParser | argparse._ArgumentGroup) -> None:
    """Of the domain, by --set."""
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", help="a parameter of the domain")


def add_model(parser: argparse.ArgumentParser) -> None:
    """A model file."""
    parser.add_argument("model", type=Path, help="a model file")
    parser.add_argument(
        "--edited", action="store_true", help="take the file as it is, though it was changed since nppg wrote it"
    )
    add_trust(parser)


def add_explain(parser: argparse.ArgumentParser) -> None:
    """Sentences for rules."""
    parser.add_argument("--explain", action="store_true", help="say in plain English what each rule does")


def parameters(settings: Sequence[str]) -> dict[str, int | float | str]:
    """What --set says, by name. Raises NppgError."""
    found: dict[str, int | float | str] = {}
    for setting in settings:
        name, equals, text = setting.partition("=")
        if not (name and equals and text):
            raise NppgError(f"--set takes NAME=VALUE, not '{setting}'")
        value = number(text)
        found[name] = text if value is None else value
    return found


@contextmanager
def warnings_told(tell: bool = True) -> Iterator[None]:
    """Prints each warning at once, and once, on a line of its own."""
    told: set[str] = set()

    def show(message: Warning | str, *_: object, **__: object) -> None:
        if tell and str(message) not in told:
            told.add(str(message))
            print(f"warning: {message}", file=sys.stderr)

    with warnings.catch_warnings():
        warnings.simplefilter("always", UserWarning)
        warnings.showwarning = show
        yield
