"""TILDE on made data of growing size: how seconds and memory grow.

Each example has some atoms with an element, a charge and bonds. Its class is whether a nitrogen of high charge is
bonded to an oxygen, with 5 % of the classes turned around; the rest of the facts is there to be looked through. Leaves
hold at least 20 examples: down to two, the tree would be one of the noise, and deeper the more there is of it.
"""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections.abc import Iterator

import numpy as np

from benchmarks.common import Row, peak

_SIZES = (5000, 10_000, 20_000)
_NOISE = 0.05
_ELEMENTS = ("c", "n", "o", "h", "f")
_GROWTH = 2.5  # twice the examples may take so many times as long
_MB = 2**10  # KiB
_LANGUAGE = """
example: molecule(KEY)
modes:
  - {literal: "atom(KEY, +-id, #element, -charge)", lookahead: 1}
  - {literal: "bond(KEY, +id, -id, #kind)", lookahead: 1}
  - "bond(KEY, +id, +id, -kind)"
  - "ring(KEY, +id)"
  - "chain(KEY, +id)"
  - "+charge >= #"
"""


def rows() -> Iterator[Row]:
    """One process for each size and each kind of example: the memory is its peak."""
    for kind in ("keys", "models"):
        seconds = []
        for size in _SIZES:
            command = [sys.executable, "-m", "benchmarks.tilde", kind, str(size)]
            found = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
            seconds.append(found["seconds"])
            what = f"TILDE, {size:,} examples as {kind}, {found['facts']:,} facts"
            measured = f"{found['seconds']:.1f} CPU seconds, {found['memory']:.0f} MB, {found['leaves']} leaves"
            growth = seconds[-1] / seconds[-2] if len(seconds) > 1 else None
            compared = f"{growth:.1f} times the seconds of half of them" if growth else ""
            yield Row(what, measured, compared, f"< {_GROWTH} times", None if growth is None else growth < _GROWTH)


def made(size: int, kind: str) -> tuple[list, list, list[str]]:
    """The examples, the facts of all, and the classes."""
    rng = np.random.default_rng(0)
    examples, shared, classes = [], [], []
    for key in range(size):
        charges = rng.normal(size=2).round(3).tolist()
        elements = [_ELEMENTS[i] for i in rng.integers(len(_ELEMENTS), size=2)]
        ends = list(zip(elements, charges, strict=True))
        atoms = [("atom", f"a{i}", *end) for i, end in enumerate(ends)]
        facts = [*atoms, ("bond", "a0", "a1", int(rng.integers(3))), ("bond", "a1", "a0", int(rng.integers(3)))]
        facts.append(("ring", "a0") if rng.random() < 0.5 else ("chain", "a1"))
        true = any(one == "n" and charge > 0.3 and other == "o" for (one, charge), (other, _) in (ends, ends[::-1]))
        classes.append("yes" if true != (rng.random() < _NOISE) else "no")
        if kind == "keys":
            shared += [(name, key, *args) for name, *args in facts]
        examples.append(key if kind == "keys" else facts)
    return examples, shared, classes


def measure(kind: str, size: int) -> dict[str, float]:
    """What learning takes and gives."""
    from nppg.tilde import TildeClassifier
    from nppg.trees.tree import leaves

    examples, shared, classes = made(size, kind)
    key = "+mol, " if kind == "keys" else ""
    model = TildeClassifier(_LANGUAGE.replace("KEY, ", key).replace("(KEY)", "(+mol)" if key else ""), facts=shared)
    model.set_params(granularity=20, minimal_cases=20)
    start = time.process_time()
    model.fit(examples, classes)
    seconds = time.process_time() - start
    right = model.score(examples[:2000], classes[:2000])
    facts = len(shared) + sum(len(each) for each in examples if kind == "models")
    found = leaves(model.model_.tree)
    return {"seconds": seconds, "facts": facts, "leaves": found, "right": right, "memory": peak() / _MB}


if __name__ == "__main__":
    print(json.dumps(measure(sys.argv[1], int(sys.argv[2]))))
