"""What is proven of a policy, on the page: certificates that lie beside it, or a proof that is done now."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict
from html import escape
from pathlib import Path
from typing import Any

from nppg.bridge.seals import content_hash, is_whole
from nppg.bridge.terms import ground
from nppg.errors import NppgError
from nppg.policy.policy import Policy
from nppg.reports.page import note
from nppg.rules.problem_proof import prove_problems
from nppg.rules.proof import prove
from nppg.worlds.world import State

_CLASSES = 6  # that fail, drawn
_PROBLEMS = 200
_MOST = 64 * 2**20  # bytes of a certificate

Proof = Mapping[str, Any]  # as a certificate has it


def certificates(model: Path) -> list[Proof]:
    """Those beside a model that are about it as it is, and are as they were written."""
    found: list[Proof] = []
    for file in sorted(model.parent.glob("*.json")):
        try:
            if file.stat().st_size > _MOST or not is_whole(file):
                continue
            data = json.loads(file.read_text(encoding="utf-8"))
        except (OSError, ValueError, RecursionError):
            continue
        if isinstance(data, dict) and data.get("model_sha256") == content_hash(model):
            found.append(data)
    return found


def proof_of(policy: Policy, model: Path) -> Proof:
    """A proof done now. Raises NppgError where there can be none."""
    proof = prove_problems(policy, model) if policy.domain.chosen else prove(policy, model)
    return json.loads(json.dumps(asdict(proof)))


def proof_html(proof: Proof, draw: Callable[[State], int]) -> str:
    """What a proof says; `draw` gives the number of a drawn state. Raises NppgError for what is no certificate."""
    try:
        return _problems(proof) if "problems" in proof else _classes(proof, draw)
    except (KeyError, TypeError, ValueError, AttributeError):
        raise NppgError("a certificate beside the model is not what nppg prove writes: make it again") from None


def _classes(proof: Proof, draw: Callable[[State], int]) -> str:
    failures: Sequence[Mapping[str, Any]] = proof["failures"]
    kind = "greedy" if proof["greedy"] else "stochastic"
    if failures:
        verdict = f'<span class="verdict fails">succeeds with {float(proof["success"]):.9f}</span>'
    else:
        verdict = '<span class="verdict">succeeds from every start state</span>'
    parts = [
        f"<p>The {kind} policy {verdict}</p>",
        note(
            f"All {int(proof['states']):,} states were gone through, {int(proof['starts']):,} of them start states, in "
            f"{int(proof['classes']):,} classes of states that differ by names alone."
        ),
    ]
    if failures:
        parts.append(f"<h3>It can fail in {len(failures):,} classes</h3>")
        figures = []
        for failure in failures[:_CLASSES]:
            state = draw(tuple(ground(fact) for fact in failure["state"]))
            told = f"{int(failure['states']):,} states like this: succeeds with {float(failure['success']):.6f}"
            figures.append(f'<figure><div data-state="{state}"></div><figcaption>{told}</figcaption></figure>')
        parts.append(f'<div class="examples">{"".join(figures)}</div>')
        if len(failures) > _CLASSES:
            parts.append(f"<p>The {_CLASSES} that weigh most; nppg prove --show tells all.</p>")
    return "".join(parts)


def _problems(proof: Proof) -> str:
    problems: Sequence[Mapping[str, Any]] = proof["problems"]
    proven = sum(bool(each["certain"]) for each in problems)
    kind = "greedy" if proof["greedy"] else "stochastic"
    fails = "" if proven == len(problems) else " fails"
    rows = []
    for each in problems[:_PROBLEMS]:
        told = f"proven, in {each['longest']} steps at most" if each["certain"] else f"can fail; {each['success']:.6f}"
        trace = each.get("failure")
        more = ""
        if trace:
            steps = "\n".join(map(str, [*trace["way"], f"-- {trace['state']}", *trace["steps"]]))
            more = f"<details><summary>a run that fails</summary><pre>{escape(steps[:4000])}</pre></details>"
        rows.append(
            f"<tr><td>{escape(str(each['name']))}</td><td>{escape(told)}{more}</td><td>{int(each['states']):,}</td></tr>"
        )
    return (
        f'<p>The {kind} policy <span class="verdict{fails}">'
        f"succeeds for certain on {proven} of {len(problems)} problems"
        '</span></p><div class="table"><table><thead><tr><th>problem</th><th>verdict</th><th>states</th></tr></thead>'
        f"<tbody>{''.join(rows)}</tbody></table></div>"
    )
