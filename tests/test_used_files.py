"""A domain in several files is one domain: loaded for itself, hashed, copied and sent as a whole."""

from __future__ import annotations

import gc
import pickle
import shutil
import subprocess
import sys
from pathlib import Path

import janus_swi
import numpy as np
import pytest

from nppg import Domain, NppgError, Options, Policy, language_bias_of, open_domain, run
from nppg.policy.copies import write_copies

FILES = {
    "walk.pl": ":- module(walk, []).\n:- use_module(moves).\n:- include('parts/rest').\n:- ensure_loaded(parts/far).\n"
    ":- fluent at/1.\nstart([at(1)]).\naction(go).\naction(stay).\neffect(go, [at(X)], [at(Y)]) :- at(X), next(X, Y).\n"
    "effect(stay, [], []).\n",
    "moves.pl": ":- module(moves, [next/2]).\n:- use_module('parts/steps', [step/1]).\n"
    "next(X, Y) :- step(S), Y is X + S.\n",
    "parts/steps.pl": ":- module(steps, [step/1]).\nstep(1).\n",
    "parts/rest.pl": "goal :- at(X), far(Far), X >= Far.\n",
    "parts/far.pl": "far(9).\n",
    "walk.yaml": "action: [go, stay]\ntypes: {at: [place]}\nmodes: ['at([1, 2])']\noptions: {min_examples: 5}\n",
}
USED = sorted(FILES.keys() - {"walk.pl", "walk.yaml"})
trusted = pytest.mark.parametrize("trust", [False, True])


def written(folder: Path, step: int = 1) -> Path:
    for name, text in FILES.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text.replace("step(1)", f"step({step})"))
    return folder / "walk.pl"


def place(domain: Domain) -> int:
    """Where the first step leads."""
    state = domain.start(np.random.default_rng(0))
    return domain.act(state, "go", np.random.default_rng(0))[1][0][1]  # type: ignore[index,return-value]


@trusted
def test_each_folder_has_its_own(tmp_path: Path, trust: bool) -> None:
    one, two = (Domain(written(tmp_path / str(step), step), trust=trust) for step in (1, 2))
    assert [sorted(each.used) for each in (one, two)] == [USED] * 2
    assert (place(one), place(two), place(one)) == (2, 3, 2)
    assert one.source == two.source and one.hash != two.hash
    written(tmp_path / "1", 4)
    assert place(Domain(one.path, trust=trust)) == 5 and place(one) == 2, "what is open stays as it was"


@trusted
def test_a_model_has_them_beside_it(tmp_path: Path, trust: bool) -> None:
    domain = Domain(written(tmp_path / "here"), trust=trust)
    run(domain, language_bias_of(domain), Options(episodes=4, min_examples=5), tmp_path / "there")
    assert all((tmp_path / "there" / name).read_bytes() == data for name, data in domain.used.items())
    shutil.rmtree(tmp_path / "here")
    policy = Policy.load(tmp_path / "there" / "model.pl", trust=trust)
    assert policy.domain.hash == domain.hash and place(policy.domain) == 2
    (tmp_path / "there" / "parts" / "steps.pl").write_text(":- module(steps, [step/1]).\nstep(3).\n")
    with pytest.warns(UserWarning, match="is not the file that this model was learned with"):
        assert place(Policy.load(tmp_path / "there" / "model.pl", trust=trust).domain) == 4


def test_they_go_with_it_to_other_processes(tmp_path: Path) -> None:
    domain = Domain(written(tmp_path / "here"))
    data = pickle.dumps(domain)
    assert place(pickle.loads(data)) == 2
    shutil.rmtree(tmp_path / "here")
    assert place(pickle.loads(data)) == 2
    program = "import pickle, sys, numpy as np; d = pickle.loads(sys.stdin.buffer.read()); r = np.random.default_rng(0)"
    program += "; print(d.act(d.start(r), 'go', r)[1])"
    found = subprocess.run([sys.executable, "-c", program], input=data, capture_output=True, timeout=100)
    assert found.stdout.decode().strip() == "at(2)", found.stderr


def test_they_are_forgotten_with_it(tmp_path: Path) -> None:
    domain = Domain(written(tmp_path))
    asked = {"Module": domain.module}
    assert janus_swi.query_once("nppg_used_files:part(Module, _, _, _)", dict(asked))["truth"]
    del domain
    gc.collect()
    open_domain("corridor")
    for question in ("part(Module, _, _, _)", "used(Module, _, _)"):
        assert not janus_swi.query_once(f"nppg_used_files:{question}", dict(asked))["truth"]


def test_a_file_outside_the_folder_comes_to_stand_in_it(tmp_path: Path) -> None:
    path = written(tmp_path / "here")
    path.write_text(path.read_text().replace("use_module(moves)", "use_module('../moves')"))
    (path.parent / "moves.pl").rename(tmp_path / "moves.pl")
    (path.parent / "parts").rename(tmp_path / "parts")
    path.write_text(path.read_text().replace("'parts/", "'../parts/").replace("parts/far", "'../parts/far'"))
    with pytest.raises(NppgError, match=r"walk.pl:2: .*moves.pl is no file in the folder of the domain"):
        Domain(path)
    domain = Domain(path, trust=True)
    assert sorted(domain.used) == ["far.pl", "moves.pl", "rest.pl", "steps.pl"]
    twin = pickle.dumps(domain)
    shutil.rmtree(tmp_path / "parts")
    assert place(pickle.loads(twin)) == 2


def test_a_name_that_leads_out_of_the_folder_is_refused(tmp_path: Path) -> None:
    for name in ("../out.pl", "/tmp/out.pl", "a/../../out.pl"):
        with pytest.raises(NppgError, match="is no name of a file in the folder"):
            write_copies(tmp_path / "run", {name: b""})


@trusted
def test_what_a_used_file_draws_comes_from_the_seed(tmp_path: Path, trust: bool) -> None:
    path = written(tmp_path)
    (tmp_path / "parts" / "steps.pl").write_text(":- module(steps, [step/1]).\nstep(X) :- random_between(1, 999, X).\n")
    one, two = Domain(path, trust=trust), Domain(path, trust=trust)
    assert place(one) == place(two) != 2
