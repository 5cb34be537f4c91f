"""The reader of language-bias files: what it reads, and what it says about mistakes."""

from __future__ import annotations

import json
from dataclasses import Field, fields, replace
from pathlib import Path
from typing import Any

import jsonschema
import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from nppg.bias.declarations import EQUALITY, Argument, Mode, Template, TreeLimits
from nppg.bias.language_bias import LanguageBias
from nppg.bias.modes import MODE_KEYS
from nppg.bias.reader import KEYS, REQUIRED
from nppg.errors import NppgError, Problem
from nppg.experiments.learners import LEARNERS, option_problems
from nppg.learning.options import kind_of
from nppg.logic.query import OPEN

SHIPPED = Path(__file__).parent.parent / "language_bias"
FILES = sorted(SHIPPED.glob("*.yaml"))
SCHEMA = json.loads((SHIPPED / "schema.json").read_text())

HEAD = """\
action: move(+block, +place)
goal: goal_on(-block, -block)
subtypes: {block: place}
types:
  on: [block, place]
  clear: [block]
  level: [place, height]
"""


def read(text: str) -> LanguageBias:
    return LanguageBias.parse(text, "b.yaml")


def problems(text: str) -> list[str]:
    with pytest.raises(NppgError) as caught:
        read(text)
    return [str(each).removeprefix("b.yaml:") for each in caught.value.problems]


def mode_problems(*modes: str) -> list[str]:
    """The problems of modes, the first of which stands on line 9."""
    return problems(HEAD + "modes:\n" + "".join(f"  - {mode}\n" for mode in modes))


def mode(text: str) -> Mode:
    return read(HEAD + f"modes:\n  - {text}\n").modes[0]


# ---------------------------------------------------------------- what is read


def test_a_whole_file() -> None:
    bias = read(
        HEAD
        + """\
modes:
  - clear(+block)
  - on(+, +-)
  - on(+block, floor)
  - {literal: "on(+block, -block)", lookahead: 1}
  - level(+, [1, 2.5, 'Top', -3])
  - equal(+place, floor)
lookahead: 2
max_variables: 3
tree: {max_depth: 3, min_variance: 1e-3, significance: 0.05}
"""
    )
    assert bias.actions == (Template("move", ("block", "place")),)
    assert bias.goal == Template("goal_on", ("block", "block"))
    assert bias.roots == ("block", "place", "block", "block")
    assert bias.types["on"] == ("block", "place") and bias.types["goal_on"] == ("block", "block")
    plus = Argument("+", "block")
    assert bias.modes == (
        Mode("clear", (plus,)),
        Mode("on", (plus, Argument("+-", "place"))),
        Mode("on", (plus, Argument("#", "place", ("floor",)))),
        Mode("on", (plus, Argument("-", "block")), lookahead=1),
        Mode("level", (Argument("+", "place"), Argument("#", "height", (1, 2.5, "Top", -3)))),
        Mode("=", (Argument("+", "place"), Argument("#", "place", ("floor",)))),
    )
    assert [(each.line, each.column) for each in bias.modes][2:4] == [(11, 5), (12, 16)]
    assert (bias.actions[0].line, bias.actions[0].column) == (1, 9)
    assert (bias.max_lookahead, bias.max_variables) == (2, 3)
    assert bias.tree == TreeLimits(max_depth=3, min_variance=1e-3, significance=0.05)


def test_what_may_be_left_out() -> None:
    bias = read("action: jump(cell)\ntypes: {wet: [cell], rain: []}\nmodes: [wet(+), rain]\n")
    assert (bias.goal, bias.subtypes, bias.max_lookahead, bias.max_variables) == (None, {}, 0, 4)
    assert bias.tree == TreeLimits() and bias.modes[1] == Mode("rain", ())


def test_sentences() -> None:
    text = HEAD + "modes: [clear(+)]\nsentences:\n  move: put {1} on {2}\n  clear: >\n    nothing is on\n    {1}\n"
    bias = read(text)
    assert valid(text) and bias.sentences == {"move": "put {1} on {2}", "clear": "nothing is on {1}"}
    assert read(HEAD + "modes: [clear(+)]\n").sentences == {}


