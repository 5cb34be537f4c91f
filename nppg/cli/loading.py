"""The domain, the language bias and the policy that arguments name."""

from __future__ import annotations

import argparse

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.files import locate
from nppg.cli.arguments import parameters, warnings_told
from nppg.errors import NppgError, Problem
from nppg.policy.policy import Policy
from nppg.worlds.domain import Domain
from nppg.worlds.opening import bias_path, is_environment, language_bias_of, open_domain, warn_of_another_task


def domain(options: argparse.Namespace) -> Domain:
    """Raises NppgError."""
    return open_domain(options.domain, parameters(options.set))


def bias(options: argparse.Namespace, domain: Domain | None) -> LanguageBias | None:
    """The file given by --bias, or what goes with the domain, if that could be loaded or at least be found."""
    if options.bias:
        found = LanguageBias.load(locate(options.bias, "language_bias", ".yaml"))
        if domain:
            warn_of_another_task(domain, found.file)
        return found
    if domain:
        return language_bias_of(domain)
    if is_environment(options.domain):
        return None
    return LanguageBias.load(bias_path(locate(options.domain, "domains", ".pl"), parameters(options.set)))


def policy(options: argparse.Namespace, tell: bool = True) -> Policy:
    """Read from the model file. Raises NppgError."""
    with warnings_told(tell):
        return Policy.load(options.model, parameters(getattr(options, "set", [])))


def bias_of(policy: Policy, options: argparse.Namespace) -> LanguageBias:
    """The file given by --bias, or the one that the model names."""
    if not options.bias and "bias" not in policy.facts:
        raise NppgError([Problem(str(options.model), 0, 0, "the model names no language bias; give one by --bias")])
    return LanguageBias.load(locate(options.bias or policy.bias.file, "language_bias", ".yaml"))
