"""A tree drawn as SVG: tests in boxes, success to the left, and in each leaf its value, the stronger the higher it is.

A picture by itself brings its style along, in which it is seen on a dark ground, too; on a page that has the style it
goes without. All text is escaped.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from html import escape
from itertools import count
from typing import NamedTuple

STYLE = """
.tree { font: 12px ui-monospace, "SF Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace; }
.tree .edge { fill: none; stroke: var(--line, #b9bfca); stroke-width: 1.5; }
.tree .answer { fill: var(--quiet, #6b7280); font: 11px system-ui, sans-serif; text-anchor: middle;
  paint-order: stroke; stroke: var(--ground, #fff); stroke-width: 5px; stroke-linejoin: round; }
.tree .test rect { fill: var(--panel, #fff); stroke: var(--line, #b9bfca); stroke-width: 1.25; }
.tree text { fill: var(--ink, #1f2430); text-anchor: middle; dominant-baseline: central; }
.tree .caption { fill: var(--quiet, #6b7280); text-anchor: start; }
.tree .leaf rect { stroke-width: 1.25; fill-opacity: calc(.1 + .45 * var(--strength)); }
.tree .up rect { fill: var(--up, #0f8a74); stroke: var(--up, #0f8a74); }
.tree .down rect { fill: var(--down, #c2416c); stroke: var(--down, #c2416c); }
.tree .level rect { fill: var(--quiet, #6b7280); stroke: var(--quiet, #6b7280); }
.tree .count { fill: var(--quiet, #6b7280); font-size: 10.5px; }
"""
_DARK = "@media (prefers-color-scheme: dark) { .tree { --ink: #e7e9ee; --quiet: #a2a9b8; --line: #4b5365; "
_DARK += "--panel: #1d212b; --ground: #12151c; --up: #35c3a5; --down: #f0789c; } }"

_CHARACTER = 7.3  # the width of one, in the style's font
_LINE = 17.0
_PADDING = 11.0
_ACROSS = 18.0  # between neighbours
_DOWN = 46.0  # between levels
_WIDEST = 34  # characters of a line, beyond which a test goes on on the next one


class Drawn(NamedTuple):
    """What is drawn of a node: its test, or its value and what is said below that; and the nodes behind its answers."""

    lines: tuple[str, ...]
    value: float = 0.0
    yes: Drawn | None = None
    no: Drawn | None = None


class _Place(NamedTuple):
    """A node with its place: the middle of its upper edge, and its size."""

    number: int  # of the leaf, from 0; -1 where it is a test
    node: Drawn
    x: float
    y: float
    width: float
    height: float


def svg(root: Drawn, caption: str = "", style: bool = True) -> str:
    """The tree whose root this is. Leaves are of the class leaf, with their number, from 0, as data-leaf; the
    caption stands above it."""
    places: list[_Place] = []
    edges: list[tuple[_Place, _Place, str]] = []
    numbers = count()
    width, _ = _put(root, 0.0, 28.0 if caption else 1.0, numbers, places, edges)
    width = max(width, len(caption) * _CHARACTER)
    height = max(place.y + place.height for place in places) + 1.0
    highest = max((abs(place.node.value) for place in places if place.number >= 0), default=0.0) or 1.0
    head = f'<svg class="tree" xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width + 2:.0f} {height:.0f}" '
    head += f'width="{width + 2:.0f}" height="{height:.0f}" role="img" aria-label="a tree">'
    parts = [head, f"<style>{STYLE}{_DARK}</style>" if style else ""]
    parts += [f'<text class="caption" x="1" y="10">{escape(caption)}</text>'] if caption else []
    parts += [_edge(*edge) for edge in edges]
    parts += [_box(place, highest) for place in places]
    return "".join(parts) + "</svg>"


def wrapped(literals: Sequence[str]) -> tuple[str, ...]:
    """A conjunction in lines that are not too long, if its literals are not."""
    lines: list[str] = []
    for i, literal in enumerate(literals):
        text = literal + ("," if i + 1 < len(literals) else "")
        if lines and len(lines[-1]) + 1 + len(text) <= _WIDEST:
            lines[-1] += f" {text}"
        else:
            lines.append(text)
    return tuple(lines)


def _put(
    node: Drawn,
    left: float,
    top: float,
    numbers: Iterator[int],
    places: list[_Place],
    edges: list[tuple[_Place, _Place, str]],
) -> tuple[float, _Place]:
    """Finds the places of a node and of all below it, from `left` on. Returns how wide they are, and the node's."""
    own = max(max(map(len, node.lines), default=1) * _CHARACTER + 2 * _PADDING, 48.0)
    height = len(node.lines) * _LINE + 12.0
    if node.yes is None or node.no is None:
        place = _Place(next(numbers), node, left + own / 2 + 1, top, own, height)
        places.append(place)
        return own, place
    below = top + height + _DOWN
    first, yes = _put(node.yes, left, below, numbers, places, edges)
    second, no = _put(node.no, left + first + _ACROSS, below, numbers, places, edges)
    middle, across = (yes.x + no.x) / 2, first + _ACROSS + second
    shift = max(0.0, left + own / 2 + 1 - middle)  # a test wider than what is below it
    if shift:
        middle += shift
    place = _Place(-1, node, middle, top, own, height)
    places.append(place)
    edges += [(place, yes, "yes"), (place, no, "no")]
    return max(across, middle + own / 2 - left), place


def _edge(above: _Place, below: _Place, answer: str) -> str:
    x, y, to = above.x, above.y + above.height, below.y
    bend = (y + to) / 2
    path = f"M{x:.1f} {y:.1f}C{x:.1f} {bend:.1f} {below.x:.1f} {bend:.1f} {below.x:.1f} {to:.1f}"
    at = (x + below.x) / 2 + (-16 if answer == "yes" else 16)
    return f'<path class="edge" d="{path}"/><text class="answer" x="{at:.1f}" y="{bend - 3:.1f}">{answer}</text>'


def _box(place: _Place, highest: float) -> str:
    node, left = place.node, place.x - place.width / 2
    is_leaf = place.number >= 0
    kind, more = "test", ""
    if is_leaf:
        kind = f"leaf {'up' if node.value > 0 else 'down' if node.value < 0 else 'level'}"
        more = f' data-leaf="{place.number}" style="--strength:{abs(node.value) / highest:.3f}"'
    lines = []
    for i, line in enumerate(node.lines):
        small = ' class="count"' if is_leaf and i else ""
        y = place.y + 6 + (i + 0.5) * _LINE
        lines.append(f'<text{small} x="{place.x:.1f}" y="{y:.1f}">{escape(line)}</text>')
    corner = place.height / 2 if is_leaf and len(node.lines) == 1 else 9.0
    box = f'<rect x="{left:.1f}" y="{place.y:.1f}" width="{place.width:.1f}" height="{place.height:.1f}" '
    return f'<g class="{kind}"{more}>{box}rx="{corner:.1f}"/>{"".join(lines)}</g>'