def test_options() -> None:
    """Numbers are numbers, all else is text; which options there are is not the reader's business."""
    text = MINIMAL + "options:\n  step: second-order\n  normalise: yes\n  critic: no\n  a: 'on'\n  discount: 0.9\n"
    bias = read(text + "  min_examples: 500\n  clip: 1e-3\n")
    assert bias.options == {
        "step": "second-order",
        "normalise": "yes",
        "critic": "no",
        "a": "on",
        "discount": 0.9,
        "min_examples": 500,
        "clip": 0.001,
    }
    assert bias.option_places["a"] == ((8, 3), (8, 7))
    assert read(MINIMAL).options == {} and read(MINIMAL + "options: {}\n").options == {}


def test_names_that_yaml_takes_for_truth_values() -> None:
    bias = read("action: yes(+no)\ntypes: {on: [no, off], off: []}\nmodes:\n  - on(+no, [yes, true])\n  - off\n")
    assert bias.types == {"on": ("no", "off"), "off": (), "yes": ("no",)}
    assert bias.modes[0].args[1].constants == ("yes", "true")


def test_anchors() -> None:
    bias = read("action: go(+x)\ntypes: {p: &t [x, x], q: *t}\nmodes:\n  - &m p(+, -)\n  - q(+, +)\n")
    assert bias.types["q"] == ("x", "x") and (bias.modes[0].line, bias.modes[0].column) == (4, 8)


def test_a_comma_between_brackets_is_part_of_its_literal() -> None:
    """In a list and in a mapping, on several lines, behind an anchor."""
    bias = read(
        "action: [pick(+x, +y), drop]\ntypes: {p: [x, y], q: [x, y, x]}\n"
        "modes: [p(+, -), {literal: q(+, -, +), lookahead: 1}, p(+, a),\n"
        "  q(+,  # the first\n    +, +), &q q(+, -, -)]\nlookahead: 1\n"
    )
    assert list(map(str, bias.actions)) == ["pick(x, y)", "drop"]
    assert [(str(mode), mode.lookahead, mode.line, mode.column) for mode in bias.modes] == [
        ("p(+x, -y)", 0, 3, 9),
        ("q(+x, -y, +x)", 1, 3, 28),
        ("p(+x, a)", 0, 3, 55),
        ("q(+x, +y, +x)", 0, 4, 3),
        ("q(+x, -y, -x)", 0, 5, 15),
    ]
    with pytest.raises(NppgError):
        read("action: go(+x)\ntypes: {p: [x, x]}\nmodes: [&a p(+, *a, +)]\n")


def test_fits_is_strict_and_transitive() -> None:
    bias = read("action: go(+a)\nsubtypes: {a: b, b: c}\ntypes: {p: [c]}\nmodes: [p(+)]\n")
    assert bias.fits("a", "a") and bias.fits("a", "c")
    assert not bias.fits("c", "a") and not bias.fits("a", "x")
    assert not replace(bias, subtypes={"a": "b", "b": "a"}).fits("a", "x")


# ---------------------------------------------------------------- mistakes

