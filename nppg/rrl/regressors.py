"""The regressor that some options are about."""

from __future__ import annotations

from nppg.answers.coverage import root_table
from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import Refiner
from nppg.errors import NppgError, Problem
from nppg.logic.query import OPEN
from nppg.rrl.distance import PairDistance
from nppg.rrl.instance_tree import InstanceTree
from nppg.rrl.options import InstanceOptions, QOptions, TGOptions
from nppg.rrl.qfunction import Regressor
from nppg.rrl.tg import TG
from nppg.worlds.domain import Domain


def regressor(domain: Domain, bias: LanguageBias, options: QOptions) -> Regressor:
    """A new one that has learned nothing. Raises NppgError for a bias with thresholds, which these cannot learn."""
    for mode in bias.modes:
        if mode.name in OPEN:
            message = f"the learner {options.learner} has no thresholds, nppg has"
            raise NppgError([Problem(bias.file, mode.line, mode.column, message)])
    refiner = Refiner(bias)
    table = root_table(domain, bias, refiner)
    if isinstance(options, InstanceOptions):
        return InstanceTree(table, refiner, PairDistance(domain, bias, options.mismatch), options)
    assert isinstance(options, TGOptions)
    return TG(table, refiner, options)
