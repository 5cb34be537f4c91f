"""PDDL domains built by hand, each with a problem: one for each thing that a domain file must be able to say."""

from __future__ import annotations

from nppg.pddl.model import (
    Action,
    Add,
    And,
    Arithmetic,
    Atom,
    Change,
    Compare,
    Delete,
    Derived,
    Domain,
    Each,
    Equal,
    Exists,
    Forall,
    Formula,
    Not,
    Or,
    PlanningProblem,
    Probabilistic,
    Symbol,
    Together,
    Typed,
    Value,
    When,
)

Sample = tuple[Domain, PlanningProblem]


def typed(text: str) -> tuple[Typed, ...]:
    """`?x - car ?y - car/truck` as PDDL reads it; a slash stands for either, and a type is for one name."""
    words, found = text.split(), []
    while words:
        name = words.pop(0)
        types = ("object",)
        if words[:1] == ["-"]:
            types, words = tuple(words[1].split("/")), words[2:]
        found.append(Typed(name, types))
    return tuple(found)


def atom(text: str) -> Atom:
    """`at ?x ?l` as an atom."""
    name, *args = text.split()
    return Atom(name, tuple(args))


def symbols(*texts: str) -> tuple[Symbol, ...]:
    """Predicates, functions: `at ?x - car ?l`."""
    return tuple(Symbol(name, typed(rest)) for name, _, rest in (text.partition(" ") for text in texts))


def all_of(*parts: str | Formula) -> And:
    """Atoms as texts, `not ` before those that are negated."""
    return And(tuple(_literal(part) if isinstance(part, str) else part for part in parts))


def _literal(text: str) -> Formula:
    return Not(atom(text[4:])) if text.startswith("not ") else atom(text)


def effects(*parts: object) -> Together:
    """The same for effects."""
    return Together(
        tuple(
            (Delete(atom(part[4:])) if part.startswith("not ") else Add(atom(part))) if isinstance(part, str) else part
            for part in parts
        )  # type: ignore[arg-type]
    )


def domain(name: str, predicates: tuple[Symbol, ...], *actions: Action, **more: object) -> Domain:
    """A domain without what is not given."""
    given: dict = {"requirements": (), "types": {}, "constants": (), "functions": (), "derived": (), "source": ""}
    return Domain(file=f"pddl/{name}.pddl", name=name, predicates=predicates, actions=actions, **(given | more))


def problem(name: str, objects: str, init: str, goal: Formula, **more: object) -> PlanningProblem:
    """A problem; the facts of `init` are set apart by commas."""
    given: dict = {"values": (), "metric": None, "goal_reward": 0}
    facts = tuple(atom(each) for each in init.split(","))
    return PlanningProblem(f"{name}-1.pddl", f"{name}-1", name, typed(objects), facts, goal=goal, **(given | more))


def ferry() -> Sample:
    predicates = symbols("at-ferry ?l - location", "at ?c - car ?l - location", "empty-ferry", "on ?c - car")
    sail = Action(
        "sail",
        typed("?from - location ?to - location"),
        all_of("at-ferry ?from", "not at-ferry ?to"),
        effects("at-ferry ?to", "not at-ferry ?from"),
    )
    board = Action(
        "board",
        typed("?car - car ?loc - location"),
        all_of("at ?car ?loc", "at-ferry ?loc", "empty-ferry"),
        effects("on ?car", "not at ?car ?loc", "not empty-ferry"),
    )
    debark = Action(
        "debark",
        typed("?car - car ?loc - location"),
        all_of("on ?car", "at-ferry ?loc"),
        effects("not on ?car", "at ?car ?loc", "empty-ferry"),
    )
    made = domain("ferry", predicates, sail, board, debark, types={"car": ("object",), "location": ("object",)})
    objects = "c1 - car c2 - car l1 - location l2 - location l3 - location"
    return made, problem(
        "ferry", objects, "at-ferry l1,empty-ferry,at c1 l2,at c2 l1", all_of("at c1 l3", "at c2 l2", "not on c1")
    )


def vehicles() -> Sample:
    """Types above types, `either`, and a predicate whose declared type is wider than a parameter's."""
    types = {
        "truck": ("vehicle",),
        "boat": ("vehicle",),
        "vehicle": ("thing",),
        "box": ("thing",),
        "place": ("object",),
    }
    predicates = symbols("at ?t - thing ?p - place", "in ?b - box ?v - vehicle", "road ?p - place ?q - place", "wet ?p")
    drive = Action(
        "drive",
        typed("?t - truck ?p - place ?q - place"),
        all_of("at ?t ?p", "road ?p ?q", Not(Equal("?p", "?q"))),
        effects("not at ?t ?p", "at ?t ?q"),
    )
    swim = Action(
        "swim",
        typed("?b - boat ?p - place ?q - place"),
        all_of("at ?b ?p", "wet ?p", "wet ?q"),
        effects("not at ?b ?p", "at ?b ?q"),
    )
    load = Action(
        "load",
        typed("?b - box ?v - truck/boat ?p - place"),
        all_of("at ?b ?p", "at ?v ?p"),
        effects("not at ?b ?p", "in ?b ?v"),
    )
    paint = Action("paint", typed("?x - box/truck"), all_of("not wet ?x"), effects("wet ?x"))
    objects = "t1 - truck t2 - truck b1 - boat x1 - box p - place q - place r - place"
    init = "at t1 p,at t2 q,at b1 q,at x1 p,road p q,road q p,road r r,wet q,wet r"
    made = domain("vehicles", predicates, drive, swim, load, paint, types=types)
    return made, problem("vehicles", objects, init, all_of("in x1 b1"))


