"""Figure 2: success by the minimal solution length."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from nppg.experiments.figures.common import grouped, moments
from nppg.experiments.reproduce import Job


def rows(finished: Sequence[Job]) -> list[dict]:
    """For each test and minimal solution length the mean and the standard deviation over the runs."""
    tests_by: dict[tuple[int, int], list[dict[str, float]]] = {}
    for job in finished:
        for test in job.tests():
            tests_by.setdefault((job.due(test["episode"]), int(test["length"])), []).append(test)
    found = []
    for (episode, length), tests in sorted(tests_by.items()):
        row: dict = {"episode": episode, "length": length, "share": tests[0]["share"], "runs": len(tests)}
        drawn = [each["succeeded"] / each["drawn"] for each in tests if each["drawn"]]
        found.append(row | (moments("sampled", drawn or [0.0])) | moments("exact", [each["exact"] for each in tests]))
    return found


def _shown(rows: list[dict]) -> list[int]:
    """Six episodes to look at, from the beginning to the end."""
    known = sorted({row["episode"] for row in rows})
    return sorted({known[(len(known) - 1) * part // 5] for part in range(6)})


def draw(rows: list[dict], path: Path) -> None:
    from matplotlib import pyplot

    figure, (axes, below) = pyplot.subplots(
        2, 1, figsize=(9, 6), layout="constrained", sharex=True, height_ratios=(4, 1)
    )
    by_episode = grouped(rows, lambda row: row["episode"])
    shown = _shown(rows)
    colours = pyplot.get_cmap("viridis")
    for number, episode in enumerate(shown):
        own = by_episode[episode]
        colour = colours(0.9 * number / max(len(shown) - 1, 1))
        lengths, middle = [row["length"] for row in own], [row["exact_mean"] for row in own]
        low, high = ([row["exact_mean"] + sign * row["exact_sd"] for row in own] for sign in (-1, 1))
        axes.plot(lengths, middle, "o-", color=colour, markersize=3, label=f"{episode} episodes")
        axes.fill_between(lengths, low, high, color=colour, alpha=0.15, linewidth=0)
    axes.set(ylabel=f"exact success, mean of {rows[0]['runs']} runs", ylim=(-0.02, 1.02))
    axes.legend(loc="center left", bbox_to_anchor=(1, 0.5), frameon=False)
    own = by_episode[shown[0]]
    below.bar([row["length"] for row in own], [100 * row["share"] for row in own], color="grey")
    below.set(xlabel="minimal solution length", ylabel="% of starts", xticks=[row["length"] for row in own])
    for each in (axes, below):
        each.grid(alpha=0.3)
    figure.savefig(path, format="png", dpi=120)
    pyplot.close(figure)


def tell(rows: list[dict], finished: Sequence[Job]) -> list[str]:
    by_episode = grouped(rows, lambda row: row["episode"])
    shown = _shown(rows)
    lengths = [row["length"] for row in by_episode[shown[0]]]
    table = [
        "| " + " | ".join([str(episode), *(f"{row['exact_mean']:.3f}" for row in by_episode[episode])]) + " |"
        for episode in shown
    ]
    shares = [f"{100 * row['share']:.2f} %" for row in by_episode[shown[0]]]
    return [
        f"Exact success of TREENPPG's stochastic policy by the minimal number of moves, mean of {len(finished)} runs:",
        "",
        "| episodes | " + " | ".join(map(str, lengths)) + " |",
        "|---" * (len(lengths) + 1) + "|",
        *table,
        "| " + " | ".join(["share of the starts", *shares]) + " |",
    ]
