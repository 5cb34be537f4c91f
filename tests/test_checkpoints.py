"""A run that was stopped and gone on with is the run that was never stopped, to the byte."""

from __future__ import annotations

import csv
import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from test_seeds import SETTINGS

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.records import fields_of, table_of, value_of
from nppg.cli.main import main
from nppg.errors import NppgError
from nppg.experiments import checkpoints, run_files, train
from nppg.experiments.checkpoints import Checkpoints
from nppg.experiments.runs import run
from nppg.learning.options import Common, Options
from nppg.logic.query import Literal, Real, Var
from nppg.policy.copies import CHECKPOINT
from nppg.rrl.options import RIBOptions, TGOptions, TrendiOptions
from nppg.trees.tree import Leaf
from nppg.worlds.domain import Domain

SECOND = {"step": "second-order", "min_examples": 20}
WAYS: dict[str, Common] = {
    "gradient": Options(20, seed=1, min_examples=20),
    "replay": Options(16, seed=2, replay=30, line_search=1, **SECOND),
    "critic": Options(16, seed=3, critic="value", normalise="yes", critic_trees=2, guidance=0.3, **SECOND),
    "iterations": Options(120, seed=4, episodes_per_iteration=50, min_examples=20),
    "imitation": Options(60, seed=5, imitation="self", replay=20, floor=0.2, guidance=0.5, **SECOND),
    "tg": TGOptions(25, seed=6, min_sample=20, significance=0.2),
    "rib": RIBOptions(25, seed=7, max_instances=12),
    "trendi": TrendiOptions(25, seed=8, max_instances=12, min_sample=20, min_instances=5, significance=0.5),
}


@pytest.fixture
def world() -> Domain:
    return Domain("blocks_world", {"blocks": 4})


