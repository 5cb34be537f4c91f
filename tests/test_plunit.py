"""The plunit tests of the Prolog modules, each unit a test, run in this process, where Python answers Prolog."""

from __future__ import annotations

from pathlib import Path

import janus_swi
import pytest

import nppg.bridge.prolog  # noqa: F401  (starts Prolog)

FILES = sorted((Path(__file__).parent / "plunit").glob("*.plt"))
RUN = """
load_files(user:File, [silent(true), if(not_loaded)]),
( plunit:run_tests(Unit) -> Passed = true ; Passed = false )
"""


def test_every_module_has_its_tests() -> None:
    modules = {path.stem for path in (Path(__file__).parent.parent / "prolog").glob("*.pl")} - {"bridge", "plain"}
    assert modules == {path.stem for path in FILES}


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_unit(file: Path, capfd: pytest.CaptureFixture[str]) -> None:
    answer = janus_swi.query_once(RUN, {"File": str(file), "Unit": file.stem})
    said = capfd.readouterr()
    assert answer["Passed"] == "true" or answer["Passed"] is True, said.out + said.err
    assert "Warning" not in said.err, said.err
