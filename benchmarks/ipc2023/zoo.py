"""The models that were learned, copied to where they stay, and the page about them."""

from __future__ import annotations

import json
import shutil
from collections.abc import Iterator, Sequence
from pathlib import Path

from benchmarks.common import splice
from benchmarks.ipc2023.policies import DISTILL, LEARN, MODELS
from benchmarks.ipc2023.scores import scores
from benchmarks.ipc2023.tasks import DOMAINS, Setting, references

FOLDER = Path("models")


def write(setting: Setting, seed: int, domains: Sequence[str] = DOMAINS, folder: Path = FOLDER) -> None:
    """Copies the models of these domains, learned with the seed, to folder/ipc2023, and puts the tables between their
    markers in folder/README.md."""
    there = [domain for domain in domains if setting.results.has(part=LEARN, domain=domain, seed=seed)]
    for domain in there:
        copied(setting.folder(domain, seed), folder / "ipc2023" / domain)
    splice(folder / "README.md", "ipc2023", "\n".join(_table(setting, seed, there, folder / "ipc2023")))
    splice(folder / "README.md", "rules", "\n".join(_rules(there, folder / "ipc2023")))


def copied(run: Path, folder: Path) -> None:
    """What it takes to act by a run's models, without its problems and its PDDL, which are the competition's."""
    summary = json.loads((run / "run.json").read_text())
    beside = [each["file"] for each in summary["beside"] if not each["file"].endswith(("_problems.pl", ".pddl"))]
    folder.mkdir(parents=True, exist_ok=True)
    for name in (summary["domain"]["file"], summary["bias"]["file"], *beside, *set(MODELS.values())):
        if (run / name).exists():
            shutil.copyfile(run / name, folder / name)


def _table(setting: Setting, seed: int, domains: Sequence[str], folder: Path) -> Iterator[str]:
    """How each was learned, and how many testing problems it solves."""
    results, known = setting.results, list(references(setting.data))
    yield "| domain | learned by | seconds | trees | KB | the policy solves | rules | they solve |"
    yield "|---" * 8 + "|"
    for domain in domains:
        learned = results.get(part=LEARN, domain=domain, seed=seed) or {}
        distilled = results.get(part=DISTILL, domain=domain, seed=seed) or {}
        size = sum(file.stat().st_size for file in (folder / domain).iterdir()) / 1000
        solved = []
        for part in ("policy", "rules"):
            score = scores(results, known, part, domain).get(seed)
            solved.append(f"{score.solved()} of {len(score.of())}, quality {score.quality:.1f}" if score else "")
        cells = [f"[{domain}](ipc2023/{domain})", f"`{learned['command']}`", f"{learned['seconds']:.0f}"]
        cells += [str(learned["trees"]), f"{size:.0f}", solved[0], str(distilled.get("rules") or ""), solved[1]]
        yield f"| {' | '.join(cells)} |"


def _rules(domains: Sequence[str], folder: Path) -> Iterator[str]:
    """The lists themselves."""
    for domain in domains:
        if (file := folder / domain / MODELS["rules"]).exists():
            yield from (f"**{domain}**", "", "```prolog", rules_of(file.read_text()), "```", "")


def rules_of(text: str) -> str:
    """The rules in the text of a model file."""
    return text.split("\n% tree 1: ", 1)[1].split("\n", 1)[1].strip()
