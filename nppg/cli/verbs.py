"""The verbs, and how one is run. Its module, and Prolog with it, is loaded only when it is called."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from importlib import import_module
from typing import Any

from nppg.bridge.doctor import versions
from nppg.cli.arguments import Parser, warnings_told
from nppg.cli.isolating import bound, is_isolated, isolated
from nppg.errors import NppgError, suggestion

VERBS = {
    "doctor": "look whether everything that nppg needs is there",
    "domains": "list the domains that come with nppg",
    "new": "write a commented domain and language bias to start from",
    "import": "write a domain, its language bias and its problems from PDDL",
    "convert": "write a data set of ACE or Aleph as nppg has it",
    "features": "derive predicates that a policy may want to test in a domain",
    "check": "report every mistake in a domain and its language bias",
    "train": "learn a policy",
    "evaluate": "measure a policy's success",
    "plan": "print the plan that a policy finds for a problem",
    "show": "print a policy's trees",
    "explain": "tell for each action of a state its probability, and the rules that made it",
    "play": "draw one episode step by step",
    "distill": "write few rules that choose like a policy of many trees",
    "prove": "show from which start states a policy can fail, and write a certificate",
    "tilde": "learn a tree from examples: fit, predict, show",
    "sign": "write anew the checksums of files that were edited on purpose",
    "curves": "draw the learning curves of several runs in one picture",
    "report": "write one page of HTML about runs: rules, curves, trees, episodes",
    "reproduce": "do an experiment of the paper: its runs, its figure, a report",
    "completion": "print what makes a shell complete nppg's commands and options",
}
_ABOUT = "Learn to act in structured worlds by non-parametric policy gradients, and read what was learned as rules."


def run(arguments: Sequence[str]) -> int:
    """The exit status of the command that the arguments are: 2 after a mistake, which is printed."""
    try:
        return _run(arguments)
    except NppgError as error:
        print(error, file=sys.stderr)
        return 2


def _run(arguments: Sequence[str]) -> int:
    name, *rest = arguments or ["--help"]
    if name == "--version":
        print(versions())
        return 0
    if name.startswith("-"):
        _overview().parse_args([name])
        raise NppgError(f"{name} is no option of nppg: see nppg --help")
    if name not in VERBS:
        raise NppgError(f"there is no command {name}{suggestion(name, VERBS)}: see nppg --help")
    if is_isolated():
        bound()
    elif "--isolate" in rest:
        return isolated(arguments)
    verb, parser = parser_of(name)
    options = parser.parse_args(rest, argparse.Namespace(arguments=arguments))
    if getattr(options, "trust", False):
        os.environ["NPPG_TRUST"] = "1"  # for the processes, too, that the command starts
    with warnings_told():
        status: int = verb.run(options)
    return status


def parser_of(name: str) -> tuple[Any, Parser]:
    """A verb's module, and what reads its arguments."""
    verb = import_module(f"nppg.cli.{name}")
    parser = Parser(prog=f"nppg {name}", description=f"{sentence(VERBS[name])}.", allow_abbrev=False)
    verb.add_arguments(parser)
    return verb, parser


def sentence(what: str) -> str:
    """With a capital at its beginning, and the others left."""
    return what[:1].upper() + what[1:]


def _overview() -> Parser:
    width = max(map(len, VERBS)) + 2
    commands = "\n".join(f"  {name:{width}}{what}" for name, what in VERBS.items())
    parser = Parser(
        prog="nppg",
        usage="nppg COMMAND ...",
        description=f"{_ABOUT}\n\ncommands (nppg COMMAND --help tells their options):\n{commands}",
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    parser.add_argument("--version", action="store_true", help="tell the versions of nppg, of Prolog and of the bridge")
    return parser