def lamps() -> Sample:
    """Conditional effects and effects for all."""
    predicates = symbols("lit ?l - lamp", "near ?l - lamp ?m - lamp", "broken ?l - lamp", "power")
    press = Action(
        "press",
        typed("?l - lamp"),
        all_of("power"),
        effects(
            When(all_of("lit ?l"), effects("not lit ?l")),
            When(all_of("not lit ?l", "not broken ?l"), effects("lit ?l")),
            Each(
                typed("?m - lamp"),
                Together(
                    (
                        When(all_of("near ?l ?m", "lit ?m"), effects("not lit ?m")),
                        When(all_of("near ?l ?m", "not lit ?m", Not(Equal("?m", "?l"))), effects("lit ?m")),
                    )
                ),
            ),
        ),
    )
    fuse = Action(
        "fuse",
        (),
        Forall(typed("?l - lamp"), Or((atom("lit ?l"), Exists(typed("?m - lamp"), all_of("near ?l ?m", "lit ?m"))))),
        effects("not power", Each(typed("?l - lamp"), effects("not lit ?l"))),
    )
    mend = Action(
        "mend",
        typed("?l - lamp"),
        all_of(Or((all_of("broken ?l", "not power"), Not(Or((atom("power"), atom("lit ?l"))))))),
        effects("power", "not broken ?l"),
    )
    objects = "l1 - lamp l2 - lamp l3 - lamp"
    init = "near l1 l2,near l2 l1,near l2 l3,near l3 l2,broken l3,power,lit l1"
    goal = all_of(Forall(typed("?l - lamp"), atom("lit ?l")), Exists(typed("?x"), all_of("lit ?x", "not broken ?x")))
    made = domain("lamps", predicates, press, fuse, mend, types={"lamp": ("object",)})
    return made, problem("lamps", objects, init, goal)


def tanks() -> Sample:
    """Numbers that change, costs, and numbers that do not."""
    functions = symbols("fuel ?v - car", "way ?p - place ?q - place", "trips", "total-cost")
    fuel, way = Value("fuel", ("?v",)), Value("way", ("?p", "?q"))
    go = Action(
        "go",
        typed("?v - car ?p - place ?q - place"),
        all_of("at ?v ?p", Compare(">=", fuel, way), Compare(">", way, 0)),
        effects(
            "not at ?v ?p",
            "at ?v ?q",
            Change("decrease", fuel, way),
            Change("increase", Value("trips", ()), 1),
            Change("increase", Value("trips", ()), Arithmetic("*", (2, Arithmetic("+", (way, 1))))),
            Change("increase", Value("total-cost", ()), way),
        ),
    )
    halve = Action("halve", typed("?v - car"), all_of(Compare("=", fuel, 4)), effects(Change("scale-down", fuel, 2)))
    values = {("fuel", "v1"): 4, ("fuel", "v2"): 7, ("way", "p", "q"): 3, ("way", "q", "p"): 4, ("trips",): 0}
    made = domain(
        "tanks",
        symbols("at ?v - car ?p - place", "pump ?p - place"),
        go,
        halve,
        functions=functions,
        types={"car": ("object",), "place": ("object",)},
    )
    return made, problem(
        "tanks",
        "v1 - car v2 - car p - place q - place",
        "at v1 p,at v2 q,pump q",
        all_of("at v1 q", Compare(">=", Value("fuel", ("v1",)), 1)),
        values=tuple((Value(name, tuple(args)), number) for (name, *args), number in values.items()),
    )


def stations() -> Sample:
    """Numbers that change under conditions, and for all."""
    level = Value("level", ("?s",))
    pump = Action(
        "pump",
        typed("?s - station"),
        all_of("works ?s"),
        effects(
            When(all_of("blocked ?s"), Change("assign", Value("state", ()), 1)),
            Each(
                typed("?t - station"),
                When(all_of("linked ?s ?t", Compare("<", Value("level", ("?t",)), 9)), _more("?t", level)),
            ),
            When(Compare(">", level, 4), effects("blocked ?s")),
        ),
    )
    values = {("level", "a"): 3, ("level", "b"): 5}
    made = domain(
        "stations",
        symbols("works ?s - station", "blocked ?s - station", "linked ?s - station ?t - station"),
        pump,
        functions=symbols("level ?s - station", "state"),
        types={"station": ("object",)},
    )
    return made, problem(
        "stations",
        "a - station b - station",
        "works a,works b,linked a b,linked b a,linked b b",
        all_of("blocked b"),
        values=tuple((Value(name, tuple(args)), number) for (name, *args), number in values.items()),
    )


