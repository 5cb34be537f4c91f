"""The tables of docs/ipc2023, written from results."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from pathlib import Path
from statistics import mean

from benchmarks.common import splice
from benchmarks.ipc2023.lama import PART
from benchmarks.ipc2023.policies import DISTILL, LEARN, MODELS
from benchmarks.ipc2023.results import KEY, Results
from benchmarks.ipc2023.scores import Score, scores
from benchmarks.ipc2023.tasks import DOMAINS, LEVELS, references

FOLDER = Path("docs/ipc2023")
ACTING = {**dict.fromkeys(MODELS), PART: None}  # who acts, in the order of the columns
TITLES = {"levin": "Levin", PART: "LAMA"}
_TURNED = "solved without turning"
_DOES = (*LEVELS, "quality", "cost / LAMA's", "all problems, s", "longest, s", "the others ended by")
AIMS = {  # of 60: solved, quality
    "ferry": (60, 58), "miconic": (60, 58), "spanner": (60, 57), "blocksworld": (60, 58), "childsnack": (55, 50),
    "satellite": (55, 50), "transport": (45, 35), "rovers": (40, 35),
}  # fmt: skip


def write(data: Path, results: Results, folder: Path = FOLDER) -> None:
    """Puts the tables between their markers in README.md, and beside it all results, in one file."""
    known = list(references(data))
    found = {part: {domain: scores(results, known, part, domain) for domain in DOMAINS} for part in ACTING}
    tables = {"quality": _qualities(found), "policies": _policies(results, found), "lama": _lama(found[PART])}
    tables["rules"], tables["levin"] = _rules(results, found), _levin(found)
    for name, lines in tables.items():
        splice(folder / "README.md", name, "\n".join(lines))
    ordered = sorted(results.lines.values(), key=lambda line: [str(line.get(name, "")) for name in KEY])
    (folder / "results.jsonl").write_text("".join(f"{json.dumps(line)}\n" for line in ordered))


Found = dict[str, dict[str, dict[object, Score]]]


def _qualities(found: Found) -> Iterator[str]:
    """Each domain's, the mean over the seeds, and the sum over the domains."""
    titles = [f"{TITLES.get(part, part)}: {what}" for part in ACTING for what in ("solved", "quality")]
    yield from _head(["domain", "aim: solved", "quality", *titles])
    sums: dict[str, list[tuple[float, float]]] = {part: [] for part in ACTING}
    for domain in DOMAINS:
        cells = [domain, *map(str, AIMS.get(domain, ("", "")))]
        for part in ACTING:
            own = found[part][domain].values()
            if own:
                sums[part].append((mean(each.solved() for each in own), mean(each.quality for each in own)))
            cells += [_number(each) for each in sums[part][-1]] if own else ["", ""]
        yield _row(cells)
    cells = ["all", "", ""]
    for part in ACTING:
        own = f" (of {len(sums[part])})" if len(sums[part]) < len(DOMAINS) else ""
        cells += [f"**{_number(sum(column))}**{own}" for column in zip(*sums[part], strict=True)] or ["", ""]
    yield _row(cells)


def _policies(results: Results, found: Found) -> Iterator[str]:
    """Each domain and seed: how the policy was learned, and how it does."""
    yield from _head(["domain", "seed", "learned in, s", "episodes", "trees", _TURNED, *_DOES])
    for domain in DOMAINS:
        for seed, score in found["policy"][domain].items():
            learned = results.get(part=LEARN, domain=domain, seed=seed) or {}
            cells = [_cell(learned.get(name)) for name in ("seconds", "episodes", "trees")]
            yield _row([domain, str(seed), *cells, str(score.straight), *_does(score, found[PART][domain])])


def _rules(results: Results, found: Found) -> Iterator[str]:
    """Likewise of the rules."""
    yield from _head(["domain", "seed", "distilled in, s", "rules", _TURNED, *_DOES])
    for domain in DOMAINS:
        for seed in found["policy"][domain]:
            if distilled := results.get(part=DISTILL, domain=domain, seed=seed):
                cells = [_cell(distilled["seconds"]), _cell(distilled["rules"] or distilled["ended"])]
                score = found["rules"][domain].get(seed)
                does = [str(score.straight), *_does(score, found[PART][domain])] if score else [""] * (1 + len(_DOES))
                yield _row([domain, str(seed), *cells, *does])


def _levin(found: Found) -> Iterator[str]:
    yield from _head(["domain", "seed", *_DOES])
    for domain in DOMAINS:
        for seed, score in found["levin"][domain].items():
            yield _row([domain, str(seed), *_does(score, found[PART][domain])])


def _lama(found: dict[str, dict[object, Score]]) -> Iterator[str]:
    yield from _head(["domain", *_DOES])
    for domain in DOMAINS:
        for score in found[domain].values():
            yield _row([domain, *_does(score, found[domain])])


def _does(score: Score, planner: dict[object, Score]) -> list[str]:
    """How somebody does, beside LAMA."""
    against = score.cost_against(planner[None]) if planner else None
    return [
        *(_share(score, level) for level in LEVELS),
        _number(score.quality),
        "" if against is None else f"{against:.2f}",
        f"{sum(score.seconds):.0f}",
        f"{max(score.seconds):.1f}",
        ", ".join(f"{count} {ended}" for ended, count in score.failures.most_common()),
    ]


def _share(score: Score, level: str | None = None) -> str:
    return f"{score.solved(level)} of {len(score.of(level))}"


def _number(value: float) -> str:
    return f"{value:.1f}".removesuffix(".0")


def _cell(value: object) -> str:
    return f"{value:.0f}" if isinstance(value, float) else "" if value is None else str(value)


def _head(titles: Sequence[str]) -> list[str]:
    return [_row(titles), "|---" * len(titles) + "|"]


def _row(cells: Sequence[str]) -> str:
    return f"| {' | '.join(cells)} |"