@pytest.fixture(autouse=True)
def no_pictures(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(run_files, "_draw", lambda *_: False)


def told(learning: train.Learning) -> str:
    """All that a run hangs on, as it is stored."""
    table = table_of(learning.saved(), [*checkpoints._KINDS, *fields_of(Literal)])
    return json.dumps(table)


def all_of(learning: train.Learning, bias: LanguageBias) -> str:
    """The same in words; what is shared may be another thing, and the last episode has numbers of classes in it."""
    saved = heard(told(learning), bias)
    if "regressor" in saved:
        del saved["recent"]
    return repr(saved)


def heard(text: str, bias: LanguageBias) -> Any:
    return value_of(json.loads(text), [*checkpoints._KINDS, *checkpoints._literals(bias)])


@pytest.mark.parametrize("way", WAYS)
def test_a_run_can_be_stopped_after_any_episode(world: Domain, plain_bias: LanguageBias, way: str) -> None:
    options, stored = WAYS[way], []
    if way == "imitation":
        world = Domain("blocks_world", {"blocks": 3})  # whose states are met again

    def is_over(learning: train.Learning) -> Callable[[], bool]:
        return lambda: bool(stored.append(told(learning)))

    whole = train.learning_of(world, plain_bias, options)
    *_, last = whole.iterations(is_over(whole))
    whole_policy, end = last.policy.stored()[0], all_of(whole, plain_bias)
    assert len(stored) == options.episodes and whole_policy.trees
    step = 1 if way == "gradient" else max(1, options.episodes // 5)
    for text in stored[::step]:
        resumed = train.learning_of(world, plain_bias, options)
        resumed.resume(heard(text, plain_bias))
        *_, last = resumed.iterations(lambda: False)
        found = last.policy.stored()[0]
        assert (found.trees, found.comments) == (whole_policy.trees, whole_policy.comments)
        assert last.policy.stored()[1] == whole.policy.stored()[1]
        assert all_of(resumed, plain_bias) == end


# ---------------------------------------------------------------- the files


def kept(monkeypatch: pytest.MonkeyPatch) -> list[bytes]:
    """The checkpoints that are written from now on, one after every episode."""
    found: list[bytes] = []
    write = checkpoints.write

    def noted(path: Path, *given: Any) -> None:
        write(path, *given)
        found.append(path.read_bytes())

    monkeypatch.setattr(checkpoints, "write", noted)
    monkeypatch.setattr(Checkpoints, "are_due", property(lambda _: True))
    return found


def files(folder: Path) -> dict[str, Any]:
    """What a run has written, but for its seconds and the checksum that is over them, too."""
    summary = json.loads((folder / "run.json").read_text())
    del summary["seconds"], summary["sha256"]
    if summary["last"]:
        del summary["last"]["seconds"]
    curve = []
    if (folder / "curve.csv").exists():
        text = (folder / "curve.csv").read_text().splitlines()
        curve = [{name: value for name, value in row.items() if name != "seconds"} for row in csv.DictReader(text)]
    return {"model": (folder / "model.pl").read_bytes(), "run": summary, "curve": curve}


@pytest.mark.parametrize("starts", [None, 10])
def test_the_files_are_the_same_to_the_byte(
    world: Domain, plain_bias: LanguageBias, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, starts: int | None
) -> None:
    options = WAYS["gradient"]
    until_return = None if starts is None else 99.0
    with monkeypatch.context() as patched:
        stored = kept(patched)
        run(world, plain_bias, options, tmp_path / "whole", 5, starts, until_return=until_return)
    assert len(stored) == options.episodes
    for at, checkpoint in enumerate(stored[::6]):
        folder = tmp_path / str(at)
        folder.mkdir()
        (folder / CHECKPOINT).write_bytes(checkpoint)
        run(world, plain_bias, options, folder, 5, starts, until_return=until_return, resume=True)
        assert files(folder) == files(tmp_path / "whole")


@pytest.mark.parametrize("way", ["gradient", "tg"])
def test_an_interrupt_keeps_every_episode(
    world: Domain, plain_bias: LanguageBias, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, way: str
) -> None:
    """Also the randomness of the one that it hits."""
    options, left = replace(WAYS[way], guidance=0.5), iter(range(10))

    def start(rng: np.random.Generator) -> Any:
        found = Domain.start(world, rng)
        if next(left, None) is None:
            raise KeyboardInterrupt
        return found

    run(world, plain_bias, options, tmp_path / "whole", 0)
    with monkeypatch.context() as patched, pytest.raises(KeyboardInterrupt):
        patched.setattr(world, "start", start)
        run(world, plain_bias, options, tmp_path / "run", 0)
    assert checkpoints.read(tmp_path / "run" / CHECKPOINT).run["count"] == 10
    run(world, plain_bias, options, tmp_path / "run", 0, resume=True)
    assert files(tmp_path / "run") == files(tmp_path / "whole")


@pytest.mark.parametrize("world", ["gym", "pddl"])
def test_a_folder_has_all_that_it_takes_to_go_on(world: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    if world == "gym":
        pytest.importorskip("gymnasium")
    arguments = [*SETTINGS[world], "--seed", "1", "--max-depth", "3", "--quiet"]
    with monkeypatch.context() as patched:
        stored = kept(patched)
        assert main(["train", *arguments, "--output", str(tmp_path / "whole")]) == 0
    for at, checkpoint in enumerate(stored[:: len(stored) // 2]):
        folder = tmp_path / str(at)
        folder.mkdir()
        (folder / CHECKPOINT).write_bytes(checkpoint)
        assert main(["train", "--resume", str(folder), "--quiet"]) == 0
        found, whole = ({path.name for path in each.iterdir()} for each in (folder, tmp_path / "whole"))
        assert found == whole and files(folder) == files(tmp_path / "whole")


def test_training_goes_on_from_a_folder(world: Domain, plain_bias: LanguageBias, tmp_path: Path) -> None:
    options = WAYS["gradient"]
    run(world, plain_bias, options, tmp_path, 0)
    *_, whole = train.train(world, plain_bias, replace(options, episodes=30))
    first, *_, last = train.train(world, plain_bias, replace(options, episodes=30), resume=tmp_path)
    assert first.episodes > 0 and last.policy.trees == whole.policy.trees
    with pytest.raises(NppgError, match=r"another run: its options\.seed is 1, not 2"):
        train.train(world, plain_bias, replace(options, seed=2), resume=tmp_path)


def test_a_run_may_be_given_more_episodes(world: Domain, plain_bias: LanguageBias, tmp_path: Path) -> None:
    for way in ("gradient", "tg"):
        few, more = WAYS[way], replace(WAYS[way], episodes=33)
        run(world, plain_bias, more, tmp_path / f"{way}-whole", 10)
        run(world, plain_bias, few, tmp_path / way, 10)
        run(world, plain_bias, more, tmp_path / way, 10, resume=True)
        assert files(tmp_path / way) == files(tmp_path / f"{way}-whole")
        with pytest.raises(NppgError, match="has 33 episodes already, more than"):
            run(world, plain_bias, few, tmp_path / way, 10, resume=True)


# ---------------------------------------------------------------- records


terms = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text(max_size=3),
    lambda inner: st.lists(inner, max_size=3)
    | st.tuples(inner, inner)
    | st.dictionaries(st.text(max_size=3), inner, max_size=3),
    max_leaves=12,
)


@settings(max_examples=60, deadline=None)
@given(terms)
def test_records_are_the_value_again(value: Any) -> None:
    assert repr(value_of(json.loads(json.dumps(table_of([value]))))) == repr([value])


def test_records_keep_what_is_shared_and_every_bit() -> None:
    shared, numbers = [1, 0.1 + 0.2], np.array([[True, False]])
    literal = Literal("p", (Var(0), Real(1.0), 1, "a"))
    value = {"a": shared, "b": shared, "c": numbers, "d": (literal, Leaf(-0.0, 2)), "e": b"\0\xff", "f": np.float64(3)}
    kinds = [*checkpoints._KINDS, *fields_of(Literal)]
    found = value_of(json.loads(json.dumps(table_of(value, kinds))), kinds)
    assert found["a"] is found["b"] and found["a"] == shared and found["e"] == b"\0\xff"
    assert found["c"].dtype == bool and found["c"].tolist() == [[True, False]] and type(found["f"]) is np.float64
    assert repr(found["d"]) == repr((literal, Leaf(-0.0, 2))) and type(found["d"][0].args[1]) is Real
    deep: Any = ()
    for _ in range(20_000):
        deep = (deep,)
    assert len(table_of(deep)) == 20_001


@pytest.mark.parametrize(
    "table", [[], [["object"]], [["list", [0]]], [["list", [-1]]], [["ndarray", "O", "", 1]], [[1]]]
)
def test_what_is_no_record_is_refused(table: Any) -> None:
    with pytest.raises((ValueError, TypeError, LookupError)):
        value_of(table)