MINIMAL = "action: go(+x)\ntypes: {p: [x], q: [x, x]}\nmodes: [p(+)]\n"
PLACEHOLDER_WANTED = "a placeholder is the number of an argument in braces, like {1}, not"
SENTENCE_WANTED = 'a sentence like "{1} is clear", in quotes, is wanted, not'
CUT = "but the literal ends here: YAML ends a text at ' #', unless it is in quotes"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", ["the file is empty"]),
        ("# nothing\n", ["the file is empty"]),
        ("- a\n", ["1:1: a language bias is a mapping (key: value), not a list"]),
        ("on", ["1:1: a language bias is a mapping (key: value), not 'on'"]),
        (
            "action: [\n",
            ["2:1: not YAML: while parsing a flow node expected the node content, but found '<stream end>'"],
        ),
        ("types:\n\ton: [x]\n", ["2:1: a tab: YAML is indented by spaces"]),
        (MINIMAL + "---\na: b\n", ["4:1: a second YAML document begins here; a language bias is one"]),
        ("a: b\x07\n", ["1:5: the character '\\x07' has no place in YAML"]),
        ("[" * 5000, ["1: nested too deeply"]),
        ('a: "\\Uffffffff"\n', ["not YAML: Python int too large to convert to C int"]),
        (
            "goal: g(-x)\n",
            [
                "1:1: the key 'action' is missing",
                "1:1: the key 'modes' is missing",
                "1:1: the key 'types' is missing",
            ],
        ),
        (MINIMAL + "mode: []\n", ["4:1: unknown key 'mode' (did you mean 'modes'?)"]),
        (
            MINIMAL + "xyzzy: 1\n",
            [f"4:1: unknown key 'xyzzy'; known are {', '.join(KEYS)}"],
        ),
        (MINIMAL + "types: {}\n", ["4:1: the key 'types' is given twice (first on line 2)"]),
        (MINIMAL.replace("q:", "p:"), ["2:17: the key 'p' is given twice (first on line 2)"]),
        (MINIMAL + "? [a]\n: b\n", ["4:3: a key is wanted, not a list"]),
        (MINIMAL + "goal:\n", ["4:6: a template like goal_on(-block, -block) is wanted, not nothing"]),
        (
            MINIMAL + "goal: on\n",
            ["4:7: the goal is a template with arguments, like goal_on(-block, -block), not 'on'"],
        ),
        (
            MINIMAL.replace("go(+x)", "go"),
            [
                "1:9: the action is a template with arguments, like move(+block, +place), not 'go': an action without "
                "arguments stands in a list, [go]"
            ],
        ),
        (
            MINIMAL.replace("go(+x)", "[go(+x, +x), pick(+x, +y)]").replace("[p(+)]", "[p(+), q(+, 7 7), q(+, -]"),
            [
                "1:32: the type 'y' is used nowhere else",
                "3:22: ',' or ')' is wanted, not '7'",
                f"3:32: ',' or ')' is wanted, {CUT}",
            ],
        ),
        (MINIMAL + "goal: g(+x)\n", ["4:9: an argument of the goal is - and a type, like -block, not +x"]),
        (MINIMAL + "goal: p(-x, -x)\n", ["4:7: p takes 1 argument, p(x), not 2"]),
        (MINIMAL + "goal: [g]\n", ["4:7: a template like goal_on(-block, -block) is wanted, not a list"]),
        (
            MINIMAL.replace("go(+x)", "go(-x, +, 3, x)"),
            [
                "1:12: an argument of the action is + and a type, like +block, not -x",
                "1:16: an argument of the action is + and a type, like +block, not +",
                "1:19: an argument of the action is + and a type, like +block, not 3",
            ],
        ),
        (MINIMAL.replace("go(+x)", "go(+block)"), ["1:13: the type 'block' is used nowhere else"]),
        (
            HEAD.replace("+block,", "+blok,") + "modes: [clear(+)]\n",
            ["1:15: the type 'blok' is used nowhere else (did you mean 'block'?)"],
        ),
        (MINIMAL + "subtypes: x\n", ["4:11: subtypes is a mapping (key: value), not 'x'"]),
        (MINIMAL + "subtypes: {x: [y]}\n", ["4:15: a type is wanted, not a list"]),
        (
            MINIMAL + "subtypes: {x: +y, X: y}\n",
            ["4:15: a type is a lower-case name, not '+y'", "4:22: a type is a lower-case name, not 'X'"],
        ),
        (MINIMAL + "subtypes: {x: y, y: z, z: y}\n", ["4:21: the subtypes form a cycle: y < z < y"]),
        (MINIMAL + "subtypes: {x: x}\n", ["4:15: the subtypes form a cycle: x < x"]),
        (MINIMAL.replace("{p: [x], q: [x, x]}", "[x]"), ["2:8: types is a mapping (key: value), not a list"]),
        (MINIMAL.replace("[x],", "x,"), ["2:12: the types of 'p' are a list, like [block, place], not 'x'"]),
        (MINIMAL.replace("[x],", "[+x],"), ["2:13: a type is a lower-case name, not '+x'"]),
        (
            MINIMAL.replace("q:", "equal:"),
            ["2:24: equal/2 is built in and has no type declaration: its modes name the types"],
        ),
        (MINIMAL.replace("[p(+)]", "p(+)"), ["3:8: modes are a list of literals, not 'p(+)'"]),
        (MINIMAL.replace("[p(+)]", "[]"), ["3:8: at least one mode is wanted"]),
        (MINIMAL + "lookahead: yes\n", ["4:12: lookahead is a whole number of at least 0, not 'yes'"]),
        (MINIMAL + "max_variables: -1\n", ["4:16: max_variables is a whole number of at least 0, not '-1'"]),
        (MINIMAL + "max_variables: 1.5\n", ["4:16: max_variables is a whole number of at least 0, not '1.5'"]),
        (MINIMAL + "tree: on\n", ["4:7: tree is a mapping (key: value), not 'on'"]),
        (
            MINIMAL + "tree: {max_dept: 1, min_examples: 0, min_variance: nan, significance: 2}\n",
            [
                "4:8: unknown key 'max_dept' (did you mean 'max_depth'?)",
                "4:35: min_examples must be a whole number of at least 1, not 0",
                "4:52: min_variance must be a finite number of at least 0, not nan",
                "4:71: significance must be a number above 0 and at most 1, not 2",
            ],
        ),
        (MINIMAL + "tree: {max_depth: true}\n", ["4:19: max_depth is a number, not 'true'"]),
        (MINIMAL + "tree: {max_depth: 2.5}\n", ["4:19: max_depth must be a whole number of at least 0, not 2.5"]),
        (
            MINIMAL + "sentences: {q: '{1} is {3}, {x}', p: 'at {0}', pp: a, go: goes}\n",
            [
                "4:24: {3} stands for no argument of q(x, x)",
                f"4:29: {PLACEHOLDER_WANTED} '{{x}}'",
                f"4:42: {PLACEHOLDER_WANTED} '{{0}}'",
                "4:48: unknown key 'pp' (did you mean 'p'?)",
                "4:59: the sentence leaves out {1} of go(x)",
            ],
        ),
        (
            MINIMAL + "sentences:\n  p: '{1'\n  go: '1} goes'\n  p: '{1} twice'\n  q: on {2}\n",
            [
                f"5:7: {PLACEHOLDER_WANTED} '{{'",
                f"6:9: {PLACEHOLDER_WANTED} '}}'",
                "7:3: the key 'p' is given twice (first on line 5)",
                "8:6: the sentence leaves out {1} of q(x, x)",
            ],
        ),
        (
            MINIMAL + 'sentences: {p: "{1}\\nis", q: "{1}{1}{2}", go: {1}}\n',
            ["4:16: a sentence is one line", f"4:47: {SENTENCE_WANTED} a mapping"],
        ),
        (
            MINIMAL + "sentences: {p: , q: ' ', go: [a]}\n",
            [
                f"4:15: {SENTENCE_WANTED} nothing",
                f"4:22: {SENTENCE_WANTED} ' '",
                f"4:30: {SENTENCE_WANTED} a list",
            ],
        ),
        (MINIMAL + "sentences: [p]\n", ["4:12: sentences is a mapping (key: value), not a list"]),
        (
            MINIMAL.replace("go(+x)", "go(x") + "sentences: {go: '{1} goes', p: '{2}'}\n",
            [f"1:13: ',' or ')' is wanted, {CUT}", "4:33: {2} stands for no argument of p(x)"],
        ),
        (MINIMAL + "tree: {max_depth: [1]}\n", ["4:19: max_depth is a number, not a list"]),
        (MINIMAL + "options: second-order\n", ["4:10: options is a mapping (key: value), not 'second-order'"]),
        (
            MINIMAL + "options: {step: [gradient], seed: , seed: 1}\n",
            [
                "4:17: a value of step is wanted, not a list",
                "4:34: a value of seed is wanted, not nothing",
                "4:37: the key 'seed' is given twice (first on line 4)",
            ],
        ),
    ],
)
def test_mistakes_in_the_file(text: str, expected: list[str]) -> None:
    assert problems(text) == [each if each[0].isdigit() else f" {each}" for each in expected]


