"""Long lives: steps by the million and domains by the hundred leave memory, atoms and clauses as they were; and what is
computed does not hang on the process, its hash seed or its locale. `make soak` takes the large numbers."""

from __future__ import annotations

import gc
import os
import subprocess
import sys
from pathlib import Path

import janus_swi
import numpy as np
import pytest

from nppg import Domain, Policy, language_bias_of, open_domain

SOAK = bool(os.environ.get("NPPG_SOAK"))
STEPS, DOMAINS = (1_000_000, 200) if SOAK else (4_000, 12)
KINDS = ("blocks_world", "grid", "delivery", "noisy_blocks", "several")
COUNTS = "garbage_collect_atoms, garbage_collect_clauses, statistics(atoms, Atoms), statistics(clauses, Clauses)"
SEVERAL = {
    "several.pl": ":- module(several, []).\n:- use_module(more).\n:- include(rest).\n:- fluent at/1.\n"
    ":- table path/1.\nstart([at(1)]).\naction(go).\neffect(go, [at(X)], [at(Y)]) :- at(X), next(X, Y).\n"
    "path(X) :- at(X).\npath(Y) :- path(X), X < 5, next(X, Y).\n",
    "more.pl": ":- module(more, [next/2]).\nnext(X, Y) :- Y is X mod 9 + 1.\n",
    "rest.pl": "goal :- fail.\nterminal :- path(99).\n",
}


def counts() -> tuple[int, int, int]:
    """Kilobytes of memory, atoms and clauses."""
    gc.collect()
    open_domain("corridor")  # a question, with which Prolog forgets what Python has dropped
    gc.collect()
    open_domain("corridor")
    found = janus_swi.query_once(COUNTS)
    memory = int(Path("/proc/self/statm").read_text().split()[1]) * 4 if sys.platform == "linux" else 0
    return memory, found["Atoms"], found["Clauses"]


def lived(name: str, steps: int, seed: int) -> None:
    """Opens a domain, plays in it, and drops it."""
    domain = Domain(name)
    bias = None if domain.name == "several" else language_bias_of(domain)
    policy = bias and Policy(domain, bias)
    rng = np.random.default_rng(seed)
    state = domain.start(rng)
    for _ in range(steps):
        status, actions = domain.situation(state)
        if status != "running":
            state = domain.start(rng)
            continue
        if policy:
            policy.potentials(state, actions)
        _, state = domain.act(state, actions[int(rng.integers(len(actions)))], rng)


def test_steps_and_domains_leave_nothing(tmp_path: Path) -> None:
    for name, text in SEVERAL.items():
        (tmp_path / name).write_text(text)
    names = [str(tmp_path / "several.pl") if name == "several" else name for name in KINDS]
    for i in range(2 * len(names)):
        lived(names[i % len(names)], 50, i)
    before = counts()
    for i in range(DOMAINS):
        lived(names[i % len(names)], STEPS // DOMAINS, i)
    memory, atoms, clauses = (now - then for now, then in zip(counts(), before, strict=True))
    print(f"{STEPS} steps, {DOMAINS} domains: {memory} kB, {atoms} atoms, {clauses} clauses more")
    assert atoms < 20 * DOMAINS and clauses < 100 + 8 * DOMAINS and memory < 20_000 + 100 * DOMAINS


PROGRAM = """
import hashlib, pathlib, sys, nppg
domain = nppg.Domain("blocks_world", {"blocks": 4})
options = nppg.Options(episodes=60, min_examples=20, seed=3)
nppg.run(domain, nppg.language_bias_of(domain), options, pathlib.Path(sys.argv[1]), jobs=int(sys.argv[2]))
print(hashlib.sha256(pathlib.Path(sys.argv[1], "model.pl").read_bytes()).hexdigest())
"""


def test_what_is_learned_hangs_on_the_seed_alone(tmp_path: Path) -> None:
    found = set()
    surroundings = [("0", "C", "1"), ("1", "C.UTF-8", "2"), *([("77", "tr_TR.UTF-8", "1"), ("5", "POSIX", "4")] * SOAK)]
    for i, (hashing, locale, jobs) in enumerate(surroundings):
        env = {**os.environ, "PYTHONHASHSEED": hashing, "LC_ALL": locale, "LANG": locale}
        arguments = [sys.executable, "-c", PROGRAM, str(tmp_path / str(i)), jobs]
        result = subprocess.run(arguments, env=env, capture_output=True, text=True, timeout=300)
        assert result.returncode == 0, result.stderr
        found.add(result.stdout)
    assert len(found) == 1


@pytest.mark.skipif(not SOAK, reason="make soak has it")
def test_a_thousand_threads_leave_nothing() -> None:
    from threading import Thread

    domain = Domain("blocks_world")
    before = counts()
    for _ in range(1000):
        thread = Thread(target=lambda: domain.start(np.random.default_rng(0)))
        thread.start()
        thread.join()
    assert counts()[0] - before[0] < 5_000
