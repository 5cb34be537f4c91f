"""Who guides episodes: the experts by name."""

from __future__ import annotations

from nppg.judging.expert import OptimalExpert
from nppg.learning.episode import Expert
from nppg.learning.options import Common
from nppg.worlds.domain import Domain

DOMAIN, OPTIMAL = "domain", "optimal"


def expert_of(domain: Domain, options: Common) -> Expert | None:
    """The one that the options name, None for the domain's own, or where no episode is to be guided. Raises NppgError
    where it cannot advise in this domain."""
    if options.guidance == 0 or options.expert == DOMAIN:
        return None
    if options.expert == OPTIMAL:
        return OptimalExpert(domain)
    from nppg.planning.teacher import PlanningExpert  # which needs unified-planning

    return PlanningExpert(domain, options.expert)