NO_THRESHOLD = "# is wanted, a threshold that is found from the examples"
NO_LITERAL = "a literal like on(+block, -block) is wanted, not"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("on(+)", "9:5: on takes 2 arguments, on(block, place), not 1"),
        ("on", "9:5: on takes 2 arguments, on(block, place), not 0"),
        ("clear(+, +)", "9:5: clear takes 1 argument, clear(block), not 2"),
        ("claer(+)", "9:5: 'claer' has no type declaration (did you mean 'clear'?)"),
        ("xyzzy(+)", "9:5: 'xyzzy' has no type declaration"),
        ("clear(+blok)", "9:11: the type 'blok' is declared nowhere (did you mean 'block'?)"),
        ("clear(+place)", "9:11: the type 'place' is neither 'block', as declared, nor a subtype of it"),
        ("'clear( +height)'", "9:13: the type 'height' is neither 'block', as declared, nor a subtype of it"),
        (
            "clear(X)",
            "9:11: 'X' is no lower-case name: write a variable as + or - and its type (+block), "
            "an atom in quotes ('X')",
        ),
        (
            "clear(_)",
            "9:11: '_' is no lower-case name: write a variable as + or - and its type (+block), "
            "an atom in quotes ('_')",
        ),
        ("clear(+Block)", "9:11: a type is a lower-case name, not 'Block'"),
        (
            "Clear(+)",
            "9:5: 'Clear' is no lower-case name: write a variable as + or - and its type (+block), "
            "an atom in quotes ('Clear')",
        ),
        ("clear(f(+))", "9:11: nested terms are not possible: f(...) can be no argument"),
        ("level(+, [])", "9:14: the set of constants is empty"),
        ("level(+, [0, 0])", "9:14: the set of constants holds one of them twice"),
        ("level(+, [+, 1])", "9:15: a constant is wanted, not '+'"),
        ("level(+, #[a])", f"9:13: an argument is wanted, {CUT}"),
        ('"level(+, #[a])"', "9:15: '#' has no place in a literal: write a set of constants as [a, b], without #"),
        ("on(+ +)", "9:10: ',' or ')' is wanted, not '+'"),
        ("on(+, +) :- true", "9:14: ':' has no place in a literal"),
        ("clear(+) clear", "9:14: the end of the literal is wanted, not 'clear'"),
        ("clear(+,)", "9:13: an argument is wanted, not ')'"),
        ("clear(1e999)", "9:11: the number is too large"),
        (f"clear({'9' * 5000})", "9:11: the number is too large"),
        ("clear('a)", '9:11: "\'" has no place in a literal: the quoted atom does not end'),
        ("5(+)", "9:5: a name is wanted, not the number 5"),
        ("clear(+\u00a0)", "9:12: the character '\\xa0' has no place here"),
        ("", f"9:4: {NO_LITERAL} nothing"),
        ("[clear]", f"9:5: {NO_LITERAL} a list"),
        ("equal(+, +place)", "9:11: equal has no declared types: write the type, like +block"),
        ("equal(+place, -place)", "9:19: equal compares existing variables: write +place, not -place"),
        ("equal(+place, +-place)", "9:19: equal compares existing variables: write +place, not +-place"),
        ("equal(floor, floor)", "9:5: equal compares a variable, like +block, with another or with a constant"),
        ("\"'='(+place)\"", "9:6: equal takes 2 arguments, not 1"),
        ("equal(+place)", "9:5: equal takes 2 arguments, not 1"),
        ("equal(+place, +plac)", "9:19: the type 'plac' is declared nowhere (did you mean 'place'?)"),
        ("X = Y", "9:7: '=' has no place in a literal: equality is written equal(+type, +type)"),
        ("+place =< #", f"9:14: {NO_THRESHOLD}: YAML ends a text at ' #', unless it is in quotes"),
        ('"+place =< 3"', f"9:16: {NO_THRESHOLD}"),
        ('"+place < #"', "9:13: '<' has no place in a literal: a threshold is written +type =< # or +type >= #"),
        ('"+place # 3"', "9:13: =< or >=, as in +weight =< #, is wanted, not '#'"),
        ('"+ =< #"', "9:6: a threshold is for an existing variable of a type, like +weight, not +"),
        ('"-place >= #"', "9:6: a threshold is for an existing variable of a type, like +weight, not -place"),
        ('"+plac =< #"', "9:6: the type 'plac' is declared nowhere (did you mean 'place'?)"),
        ("\"'=<'(+place, 3)\"", "9:6: =< and >= are built in: write +weight =< # for a threshold"),
        ("{literal: clear(+), lookahead: 1}", "9:36: lookahead 1 is more than the file's general maximum, 0"),
        ("{literal: clear(+), lookahead: on}", "9:36: lookahead is a whole number of at least 0, not 'on'"),
        ("{literal: clear(+), lookahed: 0}", "9:25: unknown key 'lookahed' (did you mean 'lookahead'?)"),
        ("{lookahead: 0}", "9:5: the key 'literal' is missing"),
        ("{literal: on(+, -, lookahead: 0}", f"9:22: ',' or ')' is wanted, {CUT}"),
        ("{literal: on(+, + +), lookahead: 0}", "9:23: ',' or ')' is wanted, not '+'"),
    ],
)
def test_mistakes_in_a_mode(text: str, expected: str) -> None:
    assert mode_problems(text) == [expected]


