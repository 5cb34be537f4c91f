"""Results: lines of JSON, each one thing that was done, in the files *.jsonl of a folder."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

Line = dict[str, Any]
KEY = ("part", "domain", "seed", "level", "problem")


class Results:
    """The lines of a folder, which what is done anew is added to. Several processes may add to it, each to the files of
    its own part, domain and seed."""

    def __init__(self, folder: Path) -> None:
        """Reads what is there, in `folder`, which need not exist."""
        self.folder = folder
        read = (json.loads(text) for file in sorted(folder.glob("*.jsonl")) for text in file.read_text().splitlines())
        self.lines: dict[tuple[Any, ...], Line] = {_key(line): line for line in read}

    def has(self, **wanted: Any) -> bool:
        """Whether this was done."""
        return _key(wanted) in self.lines

    def get(self, **wanted: Any) -> Line | None:
        """What came of it, if it was done."""
        return self.lines.get(_key(wanted))

    def add(self, line: Line) -> Line:
        """Writes the line at once."""
        self.lines[_key(line)] = line
        self.folder.mkdir(parents=True, exist_ok=True)
        name = "-".join(str(line[each]) for each in KEY[:3] if each in line)
        with (self.folder / f"{name}.jsonl").open("a") as file:
            file.write(json.dumps(line) + "\n")
        return line


def _key(line: Line) -> tuple[Any, ...]:
    return tuple(line.get(each) for each in KEY)
