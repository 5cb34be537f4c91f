"""Figure 3: the probability of going left in the corridor, by position, for growing numbers of iterations."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from statistics import mean, pstdev

import numpy as np

from nppg.experiments.corridor import Corridor
from nppg.experiments.figures.common import grouped, moments
from nppg.experiments.reproduce import Job

_METHODS = {"paper": "the paper's step", "critic": "second-order with critic"}
_LEARNERS = {"cart": "CART", "tilde": "TILDE"}


def rows(finished: Sequence[Job]) -> list[dict]:
    """For each variant, iteration and position the moments of the probability of going left and of the return."""
    found = []
    for own in grouped(finished, lambda job: job.variant.name).values():
        noise = {name: own[0].domain.parameters[name] for name in ("noise_mean", "noise_sd")}
        method, regressor, _ = own[0].variant.name.split("-")
        variant = {
            "method": method,
            "regressor": regressor,
            **noise,
            "switch": Corridor(own[0].domain).optimum().switch,
        }
        tests = (test for job in own for test in job.tests())
        for (iteration, position), here in sorted(grouped(tests, _place).items()):
            row: dict = {**variant, "iteration": int(iteration), "position": position, "runs": len(here)}
            row |= moments("left", [each["left"] for each in here])
            found.append(row | moments("return", [each["value"] for each in here]))
    return found


def _place(test: dict[str, float]) -> tuple[float, float]:
    return test["iteration"], test["position"]


def draw(rows: list[dict], path: Path) -> None:
    """A panel for each variant, a line for each number of iterations."""
    from matplotlib import pyplot

    variants = grouped(rows, _title)
    figure, panels = pyplot.subplots(
        len(variants) // 2, 2, figsize=(11, 11), layout="constrained", sharex=True, sharey=True, squeeze=False
    )
    colours = pyplot.get_cmap("viridis")
    for axes, (title, own) in zip(panels.ravel(), variants.items(), strict=True):
        by_iteration = grouped(own, lambda row: row["iteration"])
        for number, (iteration, here) in enumerate(by_iteration.items()):
            colour = colours(0.9 * number / max(len(by_iteration) - 1, 1))
            positions, middle = [row["position"] for row in here], np.array([row["left_mean"] for row in here])
            spread = np.array([row["left_sd"] for row in here])
            label = f"{iteration} iteration{'s' if iteration > 1 else ''}"
            axes.plot(positions, middle, color=colour, label=label)
            axes.fill_between(positions, middle - spread, middle + spread, color=colour, alpha=0.12, linewidth=0)
        switch = own[0]["switch"]
        axes.plot([0, switch, switch, positions[-1] + positions[0]], [1, 1, 0, 0], "k--", label="optimal")
        axes.set(title=title, ylim=(-0.05, 1.05))
        axes.grid(alpha=0.3)
    for axes in panels[-1]:
        axes.set_xlabel("position")
    for axes in panels[:, 0]:
        axes.set_ylabel(f"probability of going left\nmean and sd of {rows[0]['runs']} runs")
    figure.legend(*panels[0, 0].get_legend_handles_labels(), loc="outside right center", frameon=False)
    figure.savefig(path, format="png", dpi=120)
    pyplot.close(figure)


def tell(rows: list[dict], finished: Sequence[Job]) -> list[str]:
    """A line for each variant."""
    lines = [
        "The position; 30 episodes an iteration from uniform starts, a tree after each, step size 0.7, with "
        "the paper's step and returns, and with second-order steps and advantages over a value function. The optimal "
        "policy goes left up to the switch and right behind it. A run's switch is the position that parts best where "
        "its policy rather goes left from where it rather goes right. Returns are expected ones, from uniform starts, "
        "computed over cells of the corridor, like the optimal return.",
        "",
        "| learner, noise | optimal switch | switch after the last iteration | wrong side | optimal return "
        "| return | random walk | seconds a run |",
        "|---|---|---|---|---|---|---|---|",
    ]
    by_variant = grouped(finished, lambda job: job.variant.name).values()
    for (title, own_rows), own in zip(grouped(rows, _title).items(), by_variant, strict=True):
        cells = Corridor(own[0].domain)
        best = cells.optimum()
        last = own_rows[-1]["iteration"]
        ends = [[test for test in job.tests() if test["iteration"] == last] for job in own]
        switches, wrong = zip(*(_switch(end) for end in ends), strict=True)
        returns = [mean(test["value"] for test in end) for end in ends]
        walk = cells.values(np.full(len(cells.centres), 0.5)).mean()
        seconds = mean(job.summary()["seconds"] for job in own)
        lines.append(
            f"| {title} | {best.switch:.2f} | {mean(switches):.2f} ± {pstdev(switches):.2f} "
            f"| {100 * mean(wrong):.1f} % | {best.mean:.2f} | {mean(returns):.2f} ± {pstdev(returns):.2f} "
            f"| {walk:.2f} | {seconds:.1f} |"
        )
    return [
        *lines,
        "",
        "± is the standard deviation over the runs. Wrong side: the share of positions, on the average run, where the "
        "policy rather goes the way that the run's own switch does not explain. Seconds are those of learning.",
        "",
        "Return by iterations:",
        "",
        *_by_iteration(rows),
    ]


def _by_iteration(rows: list[dict]) -> list[str]:
    found = grouped(rows, _title)
    iterations = sorted({row["iteration"] for row in rows})
    table = [
        f"| {title} | "
        + " | ".join(f"{mean(r['return_mean'] for r in own if r['iteration'] == i):.2f}" for i in iterations)
        + " |"
        for title, own in found.items()
    ]
    return ["| iterations | " + " | ".join(map(str, iterations)) + " |", "|---" * (len(iterations) + 1) + "|", *table]


def _switch(end: list[dict[str, float]]) -> tuple[float, float]:
    """The position that best parts left from right, and the share of cells that it explains wrongly."""
    left = np.array([test["left"] > 0.5 for test in end])
    wrong = np.concatenate([[0], np.cumsum(~left)]) + np.concatenate([np.cumsum(left[::-1])[::-1], [0]])
    best = int(np.argmin(wrong))
    width = 2 * end[0]["position"]
    return best * width, float(wrong[best] / len(left))


def _title(row: dict) -> str:
    return f"{_METHODS[row['method']]}, {_LEARNERS[row['regressor']]}, N({row['noise_mean']:g}, {row['noise_sd']:g})"