def test_a_mode_given_twice() -> None:
    assert mode_problems("on(+, -)", "on(+block, -place)", "on(+, +)") == [
        "10:5: the mode on(+block, -place) is given twice (first on line 9)"
    ]
    assert len(read(HEAD + "modes:\n- level(+, 1)\n- level(+, 1.0)\n- \"level(+, '1')\"\n").modes) == 3


def test_all_mistakes_are_reported_in_file_order() -> None:
    text = "max_variables: x\naction: go(X)\ntypes: {p: x}\nmodes: [q(+), p(+), p(+y)]\ntree: {max_depth: -1}\n"
    assert [each.split(":")[0] for each in problems(text)] == ["1", "2", "3", "4", "4", "5"]


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (None, ": cannot be read: No such file or directory"),
        (b"a: b\nc: \xff\n", ":2:4: not UTF-8: byte 0xff"),
    ],
)
def test_unreadable_files(tmp_path: Path, content: bytes | None, message: str) -> None:
    path = tmp_path / "b.yaml"
    if content is not None:
        path.write_bytes(content)
    with pytest.raises(NppgError) as caught:
        LanguageBias.load(path)
    assert str(caught.value) == f"{path}{message}"


def test_a_folder_and_an_impossible_path(tmp_path: Path) -> None:
    for path in (tmp_path, "a\0b"):
        with pytest.raises(NppgError, match="cannot be read"):
            LanguageBias.load(path)


