"""What a training run shows while it goes."""

from __future__ import annotations

import json
import math
import sys
from collections.abc import Callable
from dataclasses import asdict

from nppg.experiments.progress import Point, Progress, sizes
from nppg.learning.options import Common

ENDLESS = 10**9  # episodes of a run that only its seconds end


def reporter(options: Common) -> Callable[[Progress], None]:
    """A progress bar on a terminal with tqdm, plain lines elsewhere."""

    bar = None
    if sys.stderr.isatty():
        try:
            from tqdm import tqdm
        except ImportError:
            pass
        else:
            total = options.episodes if options.episodes < ENDLESS else None
            bar = tqdm(total=total, unit="episode", dynamic_ncols=True)

    def show(progress: Progress) -> None:
        point = progress.point
        if bar is not None:
            bar.update(progress.episodes - bar.n)
            stage = {"problems": progress.stage} if progress.stage else {}
            bar.set_postfix(progress.policy.sizes(), lately=f"{progress.recent:.2f}", **stage)
            if progress.ended:
                bar.close()
        elif point is not None:
            stochastic, greedy = progress.judged(point)
            print(
                f"episode {point.episode:5d}  {sizes(progress.policy, point)}  {progress.measure} {stochastic:.4f} "
                f"(greedy {greedy:.4f})  {_returns(progress, point)}{_stage(progress)}{point.seconds:.1f} s",
                flush=True,
            )

    return show


def lines_of_json(options: Common) -> Callable[[Progress], None]:
    """Each point of the curve as one line of JSON, for other programs to read."""

    def show(progress: Progress) -> None:
        if progress.point is not None:
            domain = {"domain": progress.policy.domain.name, "seed": options.seed, "measure": progress.measure}
            print(json.dumps(domain | asdict(progress.point)), flush=True)

    return show


REPORTERS = {"text": reporter, "jsonl": lines_of_json}


def _returns(progress: Progress, point: Point) -> str:
    """What a point's line says of returns, where success is the measure and does not tell them."""
    if progress.measure == "return" or point.mean_return is None or math.isclose(point.mean_return, point.success):
        return ""
    return f"return {point.mean_return:.2f} (greedy {point.greedy_return:.2f})  "


def _stage(progress: Progress) -> str:
    return f"problems {progress.stage}  " if progress.stage else ""
