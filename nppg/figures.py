"""The figures of an experiment: its numbers as CSV, its picture, a report in Markdown."""

from __future__ import annotations

import csv
import platform
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from statistics import mean, pstdev
from typing import Any

from nppg import __version__
from nppg.errors import NppgError
from nppg.model import replacing
from nppg.reproduce import EVERY, Job

NAMES = {"nppg": "TREENPPG", "tg": "RRL-TG", "rib": "RRL-RIB", "trendi": "RRL-TRENDI"}
_SIZES = ("trees", "leaves", "instances")


def write(name: str, finished: Sequence[Job], output: Path, command: str, seconds: float) -> list[Path]:
    """Writes NAME.csv, NAME.png and NAME.md from the finished runs. Returns their paths."""
    try:
        import matplotlib
    except ImportError:
        raise NppgError("the picture needs matplotlib: pip install 'nppg[plot]'") from None
    matplotlib.use("Agg")
    rows, draw, tell = {
        "figure1": (_by_episode, _draw_by_episode, _tell_by_episode),
        "figure2": (_by_length, _draw_by_length, _tell_by_length),
    }[name]
    found = rows(finished)
    paths = [output / f"{name}.{suffix}" for suffix in ("csv", "png", "md")]
    replacing(paths[0], lambda path: _write_csv(found, path))
    replacing(paths[1], lambda path: draw(found, path))
    text = [*_head(name, finished, command, seconds), *tell(found, finished), ""]
    replacing(paths[2], lambda path: path.write_text("\n".join(text)))
    return paths


def _head(name: str, finished: Sequence[Job], command: str, seconds: float) -> list[str]:
    summary = finished[0].summary()
    parameters = ", ".join(f"{key} = {value}" for key, value in summary["domain"]["parameters"].items())
    took = f"The runs not done before took {seconds / 60:.1f} minutes" if seconds else "All runs had been done before"
    return [
        f"# {name}",
        "",
        f"`{command}`",
        "",
        f"{summary['domain']['file']} ({parameters}); nppg {__version__}, Python {platform.python_version()}, "
        f"SWI-Prolog {summary['prolog']}, {platform.machine()}. {took}.",
        "",
        f"![{name}]({name}.png)",
        "",
    ]


def _write_csv(rows: list[dict], path: Path) -> None:
    with path.open("w", newline="") as file:
        writer = csv.DictWriter(file, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows({key: f"{x:.6f}" if isinstance(x, float) else x for key, x in row.items()} for row in rows)


def _at(episode: int) -> int:
    """The test that a point of the curve belongs to: policy gradients are tested with the next tree behind it."""
    return episode // EVERY * EVERY


def _grouped(rows: Iterable[Any], key: Callable) -> dict[Any, list]:
    found: dict[Any, list] = {}
    for row in rows:
        found.setdefault(key(row), []).append(row)
    return found


def _moments(name: str, values: Sequence[float]) -> dict[str, float]:
    return {f"{name}_mean": mean(values), f"{name}_sd": pstdev(values)}


def _by_learner(finished: Sequence[Job]) -> dict[str, list[Job]]:
    return _grouped(finished, lambda job: job.options.learner)


def _by_episode(finished: Sequence[Job]) -> list[dict]:
    """For each learner and test the mean and the standard deviation over the runs."""
    rows = []
    for learner, own in _by_learner(finished).items():
        found: dict[int, list[dict]] = {}
        for job in own:
            sampled: dict[int, list] = _grouped(job.tests(), lambda test: test.episode)
            points = {_at(int(point["episode"])): point for point in job.curve()}
            for at, point in points.items():
                tests = sampled[int(point["episode"])]
                share = sum(each.succeeded for each in tests) / sum(each.drawn for each in tests)
                found.setdefault(at, []).append({"sampled": share} | {key: float(x) for key, x in point.items() if x})
        for at, points_here in sorted(found.items()):
            row: dict = {"learner": learner, "episode": at, "runs": len(points_here)}
            row |= _moments("sampled", [each["sampled"] for each in points_here])
            row |= _moments("exact", [each["success"] for each in points_here])
            rows.append(row | {size: mean(each[size] for each in points_here) for size in (*_SIZES, "seconds")})
    return rows


def _draw_by_episode(rows: list[dict], path: Path) -> None:
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(9, 5), layout="constrained")
    for number, (learner, own) in enumerate(_grouped(rows, lambda row: row["learner"]).items()):
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


def _tell_by_episode(rows: list[dict], finished: Sequence[Job]) -> list[str]:
    lines = [
        "Success of TREENPPG's stochastic policy and of the value functions' greedy policies: on sampled starts, the "
        "same for all, and exactly, over all start states; standard deviations over the runs.",
        "",
        "| learner | sampled, at the end | exact, at the end | worst run | 0.5 reached | 0.9 reached "
        "| largest sd | size at the end | seconds a run |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    by_learner = _by_learner(finished)
    for learner, own in _grouped(rows, lambda row: row["learner"]).items():
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


def _by_length(finished: Sequence[Job]) -> list[dict]:
    """For each test and minimal solution length the mean and the standard deviation over the runs."""
    found = _grouped((test for job in finished for test in job.tests()), lambda test: (_at(test.episode), test.length))
    rows = []
    for (at, length), tests in sorted(found.items()):
        row: dict = {"episode": at, "length": length, "share": tests[0].share, "runs": len(tests)}
        drawn = [each.succeeded / each.drawn for each in tests if each.drawn]
        rows.append(row | (_moments("sampled", drawn or [0.0])) | _moments("exact", [each.exact for each in tests]))
    return rows


def _shown(rows: list[dict]) -> list[int]:
    """Six episodes to look at, from the beginning to the end."""
    last = rows[-1]["episode"]
    return sorted({_at(last * part // 5) for part in range(6)})


def _draw_by_length(rows: list[dict], path: Path) -> None:
    from matplotlib import pyplot

    figure, (axes, below) = pyplot.subplots(
        2, 1, figsize=(9, 6), layout="constrained", sharex=True, height_ratios=(4, 1)
    )
    by_episode = _grouped(rows, lambda row: row["episode"])
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


def _tell_by_length(rows: list[dict], finished: Sequence[Job]) -> list[str]:
    by_episode = _grouped(rows, lambda row: row["episode"])
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
