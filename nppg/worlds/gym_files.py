"""The files that nppg writes for an environment of Gymnasium: its domain and its language bias.

An observation is the facts obs(1, X1), ..., obs(n, Xn), and the environment's action K is do(K).
"""

from __future__ import annotations

from collections.abc import Iterable

from nppg.bias.names import written

_DOMAIN = """\
:- module({name}, []).

% An environment of Gymnasium, where its dynamics live: obs(I, X) says that component I of the observation, counted
% from 1, is X, and do(K) is the environment's action K.

:- environment({id}).
:- fluent obs/2.

{actions}
"""

_BIAS = """\
# Written by nppg: what a policy for {id} may test. docs/language_bias.md is the reference.

action: do(+choice)

types:
  obs: [component, number]

modes:
  - equal(+choice, [{choices}])
{components}
  - "+number =< #"

lookahead: 1
max_variables: {count}

sentences:
  do: "do {{1}}"
  obs: "component {{1}} is {{2}}"
"""


def domain_text(name: str, id: str, actions: Iterable[int]) -> str:
    """The domain file of the environment `id`, as a module `name`."""
    clauses = "\n".join(f"action(do({number}))." for number in actions)
    return _DOMAIN.format(name=written(name), id=written(id), actions=clauses)


def bias_text(id: str, actions: Iterable[int], components: int) -> str:
    """The language bias: which action it is, and each component of the observation."""
    modes = (f'  - {{literal: "obs({i}, -number)", lookahead: 1}}' for i in range(1, components + 1))
    choices = ", ".join(map(str, actions))
    return _BIAS.format(id=id, choices=choices, components="\n".join(modes), count=components)
