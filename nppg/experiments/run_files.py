"""The files of a run: model.pl, run.json, curve.csv and, with matplotlib, curve.png; and copies of its inputs."""

from __future__ import annotations

import csv
import json
import warnings
from collections.abc import Mapping
from dataclasses import asdict, fields
from pathlib import Path
from typing import Any

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.files import replacing, sha256
from nppg.bridge.interrupts import undisturbed
from nppg.bridge.seals import object_in, opened, sealed
from nppg.errors import NppgError, Problem
from nppg.experiments import drawing
from nppg.experiments.progress import Judging, Point, Progress, sizes, title
from nppg.experiments.versions import versions
from nppg.learning.options import Common
from nppg.policy.copies import CHECKPOINT, conflicts, write_copies
from nppg.policy.model import write_model
from nppg.worlds.domain import Domain
from nppg.worlds.problems import BESIDE

FILES = ("model.pl", "run.json", "curve.csv", "curve.png")


def in_the_way(copies: Mapping[str, bytes], output: Path) -> list[Problem]:
    """What stands in the way of the files and of these copies, in the folder `output`."""
    return list(conflicts(output, copies, (*FILES, CHECKPOINT)).values())


def copies_of(domain: Domain, bias: LanguageBias) -> dict[str, bytes]:
    """The contents of the input files, by name; a bias made in Python has none."""
    copies = {domain.path.name: domain.source, **domain.companions}
    return copies | {Path(bias.file).name: bias.source} if bias.source else copies


def settings(domain: Domain, bias: LanguageBias, options: Common, judging: Judging | None = None) -> dict[str, Any]:
    """What a run depends on, as run.json tells it; without `judging`, what its policy does."""
    curve = {} if judging is None else {"curve": dict(judging)}
    return {
        "domain": {"file": domain.path.name, "sha256": domain.hash, "parameters": domain.parameters},
        "bias": {"file": Path(bias.file).name, "sha256": bias.hash} if bias.source else None,
        "beside": [{"file": name, "sha256": sha256(source)} for name, source in domain.companions.items()],
        "learner": options.learner,
        "options": asdict(options),
        "tree": asdict(bias.tree),
        **curve,
    }


def summary_of(output: Path) -> dict[str, Any]:
    """What run.json says. Raises NppgError where it is not there as a run has written it."""
    path, wrong = output / "run.json", "is no run.json of nppg, or was cut off"
    return opened(path, lambda content: object_in(path, content, "episodes", wrong))


def is_finished(output: Path, wanted: Mapping[str, Any]) -> bool:
    """Whether a folder holds the model and the curve of a run with these settings that came to its end. Warns where
    its run.json is damaged."""
    if not (output / "run.json").exists():
        return False
    try:
        summary = summary_of(output)
        last, judging = summary["last"] or {}, summary["curve"]
        alike = all(summary[name] == value for name, value in json.loads(json.dumps(wanted)).items())
        ended = summary["episodes"] == summary["options"]["episodes"] or any_reached(
            (last.get("success"), judging["until_success"]),
            (last.get("mean_return"), judging["until_return"]),
            (summary["seconds"], judging.get("seconds")),
        )
    except NppgError as error:
        warnings.warn(f"{error}; the run is done again", stacklevel=3)
        return False
    except (ValueError, KeyError, TypeError):
        return False
    return alike and ended and all((output / name).is_file() for name in FILES[: 3 if last else 2])


def any_reached(*wanted: tuple[float | None, float | None]) -> bool:
    """Whether one of these values is as high as it is to be."""
    return any(least is not None and value is not None and value >= least for value, least in wanted)


@undisturbed()
def write_files(
    progress: Progress,
    bias: LanguageBias,
    output: Path,
    copies: Mapping[str, bytes],
    earlier: Mapping[str, str],
    ended: bool = True,
) -> list[str]:
    """Writes all files of a run, each under a temporary name first, with `copies` of its inputs, and removes the curve
    of an `earlier` one, of which the hashes of inputs were recorded; before it has `ended` no picture. Returns their
    names. Raises NppgError at the end where a file has come into the way of a copy since the run began."""
    policy, options = progress.policy, progress.options
    domain = policy.domain
    problems = conflicts(output, copies, FILES)
    copies = {name: source for name, source in copies.items() if name not in problems}
    judging = progress.judging
    until = (judging["until_success"], judging["until_return"]) != (None, None) or "seconds" in judging
    facts = [
        *([("bias", Path(bias.file).name), ("bias_sha256", bias.hash)] if bias.source else []),
        *(("option", ("=", name, value)) for name, value in asdict(options).items()),
        *(("tree", ("=", name, value)) for name, value in asdict(bias.tree).items()),
        *(("curve", ("=", name, value)) for name, value in judging.items() if until and value is not None),
        ("trained_episodes", progress.episodes),
    ]
    for name in {name for name in earlier if name.endswith(BESIDE)} - set(copies) - set(problems):
        if (output / name).is_file() and sha256((output / name).read_bytes()) == earlier[name]:
            (output / name).unlink()  # the problems of an earlier run, which would be taken for this one's
    write_copies(output, copies)
    write_model(policy, output / "model.pl", facts)
    summary = {
        **versions(),
        "trust": domain.trusted,
        **settings(domain, bias, options, judging),
        "episodes": progress.episodes,
        **policy.sizes(),
        "seconds": round(progress.seconds, 3),
        "last": asdict(progress.curve[-1]) if progress.curve else None,
    }
    written = [*copies, "model.pl", "run.json"]
    if progress.curve:
        replacing(output / "curve.csv", lambda path: _write_curve(path, progress.curve))
        written.append("curve.csv")
        if ended and _draw(progress, output / "curve.png"):
            written.append("curve.png")
    text = json.dumps(summary, indent=2) + "\n"
    replacing(output / "run.json", lambda path: path.write_bytes(sealed(text.encode())))
    for name in set(FILES) - set(written) if earlier else ():
        (output / name).unlink(missing_ok=True)
    if problems:
        raise NppgError(problems.values())
    return sorted(written)


def _write_curve(path: Path, curve: list[Point]) -> None:
    with path.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow([each.name for each in fields(Point)])
        writer.writerows([getattr(point, each.name) for each in fields(Point)] for point in curve)


def _draw(progress: Progress, path: Path) -> bool:
    """Whether matplotlib is there to draw the curve."""
    pyplot = drawing.pyplot()
    if pyplot is None:
        return False
    figure, axes = pyplot.subplots(figsize=(9, 4), layout="constrained")
    episodes = [point.episode for point in progress.curve]
    exact = "exact" if progress.curve[-1].exact else "sampled"
    stochastic, greedy = zip(*map(progress.judged, progress.curve), strict=True)
    axes.plot(episodes, stochastic, label=f"stochastic policy, {exact}")
    axes.plot(episodes, greedy, label=f"greedy policy, {exact}", alpha=0.6)
    played = [point for point in progress.curve if point.episode]
    lately = [point.episode for point in played], [point.recent for point in played]
    axes.plot(*lately, ":", label="recent training episodes", color="grey")
    drawing.save_curve(figure, axes, progress.measure, _title(progress), path)
    pyplot.close(figure)
    return True


def _title(progress: Progress) -> str:
    options = progress.options
    return f"{title(progress.policy.domain)}, {options.learner}, seed {options.seed}: {sizes(progress.policy)}"
