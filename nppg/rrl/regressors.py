"""The regressor that some options are about."""

from __future__ import annotations

from nppg.coverage import root_table
from nppg.domain import Domain
from nppg.language_bias import LanguageBias
from nppg.refinement import Refiner
from nppg.rrl.options import QOptions, TGOptions
from nppg.rrl.qfunction import Regressor
from nppg.rrl.tg import TG


def regressor(domain: Domain, bias: LanguageBias, options: QOptions) -> Regressor:
    """A new one that has learned nothing."""
    refiner = Refiner(bias)
    table = root_table(domain, bias, refiner)
    if isinstance(options, TGOptions):
        return TG(table, refiner, options)
    raise TypeError(f"no regressor for {type(options).__name__}")
