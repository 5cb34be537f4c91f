"""nppg's policies as a planner of unified-planning; importing this package registers it under the name nppg.

    import nppg.planning
    OneshotPlanner(name="nppg", params={"model": "runs/library/model.pl"})

It is chosen by its name alone, since it needs a model. Where nothing shall be imported, a file up.ini does the same:

    [engine nppg]
    module_name: nppg.planning.engine
    class_name: NppgEngine
"""

from __future__ import annotations

from nppg.planning.engine import NppgEngine, get_environment

__all__ = ["NppgEngine", "register"]


def register() -> None:
    """Makes the planner known to unified-planning's global environment. May be called again."""
    factory = get_environment().factory
    if "nppg" not in factory.engines:
        chosen = list(factory.preference_list)
        factory.add_engine("nppg", "nppg.planning.engine", "NppgEngine")
        factory.preference_list = chosen


register()
