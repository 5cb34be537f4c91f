"""Data sets in files of ACE, of Aleph and of nppg: what is read, what is left out and told, what is an error."""

import dataclasses
import math

import pytest
from tilde_files import (
    ALEPH,
    ALEPH_KNOWLEDGE,
    KEYED_SETTINGS,
    KNOWLEDGE,
    MODEL_SETTINGS,
    MODELS,
    NEGATIVE,
    POSITIVE,
    RULES,
    SECTIONS,
    THINGS,
    write,
)

from nppg.bias.declarations import Argument, Follower, Lookahead
from nppg.cli.verbs import run
from nppg.errors import NppgError
from nppg.tilde.learning import Learner
from nppg.tilde.printing import tree_text
from nppg.tilde.reading import read_task
from nppg.tilde.writing import files_of


def keyed(folder, settings=KEYED_SETTINGS, kb=KNOWLEDGE + THINGS, bg=RULES):
    return write(folder, s=settings, kb=kb, bg=bg)


def aleph(folder, b=ALEPH + ALEPH_KNOWLEDGE, f=POSITIVE, n=NEGATIVE):
    return write(folder, b=b, f=f, n=n)


def modes(task):
    return [str(mode) for mode in task.bias.modes]


def told(task):
    return [(problem.line, problem.message) for problem in task.left_out]


def wrong(*sources):
    with pytest.raises(NppgError) as caught:
        read_task(sources)
    return str(caught.value)


def tree(task):
    learner = Learner(task)
    model = learner.model(task.settings)
    return tree_text(model.tree, model)


def test_keyed(tmp_path):
    task = read_task([keyed(tmp_path)])
    assert (task.name, task.target, str(task.bias.actions[0])) == ("boxes", "class", "heavy(box)")
    assert modes(task) == ["holds(+box, +-thing)", "made_of(+thing, [iron, wood])"]
    assert task.bias.modes[0].recall == 5
    follower = Follower("made_of", (1, Argument("#", "stuff", ("iron",))))
    assert task.bias.lookaheads == (Lookahead("holds", (None, None), (follower,)),)
    first = task.examples[0]
    assert (first.key, first.target, first.line) == (("b1",), "yes", 1)
    assert ("heavy", "b1", "yes") not in task.facts
    assert task.left_out == ()
    assert tree(task) == "\n".join(
        ["heavy(A)", "holds(A, B), made_of(B, iron) ?", "+--yes: [yes] [4/4]", "+--no:  [no] [4/4]"]
    )


def test_models(tmp_path):
    task = read_task([write(tmp_path, s=MODEL_SETTINGS, kb=MODELS, bg=THINGS)])
    first = task.examples[0]
    assert (first.key, first.target, first.facts, first.name) == ((), "yes", (("holds", "a"),), "1")
    assert task.classes == ("yes", "no")
    assert modes(task) == ["holds(+-thing)", "made_of(+thing, [])"]
    assert ("made_of", "a", "iron") in task.facts


def test_numbers_and_patterns(tmp_path):
    settings = "tilde_mode(regression). load(models). euclid(q(X), X). heuristic(eucl). rmode(holds(+-T)). ftest(0.1)."
    models = "begin(model(m1)). q(2.5). holds(a). end(model(m1)). begin(model(m2)). holds(b). q(-1). end(model(m2))."
    task = read_task([write(tmp_path, s=settings, kb=models)])
    assert [each.target for each in task.examples] == [2.5, -1]
    assert (task.settings.mode, task.settings.significance, task.target) == ("regress", 0.1, "q")
    several = "predict(q(+k, -a, -b)). tilde_mode(regress). rmode(p(+))."
    task = read_task([write(tmp_path / "several", s=several, kb="q(x, 1, 2.5). p(x). q(y, 3, 4).")])
    assert [(each.key, each.target) for each in task.examples] == [(("x",), (1, 2.5)), (("y",), (3, 4))]


def test_a_target_that_rules_define(tmp_path):
    bg = "heavy(X, yes) :- size(X, N), N > 5. heavy(X, no) :- size(X, N), N =< 5."
    task = read_task([keyed(tmp_path, kb="size(b1, 9). size(b2, 1). holds(b1, a)." + THINGS, bg=bg)])
    assert [(each.key, each.target) for each in task.examples] == [(("b1",), "yes"), (("b2",), "no")]


