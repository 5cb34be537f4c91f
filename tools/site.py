"""What `make docs` adds to the pages under docs/: the README as the first page, the other files that pages link to, and
the reference, made from the docstrings and the commands' own help. A link to what is not there ends the build.

The hooks of mkdocs.yml.
"""

from __future__ import annotations

import logging
import os
import posixpath
import re
from pathlib import Path

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page

import nppg
from nppg.cli import verbs

ROOT = Path(__file__).resolve().parent.parent
FIRST = {"README.md": "index.md"}  # where pages from outside docs/ come to lie; others keep their names
LINK = re.compile(r"(?<=\]\()([^)\s#:]+)(?=[)#])")
FENCE = re.compile(r"^```.*?^```[^\n]*$", re.MULTILINE | re.DOTALL)

log = logging.getLogger("mkdocs.hooks.site")
origins: dict[str, str] = {}  # of a page of the site: its file in the repository


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Adds what is not under docs/."""
    for name in ("README.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md"):
        _add(files, config, name)
    queue = [page.src_uri for page in files.documentation_pages()]
    while queue:
        uri = queue.pop()
        text = FENCE.sub("", _text(files, uri))
        for link in LINK.findall(text):
            path = _path(uri, link)
            if not path.startswith("docs/") and _uri(path) not in origins and (ROOT / path).exists():
                queue += _add(files, config, path)
    files.append(File.generated(config, "reference/python.md", content=_python()))
    files.append(File.generated(config, "reference/commands.md", content=_commands()))
    return files


def on_page_markdown(markdown: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    """Has links lead to where things lie in the site, and Markdown in tables of HTML be read as such."""
    uri = page.file.src_uri

    def placed(link: re.Match[str]) -> str:
        target = _uri(_path(uri, link[1]))
        if files.get_file_from_path(target) is None:
            return link[1]  # what is not there is told by mkdocs
        return posixpath.relpath(target, posixpath.dirname(uri) or ".")

    parts = re.split(f"({FENCE.pattern})", markdown, flags=re.MULTILINE | re.DOTALL)
    for index in range(0, len(parts), 2):
        parts[index] = re.sub(r"<(table|tr|td)>", r"<\1 markdown>", LINK.sub(placed, parts[index]))
    return "".join(parts)


def _add(files: Files, config: MkDocsConfig, path: str) -> list[str]:
    """Adds a file of the repository, or the list of a folder's; what there is to read through for further links."""
    uri = _uri(path)
    if (ROOT / path).is_file():
        origins[uri] = path
        files.append(File.generated(config, uri, abs_src_path=str(ROOT / path)))
    else:
        names = sorted(each.name for each in (ROOT / path).iterdir())
        origins[uri] = f"{path}/README.md"
        lines = [f"# {path}", "", *(f"* [{name}]({name})" for name in names)]
        files.append(File.generated(config, uri, content="\n".join(lines)))
    return [uri] if uri.endswith(".md") else []


def _uri(path: str) -> str:
    """Where a file or a folder of the repository lies in the site."""
    if (ROOT / path).is_dir():
        path = posixpath.join(path, "README.md")
    return FIRST.get(path) or path.removeprefix("docs/")


def _path(uri: str, link: str) -> str:
    """The file of the repository that a page's link is about."""
    return posixpath.normpath(posixpath.join(posixpath.dirname(origins.get(uri, f"docs/{uri}")), link))


def _text(files: Files, uri: str) -> str:
    file = files.get_file_from_path(uri)
    assert file is not None
    return file.content_string


def _python() -> str:
    parts = ["# Python\n\nWhat `import nppg` gives.\n"]
    for name in nppg.__all__:
        parts.append(f"## nppg.{name}\n\n::: {nppg._HOME[name]}.{name}\n    options:\n      show_root_heading: false\n")
    return "\n".join(parts)


def _commands() -> str:
    os.environ["COLUMNS"] = "100"
    parts = ["# Commands\n\nWhat `nppg COMMAND --help` prints.\n"]
    for name, what in verbs.VERBS.items():
        help = verbs.parser_of(name)[1].format_help()
        parts.append(f"## nppg {name}\n\n{verbs.sentence(what)}.\n\n```text\n{help}```\n")
    return "\n".join(parts)
