"""Writes tasks as own.py reads them."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import fields

from nppg.bias.declarations import ANY, Argument, Follower, Lookahead, Mode
from nppg.bias.names import written
from nppg.bridge.terms import Ground, texts
from nppg.logic.query import OPEN
from nppg.tilde.task import REGRESS, Example, Settings, Task


def files_of(task: Task) -> dict[str, bytes]:
    """The files of a task, contents by name."""
    name = task.name
    beside = {"examples": f"{name}_examples.pl"}
    found = {beside["examples"]: _examples_text(task)}
    if task.facts:
        beside["facts"] = f"{name}_facts.pl"
        found[beside["facts"]] = "".join(f"{text}.\n" for text in texts(list(task.facts)))
    if task.background:
        beside["background"] = f"{name}_background.pl"
        found[beside["background"]] = task.background
    return {f"{name}.yaml": _yaml(task, beside).encode()} | {path: text.encode() for path, text in found.items()}


def _yaml(task: Task, beside: dict[str, str]) -> str:
    bias = task.bias
    template = bias.actions[0]
    lines = [f"# What is learned from, and how: nppg tilde fit {task.name}.yaml"]
    lines.append(f"example: {_quoted(_literal(template.name, [_type(each) for each in template.types]))}")
    lines.append(f"target: {_quoted(task.target)}")
    if task.classes:
        lines.append(f"classes: [{', '.join(map(_quoted, task.classes))}]")
    default = Settings(mode=task.settings.mode)
    lines.append("settings:")
    lines.append(f"  mode: {task.settings.mode}")
    for each in fields(Settings):
        value = getattr(task.settings, each.name)
        if value != getattr(default, each.name):
            lines.append(f"  {each.name}: {value}")
    lines.append("types:")
    lines += [
        f"  {_quoted(name)}: [{', '.join(map(_quoted, types))}]"
        for name, types in bias.types.items()
        if (name, len(types)) != (template.name, len(template.types))
    ]
    lines.append("modes:")
    lines += [f"  - {_mode(mode)}" for mode in bias.modes]
    if bias.lookaheads:
        lines.append("lookaheads:")
        lines += [f"  - {_quoted(_template(each))}" for each in bias.lookaheads]
    lines.append(f"lookahead: {bias.max_lookahead}")
    lines += [f"{key}: {_quoted(path)}" for key, path in beside.items()]
    return "\n".join(lines) + "\n"


def _quoted(text: str) -> str:
    """As YAML reads it, whatever it is."""
    return json.dumps(text, ensure_ascii=False)


def _type(type_: str) -> str:
    return "_" if type_ == ANY else written(type_)


def _literal(name: str, args: Iterable[str]) -> str:
    inner = ", ".join(args)
    return f"{written(name)}({inner})" if inner else written(name)


def _argument(arg: Argument) -> str:
    if arg.kind == "#":
        return f"[{', '.join(map(written, arg.constants))}]" if arg.constants else "#"
    return arg.kind if arg.type == ANY else f"{arg.kind} {_type(arg.type)}"


def _mode(mode: Mode) -> str:
    if mode.name in OPEN and mode.args[1].constants == (OPEN[mode.name],):
        literal = f"{_argument(mode.args[0])} {mode.name} #"
    else:
        literal = _literal("equal" if mode.name == "=" else mode.name, map(_argument, mode.args))
    more = [f"{key}: {value}" for key, value in (("lookahead", mode.lookahead), ("recall", mode.recall)) if value]
    return f"{{literal: {_quoted(literal)}, {', '.join(more)}}}" if more else _quoted(literal)


def _template(lookahead: Lookahead) -> str:
    """Variables are numbered by the places at which they come first."""
    count = len(lookahead.given)
    first = _literal(
        lookahead.name,
        (f"V{i}" if given is None else written(given) for i, given in enumerate(lookahead.given)),
    )
    found = [first]
    for each in lookahead.followers:
        found.append(_follower(each, count))
        count += len(each.args)
    return ", ".join(found)


def _follower(follower: Follower, count: int) -> str:
    args = []
    for place, arg in enumerate(follower.args, count):
        if isinstance(arg, int):
            args.append(f"V{arg}")
        elif arg.kind == "#":
            args.append(_argument(arg))
        else:
            args.append(f"{arg.kind} V{place}")
    return _literal(follower.name, args)


def _examples_text(task: Task) -> str:
    """Each example as a term, its key and its own facts as Prolog reads them."""
    template = task.bias.actions[0]
    keys = [(template.name, *each.key) if each.key else each.name or str(i) for i, each in enumerate(task.examples, 1)]
    lines = []
    for each, key, facts in zip(task.examples, texts(keys), _facts(task.examples), strict=True):
        more = [] if each.weight == 1 and not facts else [f"[{', '.join(facts)}]"]
        more += [repr(each.weight)] if each.weight != 1 else []
        lines.append(f"example({', '.join([key, _target(each, task.settings.mode == REGRESS), *more])}).\n")
    return "".join(lines)


def _facts(examples: Iterable[Example]) -> Iterable[list[str]]:
    """Asked of Prolog at once."""
    every: list[Ground] = []
    counts = []
    for each in examples:
        every += each.facts
        counts.append(len(each.facts))
    written_ones = iter(texts(every))
    return ([next(written_ones) for _ in range(count)] for count in counts)


def _target(example: Example, is_number: bool) -> str:
    if example.target is None:
        return "'?'"
    if isinstance(example.target, tuple):
        return f"[{', '.join(map(repr, example.target))}]"
    return repr(example.target) if is_number and not isinstance(example.target, str) else written(example.target)
