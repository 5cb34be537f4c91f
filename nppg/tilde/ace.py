"""Reads data sets as ACE has them: settings (`.s`), knowledge base (`.kb`), background (`.bg`)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from nppg.bias.declarations import ANY, Template
from nppg.bridge.terms import Ground
from nppg.errors import NppgError, Problem
from nppg.tilde.ace_constants import Constants
from nppg.tilde.ace_settings import Given
from nppg.tilde.constants import Facts, answers
from nppg.tilde.declared import askable, bias_of, looking_ahead
from nppg.tilde.mode_terms import Language, own_type, type_declared
from nppg.tilde.program import Background, Clause, background, conditional, read
from nppg.tilde.task import REGRESS, Example, Target, Task
from nppg.tilde.terms import (
    Indicator,
    arguments,
    elements,
    indicator,
    is_variable,
    match,
    number,
    parts,
    told,
    within,
)

OPERATORS = [*((200, "fy", name) for name in ("+-", "#", "-#", "+#", "-\\", "+\\")), (990, "xfx", "::")]
_DEFAULT_CLASSES = ("pos", "neg")
_PROBABILITIES = (
    "probabilities are left aside: of a model's classes the most probable counts, of other facts those above 0.5"
)


@dataclass
class Model:
    """What stands between begin(model(Name)) and end(model(Name))."""

    name: str
    file: str
    line: int
    facts: list[Ground] = field(default_factory=list)
    shares: dict[Ground, float] = field(default_factory=dict)  # of facts P::Fact

    def problem(self, message: str) -> Problem:
        return Problem(self.file, self.line, 0, f"the model {self.name} {message}")


def read_ace(settings: Path, knowledge: Sequence[Path]) -> Task:
    """The task of a settings file and of the knowledge bases and background that belong to it. Raises NppgError with
    what cannot be read, and where there is no target or no example."""
    left_out: list[Problem] = []
    given = Given(conditional(read(settings, OPERATORS), left_out), left_out)
    grown = given.settings()
    clauses = [clause for path in knowledge for clause in conditional(read(path, OPERATORS), left_out)]
    models, shared = _models(clauses, left_out)
    types = given.types(map(type_declared, (clause.data for clause in given.terms.get("type", ()))))
    asked = {each for clause in given.language for each in within(clause.data)}
    examples = tuple(_from_models(given, models, grown.mode == REGRESS))
    theirs = {indicator(fact) for each in examples for fact in each.facts}
    base = background(shared, asked, left_out, theirs)
    if models or given.load in ("models", "examples"):
        pattern, _ = _pattern(given)
        target = "class" if pattern is None else indicator(pattern)[0]
        template, classes = Template("example", ()), tuple(map(told, given.classes))
        facts = base.facts
    else:
        predicted = _Predicted(given, types, settings)
        examples, template = predicted.examples(base, shared, grown.mode == REGRESS, left_out)
        target, classes = predicted.target, tuple(map(told, given.classes))
        facts = tuple(fact for fact in base.facts if indicator(fact) != predicted.indicator)
    if not examples:
        where = " and ".join(map(str, knowledge)) or str(settings.parent)
        raise NppgError([Problem(str(settings), 0, 0, f"there is no example in {where}")])
    every = Facts([*base.facts, *(fact for each in examples for fact in each.facts)], base.rules)
    language = Language(types, Constants(given, base, every, examples), left_out)
    for clause in given.language:
        language.declare(clause)
    most = given.whole("max_lookahead", 1)
    modes, lookaheads = askable(language.modes, language.lookaheads if most else (), base, theirs, settings, left_out)
    modes = looking_ahead(modes, dict.fromkeys(language.looking, most), given.whole("exhaustive_lookahead", 0))
    most = max(most, *(mode.lookahead for mode in modes))
    return Task(
        name=settings.stem,
        bias=bias_of(settings, template, types, modes, lookaheads, most),
        examples=examples,
        facts=facts,
        background=base.text,
        background_file=str(knowledge[-1]) if knowledge else "",
        examples_file=str(knowledge[0]) if knowledge else "",
        target=target,
        classes=classes if grown.mode != REGRESS else (),
        settings=grown,
        left_out=tuple(left_out),
    )


def _models(clauses: Iterable[Clause], left_out: list[Problem]) -> tuple[list[Model], list[Clause]]:
    """The models, and what is for all. Raises NppgError where one does not end."""
    models: list[Model] = []
    shared: list[Clause] = []
    inside: Model | None = None
    is_told = False
    for clause in clauses:
        word = clause.predicate
        name = arguments(clause.data)[0] if word in (("begin", 1), ("end", 1)) else ""
        if word == ("begin", 1) and indicator(name) in (("model", 1), ("example", 1)):
            if inside:
                raise NppgError([inside.problem(f"has not ended where {told(name)} begins, on line {clause.line}")])
            inside = Model(told(arguments(name)[0]), clause.file, clause.line)
            models.append(inside)
        elif word == ("end", 1) and inside:
            inside = None
        elif word in (("begin", 1), ("end", 1)) and name in ("background", "knowledge"):
            pass
        elif inside is None:
            shared.append(clause)
        elif clause.kind == "fact" and word == ("::", 2):
            share, fact = arguments(clause.data)
            inside.shares[fact] = float(share) if isinstance(share, int | float) else 1.0
            if not is_told:
                left_out.append(clause.problem(_PROBABILITIES))
                is_told = True
        elif clause.kind == "fact":
            inside.facts.append(clause.data)
        else:
            left_out.append(clause.problem(f"a model consists of facts: {told(clause.data)} is left out"))
    if inside:
        raise NppgError([inside.problem(f"does not end: end(model({inside.name})). is missing")])
    return models, shared


def _from_models(given: Given, models: list[Model], is_number: bool) -> Iterator[Example]:
    """A model's target is the class that is one of its facts, or what a pattern of the settings says."""
    pattern, wanted = _pattern(given)
    classes = given.classes or _DEFAULT_CLASSES
    for model in models:
        likely = [fact for fact, share in model.shares.items() if share > 0.5 and fact not in classes]
        facts = [*model.facts, *likely]
        target: Target | None = None
        if pattern is not None:
            for fact in facts:
                bound: dict[int, Ground] = {}
                if match(pattern, fact, bound):
                    target = _value([bound[number] for number in wanted if number in bound], is_number)
                    facts.remove(fact)
                    break
        else:
            found = [fact for fact in dict.fromkeys(model.facts) if fact in classes]
            weighed = [fact for fact in model.shares if fact in classes]
            if weighed and not found:
                found = [max(weighed, key=model.shares.__getitem__)]
            if len(found) > 1:
                names = " and ".join(map(told, found))
                raise NppgError([model.problem(f"has two classes, {names}")])
            facts = [fact for fact in facts if fact not in classes]
            target = told(found[0]) if found else None
        yield Example((), target, tuple(facts), line=model.line, name=model.name)