def test_constants_from_generators(tmp_path):
    settings = KEYED_SETTINGS + (
        "rmode(weight(+T, -N)).\nrmode(#(L: limit(L), over(+N, L))).\n"
        "rmode(#(2*2*L: member(L, [4, 6]), over(+N, L))).\n"
        "rmode(#((S, L): (made_of(a, S), limit(L)), pair(+T, S, L))).\nrmode(#(L: nowhere(L), over(+N, L))).\n"
    )
    bg = RULES + "pair(T, S, L) :- made_of(T, S), weight(T, W), W > L."
    task = read_task([keyed(tmp_path, settings, bg=bg)])
    assert "over(+number, [2, 5])" in modes(task) and "over(+number, [4, 6])" in modes(task)
    assert [mode for mode in modes(task) if mode.startswith("pair")] == ["pair(+_, iron, 2)", "pair(+_, iron, 5)"]
    assert told(task) == [(20, "rmode(#(A:nowhere(A), over(+B, A))) is left out: nowhere(A) gives no constants")]


@pytest.mark.parametrize(("how", "limits"), [("entropy", [5.0]), ("equal_freq", [5.0, 7.5])])
def test_thresholds(tmp_path, how, limits):
    settings = KEYED_SETTINGS + (
        f"discretize({how}).\nto_be_discretized(gen(B, W), 2, [W]).\nrmode(weight(+T, -N)).\n"
        "rmode(#(C: threshold(gen(_, W), [W], C), over(+N, C))).\n"
    )
    bg = RULES + "gen(B, W) :- holds(B, T), weight(T, W)."
    task = read_task([keyed(tmp_path, settings, bg=bg)])
    (mode,) = (mode for mode in task.bias.modes if mode.name == "over")
    assert list(mode.args[1].constants) == limits


def test_several_literals_and_any_type(tmp_path):
    settings = "predict(heavy(+B, -C)). rmode((holds(+B, -T), made_of(T, #[iron]))). rmode(+X = +Y). rmode(+X =< #)."
    task = read_task([keyed(tmp_path, settings)])
    assert modes(task) == ["holds(+_, -_)", "equal(+_, +_)"]
    assert told(task) == [
        (1, "rmode(+A=<#) is left out: numbers alone can be compared: say of which type, type(number =< number)")
    ]
    (template,) = task.bias.lookaheads
    assert template.followers == (Follower("made_of", (1, Argument("#", "_", ("iron",)))),)


def test_the_root_binds_more(tmp_path):
    settings = (
        "predict(heavy(+box, -class)). root((heavy(B, C), holds(B, T))). typed_language(yes).\n"
        "type(heavy(box, class)). type(holds(box, thing)). type(made_of(thing, stuff)). rmode(made_of(+T, #[iron]))."
    )
    task = read_task([keyed(tmp_path, settings, kb=KNOWLEDGE + THINGS + "heavy(b9, no).")])
    assert str(task.bias.actions[0]) == "heavy(box, thing)"
    assert task.examples[0].key == ("b1", "a") and len(task.examples) == 8
    assert told(task) == [(1, "1 of 9 examples are left out: the root does not hold of them")]


def test_lookahead_of_predicates(tmp_path):
    settings = KEYED_SETTINGS.replace("max_lookahead(1)", "max_lookahead(2)") + "auto_lookahead(holds(B, T), [T])."
    task = read_task([keyed(tmp_path, settings)])
    assert [mode.lookahead for mode in task.bias.modes] == [2, 0]
    off = KEYED_SETTINGS.replace("max_lookahead(1)", "max_lookahead(0)") + "auto_lookahead(holds(B, T), [T])."
    task = read_task([keyed(tmp_path / "off", off)])
    assert [mode.lookahead for mode in task.bias.modes] == [0, 0] and task.bias.lookaheads == ()


