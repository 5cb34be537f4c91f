"""What nppg learns from a domain's training problems, and how that does on its testing problems.

Everything is a command that a user could give, in a process of its own with the limits of time and memory.
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Sequence
from pathlib import Path

from benchmarks.ipc2023.processes import TIME, Ended, run
from benchmarks.ipc2023.results import Line
from benchmarks.ipc2023.tasks import SOLVED, Setting, Task
from nppg.errors import NppgError
from nppg.experiments import checkpoints

LEARN, DISTILL = "learn", "distill"
MODELS = {"policy": "model.pl", "rules": "rules.pl", "levin": "model.pl"}  # what acts, by the part that judges it
_SEARCH = {"levin": ("--search", "levin", "--budget", str(10**9))}  # the seconds end it
_ACTS = ("--no-revisits",)  # how policies act, and rules are judged
_RULE = re.compile(r"^delta\(1, ", re.MULTILINE)


def learn(setting: Setting, domain: str, seed: int) -> None:
    """Trains with the options of the domain's own generated bias, in one process; goes on where it was stopped."""
    key = {"part": LEARN, "domain": domain, "seed": seed}
    if setting.results.has(**key):
        return
    folder, problems = setting.folder(domain, seed), map(str, setting.training(domain))
    command = ["train", f"{domain}/domain.pddl", "--seed", str(seed), "--seconds", str(setting.learn_seconds)]
    new = [*command, "--evaluate-every", "0", "--output", str(folder), "--problems", *problems]
    before = _seconds_before(folder, setting.learn_seconds)
    done = run(_nppg(*(["train", "--resume", str(folder)] if before else new), "--jobs", "1"), setting.data)
    if done.status != 0:
        raise RuntimeError(f"learning {domain}, seed {seed}: {done.errors[-2000:]}")
    summary = json.loads((folder / "run.json").read_text())
    line = setting.results.add(
        {
            **key,
            **{name: summary[name] for name in ("seconds", "episodes", "trees", "leaves")},
            "processor": before + done.seconds,
            "limit": setting.learn_seconds,
            "bytes": (folder / MODELS["policy"]).stat().st_size,
            "command": " ".join(["nppg", *command, "--problems", f"{domain}/training/*/*.pddl"]),
        }
    )
    print(*key.values(), line["episodes"], "episodes", line["trees"], "trees", line["seconds"], flush=True)


def _seconds_before(folder: Path, limit: int) -> float:
    """How long the run of a folder had learned when it was stopped, 0 where there is none that is to end there."""
    try:
        found = checkpoints.last(folder).run
    except NppgError:
        return 0.0
    seconds: float = found["seconds"]
    return seconds if seconds < limit == found["settings"]["curve"].get("seconds") else 0.0


def distill(setting: Setting, domain: str, seed: int) -> None:
    """A list of few rules for the policy that was learned."""
    key = {"part": DISTILL, "domain": domain, "seed": seed}
    folder = setting.folder(domain, seed)
    if setting.results.has(**key) or not (folder / MODELS["policy"]).exists():
        return
    command = _nppg("distill", MODELS["policy"], *_ACTS, "--seconds", str(setting.distill_seconds))
    done = run(command, folder, 2 * setting.distill_seconds + 60, setting.gigabytes)
    if done.is_mistaken:
        _tell(key, done)
        return
    rules = _RULE.findall((folder / MODELS["rules"]).read_text()) if done.status == 0 else []
    line = setting.results.add({**key, "seconds": done.seconds, "rules": len(rules) or None, "ended": done.stopped})
    print(*key.values(), line["rules"], "rules", line["seconds"], done.stopped or "", flush=True)


def act(setting: Setting, part: str, domain: str, seed: int) -> None:
    """Has the policy, or its rules, act on each problem that has no result yet."""
    folder = setting.folder(domain, seed)
    how = _SEARCH.get(part, ("--horizon-factor", "2", *_ACTS))
    command = _nppg("evaluate", MODELS[part], "--json", "--seconds", str(setting.seconds), *how)

    def attempt(task: Task, key: Line) -> Line | None:
        done = run([*command, "--problems", str(task.path)], folder, setting.seconds + 5, setting.gigabytes)
        if done.is_mistaken:
            _tell(key, done)
            return None
        return attempted(done, setting.seconds)

    if (folder / MODELS[part]).exists():
        setting.attempt_all(part, domain, attempt, seed=seed)


def attempted(done: Ended, seconds: int) -> Line:
    """What came of a command that evaluates a model on one problem, where it is no mistake. Reading model and problem
    counts, too: `processor` has all the seconds that it took, `seconds` those of acting."""
    if done.status == 0:
        (found,) = json.loads(done.output)["list"]
        ended = found["ended"] if done.seconds <= seconds else TIME
    else:
        found, ended = {}, done.stopped
    solved = ended == SOLVED
    return {
        "solved": solved,
        "ended": ended,
        "cost": found["cost"] if solved else None,
        **{name: found[name] for name in ("steps", "avoided") if name in found},
        "seconds": found.get("seconds"),
        "processor": done.seconds,
    }


def _tell(key: Line, done: Ended) -> None:
    """A mistake is no result, so that the next time it is done again."""
    print(*key.values(), f"not recorded: {done.last}", file=sys.stderr, flush=True)


def _nppg(*arguments: str) -> Sequence[str]:
    return [sys.executable, "-m", "nppg", *arguments]
