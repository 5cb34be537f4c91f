"""TILDE on its own, for any examples with real targets."""

from nppg.trees.tilde import Example as Example
from nppg.trees.tilde import fit as fit
