"""The domain, the language bias and the policy that arguments name."""

from __future__ import annotations

import argparse

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.files import locate
from nppg.cli.arguments import parameters, warnings_told
from nppg.errors import NppgError, Problem
from nppg.learning.options import Options
from nppg.policy.policy import Policy
from nppg.worlds.domain import Domain
from nppg.worlds.opening import (
    bias_path,
    is_generated,
    language_bias_of,
    open_domain,
    warn_of_another_task,
    with_problems,
)
from nppg.worlds.problems import sorted_out


def domain(options: argparse.Namespace) -> Domain:
    """Raises NppgError."""
    return open_domain(options.domain, parameters(options.set), options.problems)


def bias(options: argparse.Namespace, domain: Domain | None) -> LanguageBias | None:
    """The file given by --bias, or what goes with the domain, if that could be loaded or at least be found."""
    if options.bias:
        found = LanguageBias.load(locate(options.bias, "language_bias", ".yaml"))
        if domain:
            warn_of_another_task(domain, found.file)
        return found
    if domain:
        return language_bias_of(domain)
    if is_generated(options.domain):
        return None
    return LanguageBias.load(bias_path(locate(options.domain, "domains", ".pl"), parameters(options.set)))


def policy(options: argparse.Namespace, tell: bool = True) -> Policy:
    """Read from the model file. Raises NppgError."""
    with warnings_told(tell):
        found = Policy.load(options.model, parameters(getattr(options, "set", [])), edited=options.edited)
    found.domain = with_problems(found.domain, *sorted_out(getattr(options, "problems", [])))
    return found


def factor(options: argparse.Namespace, policy: Policy) -> float:
    """The horizon's: --horizon-factor, else that of the policy's training. Raises NppgError."""
    given = options.horizon_factor
    return Options(horizon_factor=policy.option("horizon_factor", 1.0) if given is None else given).horizon_factor


def bias_of(policy: Policy, options: argparse.Namespace) -> LanguageBias:
    """The file given by --bias, or the one that the model names."""
    if not options.bias and "bias" not in policy.facts:
        raise NppgError([Problem(str(options.model), 0, 0, "the model names no language bias; give one by --bias")])
    return LanguageBias.load(locate(options.bias or policy.bias.file, "language_bias", ".yaml"))