def _more(station: str, level: Value) -> Change:
    return Change("increase", Value("level", (station,)), level)


def dice() -> Sample:
    """Chance: side by side, nested, under a condition; an effect that is left to what remains."""
    maybe_mad = Probabilistic(((0.5, Add(atom("mad"))),))
    throw = Action(
        "throw",
        typed("?d - die"),
        all_of("ready ?d"),
        effects(
            "not ready ?d",
            Probabilistic(((0.2, effects("six ?d")), (0.3, effects("lost ?d", maybe_mad)))),
            When(all_of("mad"), Probabilistic(((0.25, effects("not mad")),))),
            Probabilistic(((0.9, effects("ready ?d")),)),
        ),
    )
    wait = Action("wait", (), all_of(), effects())
    find = Action("find", typed("?d - die"), all_of("lost ?d"), effects("not lost ?d", "ready ?d"))
    made = domain(
        "dice",
        symbols("ready ?d - die", "six ?d - die", "lost ?d - die", "mad"),
        throw,
        wait,
        find,
        types={"die": ("object",)},
    )
    return made, problem("dice", "d1 - die d2 - die", "ready d1,ready d2", all_of("six d1", "six d2"))


def towers() -> Sample:
    """Derived predicates, one of them recursive."""
    move = Action(
        "move",
        typed("?x - block ?y - block/table"),
        all_of("free ?x", "not above ?y ?x", "not on ?x ?y", Or((atom("free ?y"), Equal("?y", "floor")))),
        effects(
            Each(typed("?z - block/table"), When(all_of("on ?x ?z"), effects("not on ?x ?z"))),
            "on ?x ?y",
        ),
    )
    free = Derived("free", typed("?x - block"), Not(Exists(typed("?y - block"), atom("on ?y ?x"))))
    above = Derived(
        "above",
        typed("?x ?y"),
        Or((atom("on ?x ?y"), Exists(typed("?z - block"), all_of("on ?x ?z", "above ?z ?y")))),
    )
    made = domain(
        "towers",
        symbols("on ?x - block ?y - block/table", "free ?x", "above ?x ?y"),
        move,
        types={"block": ("object",), "table": ("object",)},
        constants=typed("floor - table"),
        derived=(free, above),
    )
    return made, problem("towers", "a - block b - block c - block", "on a b,on b floor,on c floor", all_of("above c b"))


def odd() -> Sample:
    """Names that Prolog has for itself, or that differ for PDDL alone."""
    predicates = symbols(
        "goal ?x", "on-top ?x ?y", "on_top ?x ?y", "is ?x ?y", "mod ?x", "@at ?x", "block ?b - block", "2nd ?x"
    )
    action = Action(
        "goal",
        typed("?x - block ?x-1 - block ?_x"),
        all_of("goal ?x", "on-top ?x ?x-1", "not on_top ?x-1 ?x", "is ?x ?_x", "mod end", "not @at table"),
        effects("on_top ?x-1 ?x", "not goal ?x", "goal table", "2nd ?x-1", "mod two-words", "@at ?x-1"),
    )
    dynamic = Action("dynamic", typed("?is - block"), all_of("block ?is"), effects("not block ?is", "is ?is table"))
    made = domain(
        "odd-names",
        predicates,
        action,
        dynamic,
        types={"block": ("object",)},
        constants=typed("table end two-words"),
    )
    init = "goal b1,on-top b1 b2,is b1 table,is b1 b2,mod end,block b1"
    return made, problem("odd-names", "b1 - block b2 - block", init, all_of("on_top b2 b1", "2nd b2", "goal table"))


def bets() -> Sample:
    """Rewards, with and without conditions, and one for the goal."""
    reward = Value("reward", ())
    bet = Action(
        "bet",
        typed("?c - coin"),
        all_of("have ?c"),
        effects(
            Change("decrease", reward, 1),
            When(Or((atom("lucky"), atom("have ?c"))), Change("increase", reward, 3)),
            Probabilistic(((0.5, effects("lucky", Change("increase", reward, 10))), (0.5, effects("not have ?c")))),
        ),
    )
    rest = Action("rest", (), all_of(), effects())
    made = domain("bets", symbols("have ?c - coin", "lucky"), bet, rest, types={"coin": ("object",)})
    return made, problem("bets", "c1 - coin c2 - coin", "have c1,have c2", all_of("lucky"), goal_reward=100)


SAMPLES = (ferry, vehicles, lamps, tanks, stations, dice, towers, odd, bets)