def test_what_is_unknown_is_told(tmp_path):
    settings = (
        KEYED_SETTINGS + "minimal_case(3).\nheuristic(gini).\naccuracy(0.8).\nrmode(holdss(+B, -T)).\nconstraint(x).\n"
    )
    task = read_task([keyed(tmp_path, settings)])
    assert told(task) == [
        (16, "minimal_case(3) is left aside: it is no setting that nppg knows (did you mean 'minimal_cases'?)"),
        (20, "constraint(x) is left aside: it is not carried over: modes and types alone say what may be tested"),
        (17, "heuristic(gini) is left aside: it is none of nppg's heuristics: gain or gainratio or gain_ratio"),
        (18, "accuracy(0.8) is left aside: it is not carried over: only a pure node is a leaf"),
        (19, "the mode holdss(+_, -_) is left out: there is no fact or rule of it (did you mean 'holds'?)"),
    ]


def test_what_may_not_run_is_told(tmp_path):
    bg = RULES + "\nbad(X) :- shell('touch /tmp/x'), X = 1.\nworse(X) :- bad(X).\n:- shell(ls).\n"
    task = read_task([keyed(tmp_path, KEYED_SETTINGS + "rmode(worse(+B)).", bg=bg)])
    assert told(task) == [
        (4, "bad/1 is left out: it calls shell/1, which only a trusted program may"),
        (6, ":- shell(ls) is not run"),
        (16, "the mode worse(+_) is left out: it calls bad/1, which is left out"),
    ]
    assert "shell" not in task.background
    Learner(task)


def test_probabilities(tmp_path):
    models = "begin(model(1)).\n0.7::yes. 0.3::no.\n0.6::holds(a). 0.5::holds(b).\nend(model(1)).\n" + MODELS
    task = read_task([write(tmp_path, s=MODEL_SETTINGS, kb=models, bg=THINGS)])
    assert (task.examples[0].target, task.examples[0].facts) == ("yes", (("holds", "a"),))
    assert [line for line, _ in told(task)] == [2]


def test_aleph(tmp_path):
    task = read_task([aleph(tmp_path)])
    assert modes(task) == ["holds(+box, +-thing)", "made_of(+thing, [])"]
    assert [mode.lookahead for mode in task.bias.modes] == [1, 0]
    assert (task.target, task.classes, len(task.examples)) == ("heavy", ("pos", "neg"), 8)
    assert told(task) == [
        (8, "over/2 is not tested: no determination names it"),
        (9, "weight/2 is not tested: no determination names it"),
    ]
    assert "holds(A, B), made_of(B, iron) ?" in tree(task)


def test_aleph_in_one_file(tmp_path):
    task = read_task([write(tmp_path, pl=SECTIONS)])
    assert modes(task) == ["holds(+box, +-thing)", "made_of(+thing, [])"]
    assert [each.target for each in task.examples] == ["pos"] * 4 + ["neg"] * 4


def test_aleph_takes_constants_from_rules(tmp_path):
    b = ":- modeh(1, p(+number)).\n:- modeb(1, least(+number, #number)).\n:- determination(p/1, least/2).\n"
    b += "least(X, Y) :- number(Y), !, X >= Y.\nleast(X, X).\n"
    task = read_task([aleph(tmp_path, b, "p(3). p(5).", "p(1). p(2).")])
    assert modes(task) == ["least(+number, [1, 2, 3, 5])"]
    assert "least(A, 3) ?" in tree(task)


def test_aleph_predicts_an_argument(tmp_path):
    b = ":- modeh(1, class(+day, #class)).\n:- modeb(1, sky(+day, #sky)).\nsky(d1, sun). sky(d2, rain).\n"
    task = read_task([aleph(tmp_path, b, "class(d1, play). class(d2, stay).", "")])
    assert [(each.key, each.target) for each in task.examples] == [(("d1",), "play"), (("d2",), "stay")]
    task = read_task([aleph(tmp_path / "number", ":- set(dependent, 2).\n" + b, "class(d1, 1.5). class(d2, 2).", "")])
    assert (task.settings.mode, [each.target for each in task.examples]) == ("regress", [1.5, 2])


def test_aleph_says_how_a_tree_grows(tmp_path):
    b = ":- set(tree_type, class_probability).\n:- set(dependent, 2).\n:- set(minpos, 3).\n:- set(prune_tree, true).\n"
    b += ":- set(lookahead, 2).\n:- modeh(1, class(+day, -class)).\n:- modeb(1, temp(+day, -temp)).\n"
    b += ":- modeb(1, lteq(+temp, #temp)).\nlteq(X, Y) :- var(Y), !, X = Y.\nlteq(X, Y) :- X =< Y.\n"
    b += "temp(64). temp(70). table(d1, 64). table(d2, 70). temp(D, T) :- table(D, T).\n"
    task = read_task([aleph(tmp_path, b, "class(d1, play). class(d2, stay).", "")])
    assert [(str(mode), mode.lookahead) for mode in task.bias.modes] == [
        ("temp(+day, +-temp)", 2),
        ("lteq(+temp, [64, 70])", 0),
    ]
    assert (task.settings.minimal_cases, task.settings.pruning, task.settings.heuristic) == (3, "c45", "gain")
    Learner(task)


