"""A training run with the paper's settings, 2000 episodes without evaluation: its time, and its memory."""

from __future__ import annotations

import subprocess
import sys
from collections import deque
from collections.abc import Iterator
from functools import partial
from statistics import median

from benchmarks import floor
from benchmarks.common import Row, peak, timed
from nppg import Domain, LanguageBias, Options, Policy, train
from nppg.bridge.files import locate
from nppg.learning.options import Common

SEEDS = range(3)
TIMES = 4.5
MEGABYTES = 300


def learn(options: Common) -> Policy:
    domain = Domain("blocks_world")
    bias = LanguageBias.load(locate("blocks_world", "language_bias", ".yaml"))
    return deque(train(domain, bias, options), maxlen=1)[0].policy


def rows() -> Iterator[Row]:
    """The floor and the real system take turns, so that both meet the same machine."""
    world = floor.tables()
    for what, episodes, step in (("training", 2000, "gradient"), ("second-order training", 500, "second-order")):
        least, real = zip(*(_pair(world, Options(episodes, seed, step=step)) for seed in SEEDS), strict=True)
        ratio = median(r / f for f, r in zip(least, real, strict=True))
        yield Row(
            f"{what}, {episodes} episodes",
            f"{median(real):.2f} s",
            f"{ratio:.1f} times the NumPy floor ({median(least):.2f} s)",
            f"<= {TIMES} times",
            ratio <= TIMES,
        )
    run = subprocess.run([sys.executable, "-m", __name__], check=True, capture_output=True, text=True)
    peak = int(run.stdout) / 1024
    yield Row("peak memory of training, 2000 episodes", f"{peak:.0f} MB", "", f"<= {MEGABYTES} MB", peak <= MEGABYTES)


def _pair(world: floor.Tables, options: Options) -> tuple[float, float]:
    second = options.step == "second-order"
    least, _ = timed(partial(floor.train, world, options.episodes, options.seed, second_order=second))
    return least, timed(partial(learn, options))[0]


if __name__ == "__main__":
    learn(Options())
    print(peak())
