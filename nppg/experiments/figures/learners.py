"""Figure 1: the success of several learners by episodes."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from statistics import mean

from nppg.experiments.figures.common import grouped, moments
from nppg.experiments.reproduce import Job

NAMES = {"nppg": "TREENPPG", "tg": "RRL-TG", "rib": "RRL-RIB", "trendi": "RRL-TRENDI"}
_SIZES = ("trees", "leaves", "instances")


def _by_learner(finished: Sequence[Job]) -> dict[str, list[Job]]:
    return grouped(finished, lambda job: job.options.learner)


def rows(finished: Sequence[Job]) -> list[dict]:
    """For each learner and test the mean and the standard deviation over the runs."""
    found_rows = []
    for learner, own in _by_learner(finished).items():
        found: dict[int, list[dict]] = {}
        for job in own:
            sampled: dict[int, list] = grouped(job.tests(), lambda test: test["episode"])
            points = {job.due(float(point["episode"])): point for point in job.curve()}
            for episode, point in points.items():
                tests = sampled[int(point["episode"])]
                share = sum(each["succeeded"] for each in tests) / sum(each["drawn"] for each in tests)
                found.setdefault(episode, []).append(
                    {"sampled": share} | {key: float(x) for key, x in point.items() if x}
                )
        for episode, points_here in sorted(found.items()):
            row: dict = {"learner": learner, "episode": episode, "runs": len(points_here)}
            row |= moments("sampled", [each["sampled"] for each in points_here])
            row |= moments("exact", [each["success"] for each in points_here])
            found_rows.append(row | {size: mean(each[size] for each in points_here) for size in (*_SIZES, "seconds")})
    return found_rows


def draw(rows: list[dict], path: Path) -> None:
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(9, 5), layout="constrained")
    for number, (learner, own) in enumerate(grouped(rows, lambda row: row["learner"]).items()):
        episodes = [row["episode"] for row in own]
        middle = [row["sampled_mean"] for row in own]
        low, high = ([row["sampled_mean"] + sign * row["sampled_sd"] for row in own] for sign in (-1, 1))
        axes.plot(episodes, middle, color=f"C{number}", label=NAMES[learner])
        axes.plot(episodes, [row["exact_mean"] for row in own], ":", color=f"C{number}")
        axes.fill_between(episodes, low, high, color=f"C{number}", alpha=0.15, linewidth=0)
    axes.plot([], [], ":", color="grey", label="exact, over all start states")
    label = f"success: mean and standard deviation of {rows[0]['runs']} runs"
    axes.set(xlabel="episodes", ylabel=label, ylim=(-0.02, 1.02))
    axes.grid(alpha=0.3)
    axes.legend(loc="center left", bbox_to_anchor=(1, 0.5), frameon=False)
    figure.savefig(path, format="png", dpi=120)
    pyplot.close(figure)


def tell(rows: list[dict], finished: Sequence[Job]) -> list[str]:
    lines = [
        "Success of TREENPPG's stochastic policy and of the value functions' greedy policies: on sampled starts, the "
        "same for all, and exactly, over all start states; standard deviations over the runs.",
        "",
        "| learner | sampled, at the end | exact, at the end | worst run | 0.5 reached | 0.9 reached "
        "| largest sd | size at the end | seconds a run |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    by_learner = _by_learner(finished)
    for learner, own in grouped(rows, lambda row: row["learner"]).items():
        last = own[-1]
        worst = min(float(job.curve()[-1]["success"]) for job in by_learner[learner])
        size = ", ".join(f"{last[key]:.0f} {key}" for key in _SIZES if last[key])
        lines.append(
            f"| {NAMES[learner]} | {last['sampled_mean']:.3f} ± {last['sampled_sd']:.3f} "
            f"| {last['exact_mean']:.4f} ± {last['exact_sd']:.4f} | {worst:.4f} | {_reached(own, 0.5)} "
            f"| {_reached(own, 0.9)} | {max(row['exact_sd'] for row in own):.3f} | {size} | {last['seconds']:.0f} |"
        )
    return [
        *lines,
        "",
        "“Reached”: the first test where the exact mean is so high. “Largest sd”: of the exact success, at any test. "
        "Seconds are those of learning; tests come on top.",
    ]


def _reached(rows: list[dict], level: float) -> str:
    return next((str(row["episode"]) for row in rows if row["exact_mean"] >= level), "never")
