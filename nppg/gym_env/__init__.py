"""nppg's domains as environments of Gymnasium, for other libraries to learn in; importing this package registers them.

`nppg/NAME-v0` is the shipped domain NAME, `nppg/Domain-v0` the domain file of the argument `domain`. Their observation
is the state itself; `nppg/NAME-bounded-v0` and `nppg/Domain-bounded-v0` (nppg.gym_env.bounded) have spaces of fixed
size. docs/gymnasium.md is the reference.
"""

from __future__ import annotations

from nppg.bridge.files import shipped
from nppg.gym_env.domain_env import Choice, DomainEnv, Facts, gymnasium

__all__ = ["Choice", "DomainEnv", "Facts", "register"]


def register() -> None:
    """Makes the environments known to gymnasium.make(). May be called again: what is known stays."""
    named = {path.stem: {"domain": path.stem} for path in sorted(shipped("domains").glob("*.pl"))}
    for name, arguments in [*named.items(), ("Domain", {})]:
        for suffix, home in (("", "domain_env:DomainEnv"), ("-bounded", "bounded:BoundedEnv")):
            id = f"nppg/{name}{suffix}-v0"
            if id not in gymnasium.registry:
                gymnasium.register(id, entry_point=f"nppg.gym_env.{home}", kwargs=arguments)


register()
