"""The house: rooms with a sentence over their doors, small modules, and documents whose names exist."""

from __future__ import annotations

import ast
import re
from importlib import import_module
from pathlib import Path

import pytest

import nppg

ROOT = Path(__file__).parent.parent
CODE = sorted([*(ROOT / "nppg").rglob("*.py"), *(ROOT / "prolog").glob("*.pl")])
PAGES = sorted([ROOT / "README.md", *(ROOT / "docs").rglob("*.md")])
NAME = re.compile(r"`(nppg(?:\.[A-Za-z_]\w*)+)")


def test_no_module_is_long() -> None:
    long = {str(path): lines for path in CODE if (lines := len(path.read_text(encoding="utf-8").splitlines())) > 300}
    assert not long


def test_rooms_have_a_sentence_over_their_doors() -> None:
    rooms = [path for path in (ROOT / "nppg").iterdir() if path.is_dir() and path.name != "__pycache__"]
    assert {path.name for path in (ROOT / "nppg").iterdir() if path.is_file()} == {
        "__init__.py",
        "__main__.py",
        "errors.py",
        "py.typed",
    }
    for room in rooms:
        sentence = ast.get_docstring(ast.parse((room / "__init__.py").read_text(encoding="utf-8")))
        assert sentence and sentence.split("\n")[0].endswith("."), room


def test_the_page_of_the_architecture_has_every_room() -> None:
    page = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    drawing = page.split("```")[1]
    drawn = {line.split()[0] for line in drawing.splitlines() if len(line.split()) > 1}
    assert drawn == {
        path.name for path in (ROOT / "nppg").iterdir() if path.is_dir() and path.name != "__pycache__"
    } | {"errors"}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_the_names_that_pages_give_exist(page: Path) -> None:
    for name in set(NAME.findall(page.read_text(encoding="utf-8"))):
        found: object = nppg
        path = "nppg"
        for part in name.split(".")[1:]:
            path += f".{part}"
            if hasattr(found, part):
                found = getattr(found, part)
            else:
                found = import_module(path)


def test_the_front_door_lists_what_it_has() -> None:
    assert all(hasattr(nppg, name) for name in dir(nppg))
    assert {"Domain", "Options", "train", "evaluate", "Policy", "tilde"} <= set(dir(nppg))


def test_a_star_brings_all_of_it() -> None:
    found: dict[str, object] = {}
    exec("from nppg import *", found)
    assert {*found} - {"__builtins__"} == {*dir(nppg)} - {"__version__"}
