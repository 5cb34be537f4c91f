"""One page of HTML that needs nothing else: the template, the style and the script of the folder page/, filled in.

What comes from files is escaped by who writes it into HTML; data for the script stand in a block that cannot end early.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from html import escape
from pathlib import Path
from string import Template
from typing import Any, NamedTuple

from nppg.reports import chart
from nppg.trees import drawing

_FOLDER = Path(__file__).parent / "page"


class Section(NamedTuple):
    """A section of the page: what its link is called, its title, its contents in HTML."""

    name: str
    link: str
    title: str
    html: str


class Page(NamedTuple):
    """What the page says: plain text but for the sections. Tiles are values with what they are."""

    title: str
    lead: str
    tiles: Sequence[tuple[str, str]]
    sections: Sequence[Section]
    foot: str
    data: Any

    def html(self) -> str:
        """The page."""
        links = "".join(f'<li><a href="#{each.name}">{escape(each.link)}</a></li>' for each in self.sections)
        tiles = "".join(f"<div><dt>{escape(what)}</dt><dd>{escape(value)}</dd></div>" for value, what in self.tiles)
        sections = "".join(
            f'<section id="{each.name}"><h2>{escape(each.title)}</h2>\n{each.html}</section>\n'
            for each in self.sections
        )
        return Template(_file("report.html")).substitute(
            title=escape(self.title),
            lead=escape(self.lead),
            tiles=tiles,
            links=links,
            sections=sections,
            foot=escape(self.foot),
            css=_file("report.css") + chart.STYLE + drawing.STYLE,
            js=_file("report.js"),
            data=embedded(self.data),
        )


def embedded(data: Any) -> str:
    """JSON that may stand in a script element, whatever it says."""
    text = json.dumps(data, separators=(",", ":"), ensure_ascii=False)
    return text.replace("&", "\\u0026").replace("<", "\\u003c").replace(">", "\\u003e").replace("\u2028", "\\u2028")


def note(text: str) -> str:
    """A paragraph that says what is seen."""
    return f'<p class="note">{escape(text)}</p>'


def table(rows: Sequence[tuple[str, object]], kind: str = "") -> str:
    """Names with values."""
    body = "".join(
        f'<tr><th scope="row">{escape(str(name))}</th><td class="{kind}">{escape(str(value))}</td></tr>'
        for name, value in rows
    )
    return f'<div class="table"><table><tbody>{body}</tbody></table></div>'


def command(text: str) -> str:
    """What may be typed in a shell."""
    return f'<div class="command"><code>{escape(text)}</code></div>'


def _file(name: str) -> str:
    return (_FOLDER / name).read_text(encoding="utf-8")
