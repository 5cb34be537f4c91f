"""Learning curves as SVG: the mean of each group of runs, with its spread."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from html import escape
from typing import NamedTuple

STYLE = """
.chart { font: 12px system-ui, sans-serif; }
.chart text { fill: var(--quiet, #6b7280); }
.chart .grid { stroke: var(--line, #d5d9e0); stroke-width: 1; opacity: .55; }
.chart .line { fill: none; stroke-width: 2.25; stroke-linejoin: round; stroke-linecap: round; }
.chart .greedy { stroke-width: 1.5; stroke-dasharray: 5 4; }
.chart .spread { opacity: .16; }
.chart .s0 { --own: var(--c0, #0b63c5); } .chart .s1 { --own: var(--c1, #c65102); }
.chart .s2 { --own: var(--c2, #0f8a74); } .chart .s3 { --own: var(--c3, #a83279); }
.chart .s4 { --own: var(--c4, #7a6a00); } .chart .s5 { --own: var(--c5, #5b55c9); }
.chart .line { stroke: var(--own); } .chart .spread { fill: var(--own); } .chart .key { fill: var(--own); }
"""
_DARK = "@media (prefers-color-scheme: dark) { .chart { --quiet: #a2a9b8; --line: #4b5365; --c0: #6cb2ff; "
_DARK += "--c1: #ff9d5c; --c2: #35c3a5; --c3: #f089c8; --c4: #d8c545; --c5: #a9a4ff; } }"
COLOURS = 6

_WIDTH, _HEIGHT = 760.0, 320.0
_KEY = 18.0
_LEFT, _RIGHT, _TOP, _BOTTOM = 62.0, 14.0, 12.0, 46.0


class Line(NamedTuple):
    """A curve: episodes, means and, where there are several runs, standard deviations."""

    label: str
    colour: int
    greedy: bool
    episodes: Sequence[float]
    means: Sequence[float]
    spreads: Sequence[float]
    runs: int


def chart(lines: Sequence[Line], measure: str, style: bool = True, keys: bool = False) -> str:
    """The lines in one frame, with `keys` what they stand for below it. All text is escaped."""
    last = max((line.episodes[-1] for line in lines if line.episodes), default=0.0) or 1.0
    values = [
        value + sign * spread
        for line in lines
        for value, spread in zip(line.means, line.spreads, strict=True)
        for sign in (-1, 1)
    ]
    low, high = (0.0, 1.0) if measure == "success" else _frame(values)

    def x(episode: float) -> float:
        return _LEFT + (_WIDTH - _LEFT - _RIGHT) * episode / last

    def y(value: float) -> float:
        share = (min(max(value, low), high) - low) / (high - low)
        return _HEIGHT - _BOTTOM - (_HEIGHT - _TOP - _BOTTOM) * share

    whole = _HEIGHT + (len(lines) * _KEY + 8 if keys else 0.0)
    head = f'<svg class="chart" xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_WIDTH:.0f} {whole:.0f}" '
    parts = [f'{head}role="img" aria-label="learning curves: {escape(measure, True)} over episodes">']
    parts += [f"<style>{STYLE}{_DARK}</style>"] if style else []
    for tick in ticks(low, high):
        parts.append(f'<path class="grid" d="M{_LEFT:.0f} {y(tick):.1f}H{_WIDTH - _RIGHT:.0f}"/>')
        parts.append(f'<text x="{_LEFT - 8:.0f}" y="{y(tick) + 4:.1f}" text-anchor="end">{tick:g}</text>')
    for tick in ticks(0.0, last):
        anchor = "end" if x(tick) > _WIDTH - 40 else "middle"
        at = min(x(tick), _WIDTH - 2) if anchor == "end" else x(tick)
        parts.append(f'<text x="{at:.1f}" y="{_HEIGHT - 26:.0f}" text-anchor="{anchor}">{tick:,.0f}</text>')
    parts.append(f'<text x="{(_LEFT + _WIDTH) / 2:.0f}" y="{_HEIGHT - 6:.0f}" text-anchor="middle">episodes</text>')
    middle = (_HEIGHT - _BOTTOM) / 2
    turned = f'<text transform="translate(14 {middle:.0f}) rotate(-90)" text-anchor="middle">'
    parts.append(f"{turned}{escape(measure)}</text>")
    for line in lines:
        points = list(zip(map(x, line.episodes), line.means, line.spreads, strict=True))
        if any(line.spreads) and not line.greedy:
            upper = [f"{across:.1f} {y(mean + spread):.1f}" for across, mean, spread in points]
            lower = [f"{across:.1f} {y(mean - spread):.1f}" for across, mean, spread in reversed(points)]
            parts.append(f'<path class="spread s{line.colour % COLOURS}" d="M{"L".join(upper + lower)}Z"/>')
        path = "L".join(f"{across:.1f} {y(mean):.1f}" for across, mean, _ in points)
        parts.append(f'<path class="{_kind(line)}" d="M{path}"><title>{escape(line.label)}</title></path>')
    for i, line in enumerate(lines) if keys else ():
        at = _HEIGHT + 8 + i * _KEY
        parts.append(f'<path class="{_kind(line)}" d="M{_LEFT:.0f} {at:.0f}h26"/>')
        parts.append(f'<text x="{_LEFT + 36:.0f}" y="{at + 4:.0f}">{escape(line.label)}</text>')
    return "".join(parts) + "</svg>"


def _kind(line: Line) -> str:
    return f"line s{line.colour % COLOURS}{' greedy' if line.greedy else ''}"


def legend(lines: Sequence[Line]) -> str:
    """What the colours stand for, as a list in HTML."""
    return "".join(
        f'<li><svg class="chart" width="26" height="10" aria-hidden="true"><path class="{_kind(line)}" d="M2 5H24"/>'
        f"</svg>{escape(line.label)}</li>"
        for line in lines
    )


def ticks(low: float, high: float) -> Iterator[float]:
    """Round numbers between two, about five."""
    raw = (high - low) / 5
    size = 10.0 ** math.floor(math.log10(raw))
    step = next(size * each for each in (1, 2, 2.5, 5, 10) if size * each >= raw * 0.999)
    number = math.ceil(low / step - 1e-9)
    while number * step <= high + 1e-9 * step:
        yield number * step
        number += 1


def _frame(values: Sequence[float]) -> tuple[float, float]:
    """What the values are between, with some room."""
    low, high = min(values, default=0.0), max(values, default=1.0)
    room = (high - low) * 0.05 or max(abs(high), 1.0) * 0.05
    return low - room, high + room