def _pattern(given: Given) -> tuple[Ground | None, list[int]]:
    """The fact of a model that has the target, and which of its variables are that: euclid(value(X), X)."""
    for clause in given.terms.get("euclid", ()):
        fact, value = arguments(clause.data)
        return fact, [each[1] for each in elements(value) or parts(value) if is_variable(each)]  # type: ignore[index, misc]
    for clause in (*given.terms.get("predict", ()), *given.terms.get("predicate", ())):
        literal = arguments(clause.data)[0]
        places = range(1, len(arguments(literal)) + 1)
        if indicator(literal)[1]:
            minus = [place for place in places if indicator(literal[place])[0] == "-" or literal[place] == "-"]  # type: ignore[index]
            return (literal[0], *(("$VAR", place) for place in places)), minus  # type: ignore[index]
    return None, []


def _value(values: Sequence[Ground], is_number: bool) -> Target | None:
    """A target as a task has it."""
    if not values:
        return None
    plain = [value if isinstance(value, int | float) else told(value) for value in values]
    if is_number and len(plain) > 1:
        return tuple(plain)  # type: ignore[arg-type]
    return plain[0] if is_number else ", ".join(map(str, plain))


class _Predicted:
    """The predicate that a keyed knowledge base predicts."""

    def __init__(self, given: Given, types: dict[Indicator, tuple[str, ...]], settings: Path):
        clauses = [*given.terms.get("predict", ()), *given.terms.get("predicate", ())]
        if not clauses:
            message = "predict(p(+key, -class)) is missing, which says what is to be predicted"
            raise NppgError([Problem(str(settings), 0, 0, message)])
        self.clause = clauses[0]
        literal = arguments(self.clause.data)[0]
        self.indicator = indicator(literal)
        args = arguments(literal)
        self.given = given
        self.types = types
        self.wanted = [i for i, arg in enumerate(args) if indicator(arg)[0] == "-" and not is_variable(arg)]
        if not self.wanted or len(self.wanted) == len(args):
            raise NppgError([self.clause.problem(f"{told(literal)}: give the key a + and what is predicted a -")])
        declared = types.get(self.indicator, tuple(map(own_type, args)))
        self.key_types = tuple(type_ for i, type_ in enumerate(declared) if i not in self.wanted)
        name = own_type(args[self.wanted[0]])
        self.target = name if name != ANY and len(self.wanted) == 1 else "class"

    def examples(
        self, base: Background, clauses: Iterable[Clause], is_number: bool, left_out: list[Problem]
    ) -> tuple[tuple[Example, ...], Template]:
        """The predicate's answers in the order of the file, and the template of a key."""
        name, arity = self.indicator
        rules = {clause.predicate for clause in clauses if clause.kind == "rule"}
        if self.indicator in rules:
            variables = [("$VAR", i) for i in range(arity)]
            found = [(row, 0) for row in answers(base, [(name, *variables)], variables)]
        else:
            found = [
                (arguments(clause.data), clause.line)
                for clause in clauses
                if clause.kind == "fact" and clause.predicate == self.indicator
            ]
        examples = []
        for row, line in dict(found).items():
            key = tuple(arg for i, arg in enumerate(row) if i not in self.wanted)
            examples.append(Example(key, _value([row[i] for i in self.wanted], is_number), line=line))
        types = self.key_types
        for clause in self.given.terms.get("root", ()):
            examples, more = self._rooted(clause, base, rules, examples, left_out)
            types += more
        return tuple(examples), Template(name, types)

    def _rooted(
        self, clause: Clause, base: Background, rules: set[Indicator], examples: list[Example], left_out: list[Problem]
    ) -> tuple[list[Example], tuple[str, ...]]:
        """With what root((p(X, C), q(X, Y))) binds beside the key: its first answer."""
        first, *goals = parts(arguments(clause.data)[0])
        if not goals or indicator(first) != self.indicator:
            return examples, ()
        variables = [arg for i, arg in enumerate(arguments(first)) if i not in self.wanted]
        types: dict[int, str] = {}
        for goal in goals:
            declared = self.types.get(indicator(goal), (ANY,) * len(arguments(goal)))
            for arg, type_ in zip(arguments(goal), declared, strict=True):
                if is_variable(arg) and arg not in variables:
                    types.setdefault(number(arg), type_)
        if any(indicator(goal) in base.rules for goal in goals):
            left_out.append(clause.problem("the root is left out: it is asked of facts, and this one of rules"))
            return examples, ()
        facts, found, lost = Facts(base.facts), [], 0
        for each in examples:
            bound = {number(variable): value for variable, value in zip(variables, each.key, strict=True)}
            answer = next(facts.solutions(goals, bound), None)
            if answer is None:
                lost += 1
            else:
                found.append(Example((*each.key, *(answer[number] for number in types)), each.target, line=each.line))
        if lost:
            what = f"{lost} of {len(examples)} examples are left out: the root does not hold of them"
            left_out.append(clause.problem(what))
        return found, tuple(types.values())