def test_byte_order_mark_and_line_ends(tmp_path: Path) -> None:
    path = tmp_path / "b.yaml"
    path.write_bytes(b"\xef\xbb\xbf" + (HEAD + "modes:\n  - clear(+)\n").replace("\n", "\r\n").encode())
    bias = LanguageBias.load(path)
    assert (bias.file, bias.actions[0].column, bias.modes[0].line) == (str(path), 9, 9)


@pytest.mark.parametrize(
    "wrong",
    [
        {"max_depth": -1},
        {"max_depth": True},
        {"max_depth": 1.0},
        {"min_examples": 0},
        {"min_variance": float("nan")},
        {"min_variance": float("inf")},
        {"min_variance": -1e-9},
        {"min_variance": "0"},
        {"significance": 0.0},
        {"significance": 1.1},
        {"significance": float("nan")},
        {"significance": None},
    ],
)
def test_tree_limits_check_themselves(wrong: dict[str, Any]) -> None:
    with pytest.raises(NppgError, match=f"^{next(iter(wrong))} must be"):
        TreeLimits(**wrong)


# ---------------------------------------------------------------- against a domain


def test_check_against_a_domain() -> None:
    bias = read(HEAD + "modes:\n  - clear(+)\n  - on(+, +)\n  - equal(+place, +place)\n")
    predicates = {("clear", 1), ("on", 2), ("goal_on", 2)}
    assert bias.check(predicates, [("move", 2)]) == []
    assert bias.check({("cleer", 1), ("on", 3), ("on", 4)}, [("mov", 2)]) == [
        Problem("b.yaml", 1, 9, "the domain has no action move/2 (did you mean 'mov'?)"),
        Problem("b.yaml", 2, 7, "the domain has no predicate goal_on/2"),
        Problem("b.yaml", 9, 5, "the domain has no predicate clear/1 (did you mean 'cleer'?)"),
        Problem("b.yaml", 10, 5, "the domain has no predicate on/2 (it has on/3, on/4)"),
    ]


