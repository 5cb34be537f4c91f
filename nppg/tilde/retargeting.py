"""The same data with another target: `logp(+mol, -number)` says what is given of an example, and what is to be told."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nppg.bias.declarations import ANY, Argument, Template
from nppg.bias.literals import Mistake, parsed
from nppg.bridge.terms import Ground, texts
from nppg.errors import NppgError, Problem, suggestion
from nppg.tilde.knowledge import Knowledge
from nppg.tilde.task import CLASSIFY, REGRESS, Example, Task


def retargeted(task: Task, text: str) -> Task:
    """A task with the answers of a predicate for targets: numbers if all are, else classes; without the modes of this
    predicate. Raises NppgError for a text that is no such target, and where there is no answer."""
    name, args = _read(text)
    plus, minus = ([i for i, arg in enumerate(args) if arg.kind == kind] for kind in "+-")
    knowledge = Knowledge(task)
    known = knowledge.predicates
    if (name, len(args)) not in known:
        same = ", ".join(f"{each}/{arity}" for each, arity in sorted(known) if each == name)
        hint = f" (there is {same})" if same else suggestion(name, (each for each, _ in known))
        raise NppgError(f"--target: the data has no predicate {name}/{len(args)}{hint}")
    if plus:
        answers = [(Example(tuple(row[i] for i in plus)), row) for row in knowledge.solutions(name, len(args))]
    else:
        answers = [
            (replace(each, target=None), row)
            for each in task.examples
            for row in knowledge.solutions(name, len(args), each)[:1]
        ]
    if not answers:
        raise NppgError(f"--target: {name}/{len(args)} has no answer")
    rows = [[row[i] for i in minus] for _, row in answers]
    are_numbers = all(isinstance(value, int | float) for row in rows for value in row)
    if len(minus) > 1 and not are_numbers:
        raise NppgError(f"--target: several targets are numbers, and {text} has others")
    mode = REGRESS if are_numbers else CLASSIFY
    settings = task.settings
    if mode != settings.mode:
        settings = replace(settings, mode=mode, heuristic="", pruning="")
    declared = task.bias.types_of(name, len(args)) or (ANY,) * len(args)
    types = tuple(args[i].type or declared[i] for i in plus)
    bias = replace(
        task.bias,
        actions=(Template(name, types),) if plus else task.bias.actions,
        modes=tuple(each for each in task.bias.modes if (each.name, len(each.args)) != (name, len(args))),
    )
    examples = tuple(replace(each, target=_target(row)) for (each, _), row in zip(answers, rows, strict=True))
    left_out = tuple(
        Problem(bias.file, each.line, each.column, f"{each} is left out: it is the target")
        for each in task.bias.modes
        if each not in bias.modes
    )
    return replace(
        task,
        bias=bias,
        examples=examples,
        target=args[minus[0]].type or name,
        classes=(),
        settings=settings,
        left_out=(*task.left_out, *left_out),
    )


def _target(row: Sequence[Ground]) -> str | int | float | tuple[float, ...]:
    if len(row) > 1:
        return tuple(float(each) for each in row)  # type: ignore[arg-type]
    (value,) = row
    return value if isinstance(value, str | int | float) else texts([value])[0]


def _read(text: str) -> tuple[str, list[Argument]]:
    try:
        name, placed = parsed(text)
    except Mistake as mistake:
        raise NppgError(f"--target: {mistake}, at character {mistake.offset + 1} of {text}") from None
    args = [arg for arg, _ in placed]
    if not any(arg.kind == "-" for arg in args) or any(arg.kind not in "+-" for arg in args):
        raise NppgError(
            f"--target: write what is given with + and what is to be told with -: p(+key, -class), not {text}"
        )
    return name, args
