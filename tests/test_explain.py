"""Rules in plain English: the sentences that a bias gives, in the order that the potential gives."""

from __future__ import annotations

import os
import subprocess
from dataclasses import replace
from pathlib import Path
from random import Random

import pytest
from samples import random_query, resigned, value_of_list, visited

from nppg.bias.language_bias import LanguageBias
from nppg.bridge import home as prolog_home
from nppg.cli.main import main
from nppg.learning.options import Options
from nppg.learning.training import train
from nppg.logic.forms import Forms
from nppg.policy.policy import Policy
from nppg.rules.explain import explained, sentences
from nppg.trees.tree import Rule, from_rules
from nppg.worlds.domain import Domain

BLOCKS = """\
% First choice: move Block onto Place, if the goal wants Block on Place.
delta(1, move(Block, Place), 20.0) :- goal_on(Block, Place), !.
% Otherwise last choice: move any block onto Place, if Place is clear.
delta(1, move(_, Place), -1.0) :- clear(Place), !.
% Otherwise first choice: move Block onto floor, if the goal wants Block2 on some block and Block is above Block2.
delta(1, move(Block, floor), 20.0) :- goal_on(Block2, _), above(Block, Block2), !.
% Otherwise second choice: move Block onto any place, if some Place is on Block and some place is above Place.
delta(1, move(Block, _), 10.0) :- on(Place, Block), above(_, Place), !.
% Otherwise last choice: move Block onto Place, if Block is of same height compared with Place.
delta(1, move(Block, Place), -1.0) :- compheight(Block, Place, same), !.
% Otherwise third choice: any other action.
delta(1, move(_, _), 0.0).
"""
DELIVERY = """\
% First choice: drop Parcel, if Parcel is wanted in Room and the robot is in Room.
delta(1, drop(Parcel), 10.0) :- wanted(Parcel, Room), at(Room), !.
% Otherwise last choice: any other action, if Parcel is wanted in some room and the robot holds Parcel.
delta(1, _, 0.0) :- wanted(Parcel, _), holding(Parcel), !.
% Otherwise first choice: go to any room, if the robot holds nothing.
delta(1, go(_), 10.0) :- empty_handed, !.
% Otherwise first choice: pick up any parcel.
delta(1, pick(_), 10.0) :- !.
% Otherwise last choice: any other action.
delta(1, _, 0.0).
"""
SUM = """\
% More attractive by 0.01235: move Block onto any place, if Block is clear.
delta(1, move(Block, _), 0.012345678) :- clear(Block), !.
% Otherwise as attractive as before: move any block onto floor.
delta(1, move(_, floor), 0.0) :- !.
% Otherwise less attractive by 0.5: any other action.
delta(1, move(_, _), -0.5).
% More attractive by 1: any action.
delta(2, move(_, _), 1.0).
"""
LITERALS = """\
% First choice: move(Block, Place), if goal_on(Block, Place).
delta(1, move(Block, Place), 10.0) :- goal_on(Block, Place), !.
% Otherwise last choice: move(_, floor), if on(Place, 'A b') and Place is clear and some Place2 is clear.
delta(1, move(_, floor), 0.0) :- on(Place, 'A b'), clear(Place), clear(Place2), on(Place2, Place), !.
% Otherwise last choice: any other action.
delta(1, move(_, _), 0.0).
"""


def rules_of(text: str) -> list[str]:
    return [line for line in text.splitlines() if line.startswith("delta")]


def written_by_hand(domain: Domain, bias: LanguageBias, text: str, path: Path) -> Policy:
    """The policy of a model file with these rules."""
    Policy(domain, bias).save(path)
    rules = rules_of(text)
    trees = rules[-1][len("delta(")]
    text = path.read_text().replace("model(trees, 0)", f"model(trees, {trees})")
    resigned(path, text + "\n".join(rules) + "\n")
    return Policy.load(path)


def lines_of(policy: Policy, bias: LanguageBias) -> list[str]:
    return [line for tree in range(len(policy.trees)) for line in explained(policy, tree + 1, bias)]


@pytest.mark.parametrize(
    ("domain", "bias", "text"), [("four_blocks", "relational", BLOCKS), ("delivery",) * 2 + (DELIVERY,)]
)
def test_a_list_of_rules(request: pytest.FixtureRequest, domain: str, bias: str, text: str, tmp_path: Path) -> None:
    given = request.getfixturevalue(f"{bias}_bias")
    policy = written_by_hand(request.getfixturevalue(domain), given, text, tmp_path / "model.pl")
    assert "\n".join(lines_of(policy, given)) + "\n" == text


def test_a_sum_of_trees(four_blocks: Domain, relational_bias, tmp_path: Path) -> None:
    policy = written_by_hand(four_blocks, relational_bias, SUM, tmp_path / "model.pl")
    assert lines_of(policy, relational_bias) == SUM.splitlines()


def test_a_literal_without_a_sentence_is_its_text(four_blocks: Domain, relational_bias, tmp_path: Path) -> None:
    policy = written_by_hand(four_blocks, relational_bias, LITERALS, tmp_path / "model.pl")
    clear = replace(relational_bias, sentences={"clear": "{1} is clear"})
    shown = lines_of(policy, clear)
    assert shown[0] == LITERALS.splitlines()[0]
    assert shown[2] == LITERALS.splitlines()[2].replace("is clear.", "is clear and on(Place2, Place).")
    other = replace(clear, types={"clear": ("place", "place"), "on": ("place", "place")})
    assert "clear(Place) and clear(Place2)" in lines_of(policy, other)[2]


