"""nppg doctor."""

from __future__ import annotations

import argparse

from nppg.bridge.doctor import doctor, report


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """None."""


def run(options: argparse.Namespace) -> int:
    """0 if all is well, else 2."""
    checks = doctor()
    print(report(checks))
    return 0 if all(check.ok for check in checks) else 2