# ---------------------------------------------------------------- shipped files and schema


def plain(node: yaml.Node | None) -> Any:
    """The data of a composed document as an editor that reads YAML 1.2 sees it."""
    if isinstance(node, yaml.MappingNode):
        return {plain(key): plain(value) for key, value in node.value}
    if isinstance(node, yaml.SequenceNode):
        return [plain(each) for each in node.value]
    assert isinstance(node, yaml.ScalarNode)
    for kind in (int, float):
        try:
            return kind(node.value)
        except ValueError:
            pass
    return node.value


def valid(text: str) -> bool:
    return bool(jsonschema.Draft202012Validator(SCHEMA).is_valid(plain(yaml.compose(text))))


ABLATED = ("rover_numeric.yaml", "rover_relational.yaml")  # halves of a language, to compare and not to explain


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_shipped_files(path: Path) -> None:
    text = path.read_text()
    assert text.startswith("# yaml-language-server: $schema=schema.json\n") and valid(text)
    bias = LanguageBias.load(path)
    assert set(bias.sentences) == (set(bias.types) if path.name not in ABLATED else set())
    assert option_problems(bias) == []
    if not path.name.startswith("blocks_world"):
        return
    assert bias.roots == ("block", "place", "block", "block")
    assert all(bias.fits("place", arg.type) for mode in bias.modes for arg in mode.args if arg.kind != "#")
    new = {mode.name for mode in bias.modes if any(arg.kind == "-" for arg in mode.args)}
    assert new == ({"clear", "on", "above"} if "relational" in path.name else set())


def test_the_relational_bias_only_adds() -> None:
    plain_bias, relational = (LanguageBias.load(path) for path in FILES if path.name.startswith("blocks_world"))
    assert set(plain_bias.modes) < set(relational.modes)
    assert (plain_bias.types, plain_bias.tree) == (relational.types, relational.tree)
    assert plain_bias.sentences == relational.sentences


def test_the_schema_knows_the_same_keys_and_defaults() -> None:
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    properties = SCHEMA["properties"]
    assert tuple(properties) == KEYS and tuple(SCHEMA["required"]) == REQUIRED
    assert tuple(properties["modes"]["items"]["oneOf"][1]["properties"]) == MODE_KEYS
    limits = {name: each["default"] for name, each in properties["tree"]["properties"].items()}
    assert limits == {each.name: each.default for each in fields(TreeLimits)}
    bias = read(MINIMAL)
    assert properties["lookahead"]["default"] == bias.max_lookahead
    assert properties["max_variables"]["default"] == bias.max_variables


def test_the_schema_knows_the_options_of_all_learners() -> None:
    """With their kinds and bounds, which are the same for every learner that has an option."""

    def said(option: Field) -> dict[str, Any]:
        help, bounds = option.metadata["help"], option.metadata
        head = {"description": f"{help[0].upper()}{help[1:]}."}
        if "choices" in bounds:
            return head | {"enum": list(bounds["choices"])}
        if bounds.get("text"):
            return head | {"type": "string", "minLength": 1}
        most = {"maximum": bounds["high"]} if "high" in bounds else {}
        return head | {"type": "integer" if kind_of(option) is int else "number", "minimum": bounds["low"]} | most

    section = dict(SCHEMA["properties"]["options"]["properties"])
    assert section.pop("learner")["enum"] == list(LEARNERS)
    every = [each for kind in LEARNERS.values() for each in fields(kind)]
    assert section.keys() == {each.name for each in every}
    for each in every:
        expected = said(each)
        if each.name == "discount":  # gamma of returns, gamma of Q
            expected["description"] = section["discount"]["description"]
        assert section[each.name] == expected


