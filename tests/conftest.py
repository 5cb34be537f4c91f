"""Settings of hypothesis, and what many tests look at. Examples are drawn afresh but the same in every run."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

from nppg.answers.coverage import root_table
from nppg.answers.table import TestTable
from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import Refiner
from nppg.bridge.files import shipped
from nppg.judging.space import Space
from nppg.worlds.domain import Domain

settings.register_profile(
    "laws",
    deadline=None,
    derandomize=True,
    max_examples=100,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.function_scoped_fixture],
)
settings.load_profile("laws")


@pytest.fixture(scope="session")
def blocks() -> Domain:
    """The ten-block world."""
    return Domain("blocks_world")


@pytest.fixture(scope="session")
def four_blocks() -> Domain:
    return Domain("blocks_world", {"blocks": 4})


@pytest.fixture(scope="session")
def delivery() -> Domain:
    """Several kinds of actions."""
    return Domain("delivery")


@pytest.fixture(scope="session")
def plain_bias() -> LanguageBias:
    return LanguageBias.load(shipped("language_bias") / "blocks_world.yaml")


@pytest.fixture(scope="session")
def relational_bias() -> LanguageBias:
    return LanguageBias.load(shipped("language_bias") / "blocks_world_relational.yaml")


@pytest.fixture(scope="session")
def delivery_bias() -> LanguageBias:
    return LanguageBias.load(shipped("language_bias") / "delivery.yaml")


@pytest.fixture(scope="session")
def chain() -> tuple[Domain, LanguageBias]:
    """Four cells in a row, with a bound in the language bias."""
    folder = Path(__file__).parent / "domains"
    return Domain(folder / "chain.pl"), LanguageBias.load(folder / "chain.yaml")


@pytest.fixture(scope="session")
def space() -> Space:
    """All states of the ten-block world, up to renaming."""
    return Space(Domain("blocks_world"))


@pytest.fixture(scope="session")
def four(four_blocks: Domain) -> Space:
    """All states of the four-block world; to enumerate and check them takes longer than to judge a policy on them."""
    return Space(four_blocks)


@pytest.fixture
def bias_of(tmp_path: Path) -> Callable[[str], LanguageBias]:
    """Reads a language bias from its text."""

    def load(text: str) -> LanguageBias:
        path = tmp_path / "bias.yaml"
        path.write_text(text)
        return LanguageBias.load(path)

    return load


@pytest.fixture(scope="session")
def refiners(
    plain_bias: LanguageBias, relational_bias: LanguageBias, delivery_bias: LanguageBias
) -> dict[str, Refiner]:
    """Shared, since a refiner remembers what it has computed."""
    return {"plain": Refiner(plain_bias), "relational": Refiner(relational_bias), "delivery": Refiner(delivery_bias)}


@pytest.fixture(params=["plain", "relational", "delivery"])
def setting(
    request: pytest.FixtureRequest, refiners: dict[str, Refiner]
) -> tuple[Domain, LanguageBias, Refiner, TestTable]:
    """A domain, a bias for it, and the refiner and a root table of that bias."""
    domain = request.getfixturevalue("delivery" if request.param == "delivery" else "blocks")
    bias = request.getfixturevalue(f"{request.param}_bias")
    refiner = refiners[request.param]
    return domain, bias, refiner, root_table(domain, bias, refiner)