def test_names_that_are_operators(tmp_path):
    kb = "p(a, yes). p(b, no). table(a). dynamic(b, is). '<-'(a, b). goal(a). number(a)."
    settings = "predict(p(+k, -c)). rmode(table(+K)). rmode(dynamic(+K, #)). rmode('<-'(+K, -X)). rmode(number(+K))."
    task = read_task([write(tmp_path, s=settings, kb=kb, bg="table(X, Y) :- table(X), Y = 1.")])
    assert told(task) == [(1, "what the file says of number/1 is left out: it is Prolog's own")]
    assert len(Learner(task).coverage.table) == 4


def test_comparisons_are_tested(tmp_path):
    settings = KEYED_SETTINGS + "rmode((weight(+T, -W), W < #[4, 8])).\nrmode(weight(+T, -W)).\n"
    settings += "type(number >= number).\nrmode(+W >= #[7]).\nrmode(+W >= #).\n"
    task = read_task([keyed(tmp_path, settings)])
    assert task.bias.lookaheads[-1].followers == (Follower("<", (1, Argument("#", "_", (4, 8)))),)
    assert modes(task)[2:] == ["weight(+thing, -number)", "+number >= #", "+number >= #"] and told(task) == []
    Learner(task)


def test_files_that_are_loaded(tmp_path):
    (tmp_path / "more.pl").write_text(ALEPH_KNOWLEDGE)
    task = read_task([aleph(tmp_path, ALEPH + ":- [more].\n:- [elsewhere].\n")])
    assert ("made_of", "a", "iron") in task.facts
    assert (13, ":- [elsewhere] is not run") in told(task)


def test_old_files(tmp_path):
    folder = aleph(tmp_path)
    (folder / "boxes.b").write_bytes(("% Größe\n" + ALEPH + ALEPH_KNOWLEDGE).replace("\n", "\r\n").encode("latin-1"))
    assert len(read_task([folder]).examples) == 8


def test_what_is_named(tmp_path):
    (tmp_path / "in").mkdir()
    folder = keyed(tmp_path / "in" / "it")
    every = [
        read_task(each)
        for each in (
            [folder],
            [folder / "boxes"],
            [folder / "boxes.s"],
            [folder / "boxes.kb"],
            [folder.parent],
            [folder / "boxes.s", folder / "boxes.kb", folder / "boxes.bg"],
        )
    ]
    assert all(each.examples == every[0].examples for each in every)
    other = write(tmp_path / "other", s=MODEL_SETTINGS, kb=MODELS)
    (other / "second.s").write_text("")
    assert "there are several data sets: name one of" in wrong(other)
    assert wrong(folder / "boxe").endswith("no such file (did you mean 'boxes'?)")
    (tmp_path / "empty").mkdir()
    assert "there is no data set" in wrong(tmp_path / "empty")
    assert "is no data set that nppg reads" in wrong(write(tmp_path / "text", txt="") / "boxes.txt")


