"""The verbs, and how one is run. Its module, and Prolog with it, is loaded only when it is called."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from importlib import import_module
from importlib.metadata import version

from nppg.cli.arguments import Parser, warnings_told
from nppg.cli.isolating import bound, is_isolated, isolated
from nppg.errors import NppgError, suggestion

VERBS = {
    "doctor": "look whether everything that nppg needs is there",
    "new": "write a commented domain and language bias to start from",
    "import": "write a domain, its language bias and its problems from PDDL",
    "features": "derive predicates that a policy may want to test in a domain",
    "check": "report every mistake in a domain and its language bias",
    "train": "learn a policy",
    "evaluate": "measure a policy's success",
    "plan": "print the plan that a policy finds for a problem",
    "show": "print a policy's trees",
    "play": "draw one episode step by step",
    "distill": "write few rules that choose like a policy of many trees",
    "prove": "show from which start states a policy can fail, and write a certificate",
    "sign": "write anew the checksums of files that were edited on purpose",
    "reproduce": "do an experiment of the paper: its runs, its figure, a report",
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
    if name.startswith("-"):
        _overview().parse_args([name])
        raise NppgError(f"{name} is no option of nppg: see nppg --help")
    if name not in VERBS:
        raise NppgError(f"there is no command {name}{suggestion(name, VERBS)}: see nppg --help")
    if is_isolated():
        bound()
    elif "--isolate" in rest:
        return isolated(arguments)
    verb = import_module(f"nppg.cli.{name}")
    parser = Parser(prog=f"nppg {name}", description=f"{VERBS[name].capitalize()}.", allow_abbrev=False)
    verb.add_arguments(parser)
    options = parser.parse_args(rest, argparse.Namespace(arguments=arguments))
    if getattr(options, "trust", False):
        os.environ["NPPG_TRUST"] = "1"  # for the processes, too, that the command starts
    with warnings_told():
        status: int = verb.run(options)
    return status


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
    parser.add_argument("--version", action="version", version=f"nppg {version('nppg')}")
    return parser
