"""Two versions of nppg beside each other, in turn: python -m benchmarks.paired CHECKOUT [RUNS [FILE]]

CHECKOUT is a checkout of the other version, such as `git worktree add ../before COMMIT` makes. Each task is done by
either version in a process of its own, RUNS times (3), and prints the seconds of CPU time that count; the ratio is the
median of those of the pairs. FILE gets the table between its markers. Tasks about the competition's worlds need
NPPG_PDDL, a folder like that of its learning track.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from statistics import median

from benchmarks.__main__ import machine
from benchmarks.common import splice

HERE = Path(__file__).parent.parent
HEAD = """
import os, sys, time
from collections import deque
from dataclasses import replace
from random import Random
import numpy as np
from nppg import Domain, LanguageBias, Options, Policy, language_bias_of, open_domain, options_of, train
from nppg.answers.coverage import root_table
from nppg.bias.refinement import Refiner
from nppg.bridge.files import locate
clock = time.process_time

def blocks():
    return Domain("blocks_world"), LanguageBias.load(locate("blocks_world", "language_bias", ".yaml"))

def learned(domain, bias, options):
    start = clock()
    deque(train(domain, bias, options), maxlen=0)
    return clock() - start

def competition(name, episodes, options=None):
    from pathlib import Path
    folder = Path(os.environ["NPPG_PDDL"], name)
    domain = open_domain(folder / "domain.pddl", problems=sorted(folder.glob("training/**/*.pddl")))
    bias = language_bias_of(domain)
    return domain, bias, options or options_of(bias, episodes=episodes)
"""
TASKS = {
    "the paper's run, 2000 episodes": "print(learned(*blocks(), Options()))",
    "second-order training, 500 episodes": "print(learned(*blocks(), Options(500, step='second-order')))",
    "one tree from 20,000 examples": """
from pathlib import Path
from benchmarks import one_tree
from nppg.tilde import fit
domain = Domain("blocks_world")
bias = LanguageBias.load(Path(one_tree.__file__).with_name("one_tree.yaml"))
examples = one_tree.data_set(domain, 20_000, np.random.default_rng(0))
start = clock()
fit(examples, domain, bias)
print(clock() - start)""",
    "potentials of 500 trees, 1000 states, cold": """
from benchmarks.common import random_pairs
domain, bias = blocks()
learned = next(each.policy for each in train(domain, bias, Options(10**6)) if len(each.policy.trees) == 500)
states = random_pairs(domain, 1000, np.random.default_rng(1))
policy = Policy(domain, bias, root_table(domain, bias, Refiner(bias)))
for tree in learned.trees:
    policy.add(tree)
start = clock()
for state, actions in states:
    policy.potentials(state, actions)
print(clock() - start)""",
    "RIB, 2000 episodes": """
from nppg.experiments.learners import LEARNERS
print(learned(*blocks(), LEARNERS["rib"](2000)))""",
    "TRENDI, 2000 episodes": """
from nppg.experiments.learners import LEARNERS
print(learned(*blocks(), LEARNERS["trendi"](2000)))""",
    "`nppg train delivery --episodes 300 --starts 200`, its points": """
import tempfile
from pathlib import Path
from nppg.experiments.runs import run
domain, bias = Domain("delivery"), LanguageBias.load(locate("delivery", "language_bias", ".yaml"))
with tempfile.TemporaryDirectory() as folder:
    start = clock()
    progress = run(domain, bias, Options(300), Path(folder), starts=200)
    print(clock() - start - progress.seconds)""",
    **{
        f"refinements of twelve queries, {name}": f"""
_, bias, _ = competition("{name}", 1)
def path(depth, rng):
    refiner, query = Refiner(replace(bias)), ()
    for _ in range(depth):
        query += rng.choice(refiner.refinements(query)).literals
    return query
queries, refiner = [path(1 + i % 3, Random(i)) for i in range(12)], Refiner(replace(bias))
start = clock()
for query in queries:
    refiner.refinements(query)
print(clock() - start)"""
        for name in ("blocksworld", "satellite", "transport")
    },
    **{
        f"{name}, 200 episodes": f'print(learned(*competition("{name}", 200)))'
        for name in ("blocksworld", "satellite", "transport")
    },
    "blocksworld, 200 episodes, paper's options": 'print(learned(*competition("blocksworld", 0, Options(200))))',
}


def main() -> None:
    other, runs = Path(sys.argv[1]).resolve(), int(sys.argv[2]) if len(sys.argv) > 2 else 3
    lines = [machine(), "", "| what | before | now | ratio |", "|---|---:|---:|---:|"]
    print("\n".join(lines), flush=True)
    for name, code in TASKS.items():
        if "competition(" in code and "NPPG_PDDL" not in os.environ:
            continue
        pairs = [(_seconds(other, code), _seconds(HERE, code)) for _ in range(runs)]
        before, now = (median(each) for each in zip(*pairs, strict=True))
        ratio = median(old / new for old, new in pairs)
        lines.append(f"| {name} | {before:.2f} s | {now:.2f} s | {ratio:.1f} |")
        print(lines[-1], flush=True)
    if len(sys.argv) > 3:
        splice(Path(sys.argv[3]), "paired", "\n".join(lines))


def _seconds(checkout: Path, code: str) -> float:
    environment = {**os.environ, "PYTHONPATH": str(checkout), "OPENBLAS_NUM_THREADS": "1"}
    run = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", HEAD + code],
        check=True,
        capture_output=True,
        text=True,
        env=environment,
        cwd=checkout,
    )
    return float(run.stdout.split()[-1])


if __name__ == "__main__":
    main()
