"""Small data sets as ACE and Aleph have them: which boxes are heavy."""

KEYED_SETTINGS = """
load(key).
predict(heavy(+box, -class)).
talking(3).
minimal_cases(2).
typed_language(yes).
type(heavy(box, class)).
type(holds(box, thing)).
type(made_of(thing, stuff)).
type(weight(thing, number)).
type(over(number, number)).
rmode(5: holds(+B, +-T)).
rmode(made_of(+T, #[iron, wood])).
lookahead(holds(B, T), made_of(T, #[iron])).
max_lookahead(1).
"""
THINGS = """
made_of(a, iron). made_of(b, wood). made_of(c, iron). made_of(d, wood). made_of(e, iron). made_of(f, wood).
weight(a, 9). weight(b, 1). weight(c, 8). weight(d, 2). weight(e, 7). weight(f, 3).
"""
HELD = [("b1", "a"), ("b2", "b"), ("b3", "c"), ("b4", "d"), ("b5", "e"), ("b6", "f"), ("b7", "a"), ("b8", "f")]
IS_HEAVY = {"a": "yes", "c": "yes", "e": "yes"}
KNOWLEDGE = "".join(f"heavy({box}, {IS_HEAVY.get(thing, 'no')}).\nholds({box}, {thing}).\n" for box, thing in HELD)
RULES = "over(X, Y) :- X > Y.\nlimit(2). limit(5).\n"

MODEL_SETTINGS = """
load(models).
classes([yes, no]).
typed_language(yes).
type(holds(thing)).
type(made_of(thing, stuff)).
rmode(holds(+-T)).
rmode(made_of(+T, #)).
"""
MODELS = "".join(
    f"begin(model({box[1:]})).\n{IS_HEAVY.get(thing, 'no')}.\nholds({thing}).\nend(model({box[1:]})).\n"
    for box, thing in HELD
)

ALEPH = """
% boxes
:- set(i, 2).
:- set(verbose, 0).
:- modeh(1, heavy(+box)).
:- modeb(*, holds(+box, -thing)).
:- modeb(1, made_of(+thing, #stuff)).
:- modeb(1, over(+number, #number)).
:- modeb(1, weight(+thing, -number)).
:- determination(heavy/1, holds/2).
:- determination(heavy/1, made_of/2).
"""
ALEPH_KNOWLEDGE = THINGS + "".join(f"holds({box}, {thing}).\n" for box, thing in HELD)
POSITIVE = "".join(f"heavy({box}).\n" for box, thing in HELD if thing in IS_HEAVY)
NEGATIVE = "".join(f"heavy({box}).\n" for box, thing in HELD if thing not in IS_HEAVY)
SECTIONS = f"""
:- use_module(library(aleph)).
:- if(current_predicate(use_rendering/1)).
:- use_rendering(prolog).
:- endif.
:- aleph.
{ALEPH.replace(":- set(", ":- aleph_set(")}
:-begin_bg.
{ALEPH_KNOWLEDGE}
:-end_bg.
:-begin_in_pos.
{POSITIVE}
:-end_in_pos.
:-begin_in_neg.
{NEGATIVE}
:-end_in_neg.
:-aleph_read_all.
"""


def write(folder, **files):
    """Writes files by their endings, all called boxes; gives the folder."""
    folder.mkdir(exist_ok=True)
    for ending, text in files.items():
        (folder / f"boxes.{ending}").write_text(text, encoding="utf-8")
    return folder
