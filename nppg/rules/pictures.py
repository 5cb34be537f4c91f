"""The trees of a policy on a page of HTML, as pictures and as rules."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from nppg.bias.language_bias import LanguageBias
from nppg.policy.policy import Policy
from nppg.policy.sentences import sentences
from nppg.trees.tree import seen

_PAGE = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>{title}</title><style>
:root {{ color-scheme: light dark; }}
body {{ font: 16px/1.5 system-ui, sans-serif; margin: 2rem auto; padding: 0 1rem; max-width: 72rem; }}
figure {{ margin: 1rem 0; overflow-x: auto; }} pre {{ white-space: pre-wrap; }}
</style></head><body><h1>{title}</h1>{body}</body></html>"""


def page(policy: Policy, numbers: Sequence[int], title: str, bias: LanguageBias | None = None) -> str:
    """The trees of these numbers (from 1) as a page, with their rules, and with sentences where a bias is given."""
    parts = []
    for number in numbers:
        said = [f"% {each}" for each in sentences(policy, number, bias)] if bias else []
        rules = policy.rules(number)
        lines = [line for pair in zip(said, rules, strict=True) for line in pair] if said else rules
        head = f"<h2>Tree {number}</h2><p>{escape(policy.comments[number - 1])}</p>"
        drawing = f"<figure>{seen(policy.trees[number - 1], policy.bias)}</figure>"
        parts.append(f"{head}{drawing}<pre>{escape(chr(10).join(lines))}</pre>")
    return _PAGE.format(title=escape(title), body="".join(parts))
