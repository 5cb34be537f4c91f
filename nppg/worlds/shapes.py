"""States as shapes, where a domain draws them by shapes/1."""

from __future__ import annotations

from nppg.bridge.prolog import ask
from nppg.worlds.domain import Domain
from nppg.worlds.world import State

Shape = tuple[str | int | float, ...]  # as prolog/shapes.pl has them: ("box", X, Y, Width, Height, Tone, Text)


def shapes(domain: Domain, state: State) -> list[Shape]:
    """The state as shapes, none where the domain draws none. Raises NppgError where its code is at fault."""
    domain.visit(state)
    return [tuple(shape) for shape in ask("shapes_of", domain.module)]