@pytest.mark.parametrize(
    ("files", "message"),
    [
        ({"s": KEYED_SETTINGS, "kb": "heavy(b1, ."}, "boxes.kb:1: Syntax error: "),
        ({"s": KEYED_SETTINGS + "rmode(p(+X)", "kb": KNOWLEDGE}, "boxes.s:16: Syntax error: "),
        ({"s": KEYED_SETTINGS, "kb": THINGS}, "boxes.s: there is no example in"),
        ({"s": "rmode(p(+X)).", "kb": "p(a)."}, "boxes.s: predict(p(+key, -class)) is missing"),
        ({"s": "predict(p(+a, +b)).", "kb": ""}, "boxes.s:1: p(+a, +b): give the key a + and what is predicted a -"),
        ({"s": "predict(heavy(+b, -c)).", "kb": KNOWLEDGE}, "boxes.s: no mode declares what to test"),
        ({"s": "predict(heavy(+b, -c)). rmode(q(+)).", "kb": KNOWLEDGE}, "boxes.s: no mode can be asked"),
        ({"s": "tilde_mode(cluster).", "kb": ""}, "boxes.s:1: tilde_mode(cluster) is none of nppg's"),
        ({"s": MODEL_SETTINGS, "kb": "begin(model(1)).\nyes."}, "boxes.kb:1: the model 1 does not end"),
        ({"s": MODEL_SETTINGS, "kb": "begin(model(1)).\nbegin(model(2))."}, "boxes.kb:1: the model 1 has not ended"),
        (
            {"s": MODEL_SETTINGS, "kb": "\nbegin(model(1)). yes. no. end(model(1))."},
            "boxes.kb:2: the model 1 has two classes, yes and no",
        ),
        ({"b": ALEPH}, "boxes.b: there are no positive examples: "),
        ({"b": ALEPH, "f": POSITIVE}, "boxes.b: there are no negative examples"),
        ({"b": ":- set(dependent, 3).", "f": "p(1)."}, "boxes.b:1: dependent has to be an argument of p/1"),
        ({"b": "p(" + "f(" * 2000 + "x" + ")" * 2000 + ").", "f": POSITIVE}, "brackets stand in each other"),
    ],
)
def test_mistakes(tmp_path, files, message):
    assert message in wrong(write(tmp_path, **files))


@pytest.mark.parametrize("make", [keyed, aleph, lambda folder: write(folder, s=MODEL_SETTINGS, kb=MODELS, bg=THINGS)])
def test_convert_is_read_again(tmp_path, make, capsys):
    folder = make(tmp_path / "given")
    assert run(["convert", str(folder), "--output", str(tmp_path / "own")]) == 0
    assert f"next: nppg tilde fit {tmp_path / 'own' / 'boxes.yaml'}" in capsys.readouterr().out
    given, own = read_task([folder]), read_task([tmp_path / "own"])
    for name in ("name", "target", "classes", "settings", "background"):
        assert getattr(given, name) == getattr(own, name)
    assert dataclasses.replace(own.bias, file=given.bias.file) == given.bias
    assert sorted(map(str, own.facts)) == sorted(map(str, given.facts))
    assert own.left_out == ()
    for before, after in zip(given.examples, own.examples, strict=True):
        assert dataclasses.replace(before, line=0) == dataclasses.replace(after, line=0)
    assert tree(own) == tree(given)


def test_convert_keeps_numbers_names_and_weights(tmp_path):
    settings = "predict(q(+k, -v)). tilde_mode(regression). rmode('on top'(+X, #[\"a'b\", 1.5, on]))."
    task = read_task([write(tmp_path, s=settings, kb="q('K k', 2.5). 'on top'('K k', on).")])
    example = dataclasses.replace(task.examples[0], weight=0.1 + 0.2, facts=(("own fact", -math.pi),))
    task = dataclasses.replace(task, examples=(example,))
    for name, text in files_of(task).items():
        (tmp_path / "again").mkdir(exist_ok=True)
        (tmp_path / "again" / name).write_bytes(text)
    again = read_task([tmp_path / "again"])
    assert dataclasses.replace(again.examples[0], line=0) == dataclasses.replace(example, line=0)
    assert again.bias.modes == task.bias.modes


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("modes:", "mode:", "boxes.yaml:2:1: the key 'modes' is missing"),
        ("holds(+ box, +- thing)", "holds(+ box", "Syntax error"),
        ("  mode: classify", "  mode: guess", "mode must be classify or regress"),
        ("boxes_facts.pl", "nowhere.pl", "nowhere.pl: cannot be read"),
        ("boxes_examples.pl", "boxes_facts.pl", "boxes_facts.pl:1: example(Key, Target, Facts, Weight) is wanted"),
    ],
)
def test_mistakes_in_our_own(tmp_path, old, new, message):
    task = read_task([keyed(tmp_path / "given")])
    for name, text in files_of(task).items():
        (tmp_path / name).write_bytes(text.replace(old.encode(), new.encode()) if name == "boxes.yaml" else text)
    assert message in wrong(tmp_path / "boxes.yaml")
