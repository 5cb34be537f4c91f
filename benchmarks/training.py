"""A training run with the paper's settings, 2000 episodes without evaluation: its time, and its memory."""

from __future__ import annotations

import subprocess
import sys
from collections import deque
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from statistics import median

from benchmarks import floor
from benchmarks.common import Row, timed
from nppg import Domain, LanguageBias, Options, Policy, train
from nppg.shipped import locate

SEEDS = range(3)
TIMES = 12
MEGABYTES = 300


def learn(seed: int, episodes: int = 2000, step: str = "gradient") -> Policy:
    domain = Domain("blocks_world")
    bias = LanguageBias.load(locate("blocks_world", "language_bias", ".yaml"))
    return deque(train(domain, bias, Options(seed=seed, episodes=episodes, step=step)), maxlen=1)[0].policy


def rows() -> Iterator[Row]:
    world = floor.tables()
    yield _beside_the_floor(world, "training, 2000 episodes", 2000, "gradient")
    yield _beside_the_floor(world, "training, 500 second-order episodes", 500, "second-order")
    run = subprocess.run([sys.executable, "-m", __name__], check=True, capture_output=True, text=True)
    peak = int(run.stdout) / 1024
    yield Row("peak memory of 2000 episodes", f"{peak:.0f} MB", "", f"<= {MEGABYTES} MB", peak <= MEGABYTES)


def _beside_the_floor(world: floor.Tables, what: str, episodes: int, step: str) -> Row:
    """The floor and the real system take turns, so that both meet the same machine."""
    times = []
    for seed in SEEDS:
        least, _ = timed(partial(floor.train, world, episodes, seed, second_order=step == "second-order"))
        times.append((least, timed(partial(learn, seed, episodes, step))[0]))
    ratio = median(real / least for least, real in times)
    least, real = (median(column) for column in zip(*times, strict=True))
    compared = f"{ratio:.1f} times the NumPy floor ({least:.2f} s)"
    return Row(what, f"{real:.2f} s", compared, f"<= {TIMES} times", ratio <= TIMES)


def _peak() -> int:
    """The most memory that this process has held, in KiB.

    Linux hands getrusage's figure on from the process that started this one; /proc has this one's own.
    """
    status = Path("/proc/self/status")
    if status.exists():
        return next(int(line.split()[1]) for line in status.read_text().splitlines() if line.startswith("VmHWM"))
    import resource

    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak // 1024 if sys.platform == "darwin" else peak


if __name__ == "__main__":
    learn(0)
    print(_peak())
