"""The learners by name, each with its options."""

from __future__ import annotations

from nppg.learning.options import Common, Options
from nppg.rrl.options import RIBOptions, TGOptions, TrendiOptions

LEARNERS: dict[str, type[Common]] = {each.learner: each for each in (Options, TGOptions, RIBOptions, TrendiOptions)}
