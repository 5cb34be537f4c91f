"""TILDE on its own, for any examples with classes or real targets."""

from nppg.tilde.estimators import TildeClassifier as TildeClassifier
from nppg.tilde.estimators import TildeRegressor as TildeRegressor
from nppg.tilde.own import language as language
from nppg.tilde.reading import read_task as read_task
from nppg.tilde.task import Settings as Settings
from nppg.tilde.task import Task as Task
from nppg.trees.tilde import Example as Example
from nppg.trees.tilde import fit as fit
