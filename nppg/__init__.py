"""Relational reinforcement learning by non-parametric policy gradients."""

from importlib.metadata import version

__version__ = version("nppg")