@pytest.mark.parametrize(
    "text",
    [
        MINIMAL + "mode: []\n",
        "types: {}\n",
        MINIMAL + "goal: on\n",
        MINIMAL + "lookahead: -1\n",
        MINIMAL + "tree: {min_examples: 0}\n",
        MINIMAL + "tree: {significance: 0}\n",
        MINIMAL + "subtypes: {x: +y}\n",
        MINIMAL.replace("[p(+)]", "[]"),
        MINIMAL.replace("[p(+)]", "[{lookahead: 0}]"),
        MINIMAL.replace("[x],", "x,"),
        MINIMAL + "options: {seed: [1]}\n",
        MINIMAL + "sentences: {p: [a]}\n",
        MINIMAL + "sentences: {p: '{1} {x}'}\n",
        MINIMAL + "sentences: {p: '{1} }'}\n",
        MINIMAL + "sentences: {p: '{0} {1}'}\n",
    ],
)
def test_the_schema_refuses_what_the_reader_refuses(text: str) -> None:
    assert valid(MINIMAL) and not valid(text) and problems(text)


def test_the_example_of_the_manual() -> None:
    manual = (Path(__file__).parent.parent / "docs" / "language_bias.md").read_text()
    example = manual.split("```yaml\n")[1].split("```")[0]
    assert valid(example) and len(read(example).modes) == 6
    assert all(f"`{key}`" in manual for key in KEYS if key != "tree")
    assert all(f"`tree.{each.name}`" in manual for each in fields(TreeLimits))


# ---------------------------------------------------------------- laws

ATOMS = st.text(st.characters(exclude_categories=["C", "Z"]) | st.just(" "), max_size=5)
CONSTANTS = ATOMS | st.integers() | st.floats(allow_nan=False, allow_infinity=False)


def arguments(type_: str) -> st.SearchStrategy[Argument]:
    sets = st.lists(CONSTANTS, min_size=1, max_size=3, unique_by=lambda each: (type(each), repr(each)))
    return st.builds(Argument, st.sampled_from(["+", "-", "+-"]), st.just(type_)) | st.builds(
        Argument, st.just("#"), st.just(type_), sets.map(tuple)
    )


@settings(deadline=None)
@given(ATOMS.filter(lambda name: name.strip() and name not in {*EQUALITY, *OPEN}), arguments("x"), arguments("y"))
def test_a_printed_mode_is_read_back(name: str, first: Argument, second: Argument) -> None:
    expected = Mode(name, (first, second))
    text = yaml.safe_dump({"action": "'the action'(+x)", "types": {name: ["x", "y"]}, "modes": [str(expected)]})
    assert read(text).modes == (expected,)


WORDS = (*KEYS, *MODE_KEYS, "tree: {", "max_depth", "equal(", "on(+x, -y)", "p(+)", "&a ", "*a", "on", "-1", ".nan")
MARKS = ("\n  - ", ": ", ", ", " #", "---", "|\n", *"[]{}-+'\"#!>X1%\\\t\n")
SNIPPETS = st.sampled_from((*WORDS, *MARKS))


def assert_bias_or_located_problems(text: str) -> None:
    try:
        assert isinstance(read(text), LanguageBias)
    except NppgError as error:
        assert error.problems and all(each.file == "b.yaml" and "\n" not in each.message for each in error.problems)
        assert list(error.problems) == sorted(error.problems)


@settings(deadline=None)
@given(st.text() | st.lists(SNIPPETS | st.text(max_size=2), max_size=30).map("".join))
def test_any_text_gives_a_bias_or_located_problems(text: str) -> None:
    assert_bias_or_located_problems(text)


@settings(deadline=None)
@given(st.floats(0, 1), st.integers(0, 20), SNIPPETS | st.text(max_size=3))
def test_any_change_of_a_good_file_gives_a_bias_or_located_problems(where: float, length: int, change: str) -> None:
    text = FILES[0].read_text()
    start = int(where * len(text))
    assert_bias_or_located_problems(text[:start] + change + text[start + length :])