def test_one_rule_is_no_preference(four_blocks: Domain, plain_bias, tmp_path: Path) -> None:
    policy = written_by_hand(four_blocks, plain_bias, "delta(1, _, 3.0).", tmp_path / "model.pl")
    assert sentences(policy, 1, plain_bias) == ["No preference: any action."]


PLACES = ["first", "second", "third", "fourth", "fifth", "sixth"]


@pytest.mark.parametrize("seed", range(6))
def test_the_sentences_order_the_actions_as_the_potential_does(setting, seed: int) -> None:
    domain, bias, refiner, table = setting
    random = Random(seed)
    ordered = [Rule(random_query(refiner, 1 + i % 3, random), float(random.randint(-3, 3))) for i in range(6)]
    ordered.append(Rule((), float(random.randint(-3, 3))))
    roots = len(bias.roots)
    policy = Policy(domain, bias, table)
    policy.add(from_rules(ordered, Forms(roots).deciding_tests))
    said = sentences(policy, 1, bias)
    values = [float(line.split(", ")[-1].rstrip(").")) for line in (each.split(" :- ")[0] for each in policy.rules(1))]
    leads = [each.split(":")[0].lower().removeprefix("otherwise ") for each in said]
    place = {lead: PLACES.index(word) if (word := lead.split()[0]) in PLACES else 99 for lead in leads}
    by_value = dict(zip(values, (place[lead] for lead in leads), strict=True))
    assert all(by_value[value] == place[lead] for value, lead in zip(values, leads, strict=True))
    assert [by_value[value] for value in sorted(by_value, reverse=True)][:-1] == list(range(len(by_value) - 1))
    for state in visited(domain, 6, seed=seed):
        actions = domain.situation(state).actions
        places = [by_value[value_of_list(ordered, bias, state, action)] for action in actions]
        potentials = policy.potentials(state, actions)
        assert [i for i, each in enumerate(places) if each == min(places)] == [
            i for i, each in enumerate(potentials) if each == potentials.max()
        ]


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("run")
    options = f"--set blocks=4 --episodes 200 --step second-order --evaluate-every 0 --quiet --output {folder}".split()
    assert main(["train", "blocks_world", *options]) == 0
    return folder


def test_explained_rules_are_written_as_comments(run: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["distill", str(run / "model.pl")]) == 0
    plain = capsys.readouterr().out.splitlines()[:-1]
    silent = (run / "rules.pl").read_text()
    assert main(["distill", str(run / "model.pl"), "--explain"]) == 0
    shown = capsys.readouterr().out.splitlines()[:-1]
    assert shown[1::2] == plain and shown[0].startswith("% First choice: move ")
    text = (run / "rules.pl").read_text()
    assert text.endswith("\n".join(shown) + "\n")
    assert [line for line in text.splitlines() if line not in shown[::2]][1:] == silent.splitlines()[1:]
    assert Policy.load(run / "rules.pl").rules(1) == plain

    assert main(["show", str(run / "rules.pl"), "--explain"]) == 0
    assert capsys.readouterr().out.splitlines()[1:-1] == shown
    assert main(["show", str(run / "rules.pl")]) == 0
    assert capsys.readouterr().out.splitlines()[1:-1] == plain
    assert main(["show", str(run / "model.pl"), "--explain", "--tree", "2"]) == 0
    assert " attractive " in capsys.readouterr().out.splitlines()[1]


def test_plain_prolog_loads_explained_rules(run: Path) -> None:
    assert main(["distill", str(run / "model.pl"), "--explain"]) == 0
    home = prolog_home.linked().home
    assert home is not None
    binaries = [*home.glob("bin/*/swipl"), *home.parent.parent.glob("bin/swipl"), Path("/usr/bin/swipl")]
    goal = "state([on(b1, floor), on(b2, floor), goal_on(b1, b2)]), best_action(A), print(A)"
    result = subprocess.run(
        [str(next(each for each in binaries if each.exists())), "-g", goal, "-t", "halt", "rules.pl"],
        cwd=run,
        env={**os.environ, "SWI_HOME_DIR": str(home)},
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert (result.stdout, result.stderr) == ("move(b1,b2)", "")


def test_where_the_sentences_come_from(run: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    output = tmp_path / "rules.pl"
    assert main(["distill", str(run / "model.pl"), "--output", str(output)]) == 0
    capsys.readouterr()
    assert main(["show", str(output), "--explain"]) == 2
    assert "the model names no language bias; give one by --bias" in capsys.readouterr().err
    assert main(["show", str(output), "--explain", "--bias", "blocks_world"]) == 0
    assert "% First choice: move " in capsys.readouterr().out
    assert main(["show", str(output), "--explain", "--format", "dot"]) == 2
    assert "--format dot" in capsys.readouterr().err


def test_sentences_change_nothing_that_is_learned(four_blocks: Domain, plain_bias) -> None:
    learned = []
    for bias in (plain_bias, replace(plain_bias, sentences={}, source=b"")):
        *_, last = train(four_blocks, bias, Options(episodes=60))
        learned.append([last.policy.rules(tree + 1) for tree in range(len(last.policy.trees))])
    assert plain_bias.sentences and learned[0] == learned[1] and len(learned[0]) > 2
