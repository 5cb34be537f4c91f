"""Reports: what a page says, that it is whole by itself, and that no name in a file can do anything in it."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from samples import visited

import nppg
from nppg import Domain, NppgError, Options, Policy
from nppg.bridge.seals import sealed
from nppg.cli.main import main
from nppg.learning.episode import generate_episode
from nppg.reports.build import Wishes, page_of, report
from nppg.reports.chart import Line, chart, ticks
from nppg.reports.drawn_facts import FactsDrawing
from nppg.reports.episodes import Played, Player
from nppg.reports.forest import Places
from nppg.reports.page import Page, Section, embedded
from nppg.reports.spread import component, needed, placed, rows
from nppg.worlds.shapes import shapes

HOSTILE = '</script><img src=x onerror=alert(1)>"\'&'
TONES = {"object", "wanted", "agent", "place", "wall", "danger", "faint", "bare", "note", *range(1, 7)}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two runs, and rules of the first with their proof."""
    path = tmp_path_factory.mktemp("runs")
    domain = nppg.open_domain("blocks_world", {"blocks": 3})
    bias = nppg.language_bias_of(domain)
    for seed in range(2):
        nppg.run(domain, bias, Options(episodes=60, seed=seed), path / f"seed-{seed}", 20)
        policy = Policy.load(path / f"seed-{seed}" / "model.pl")
        nppg.distill(policy, bias).save(path / f"seed-{seed}" / "rules.pl")
    return path


class Elements(HTMLParser):
    """The elements of a page with their attributes, and the text."""

    def __init__(self, page: str):
        super().__init__()
        self.found: list[tuple[str, dict[str, str | None]]] = []
        self.text = ""
        self.feed(page)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found.append((tag, dict(attrs)))

    def handle_data(self, data: str) -> None:
        self.text += data


def data_of(page: str) -> dict:
    return json.loads(page.split('<script type="application/json" id="data">')[1].split("</script>")[0])


def test_the_page_has_its_sections(folder: Path) -> None:
    page = report([folder], Wishes(episodes=1, prove=True))
    elements = Elements(page)
    ids = [attributes["id"] for tag, attributes in elements.found if tag == "section"]
    assert ids == ["learned", "curves", "episodes", "trees", "proof", "made"]
    assert "Learned by nppg, in 2 runs." in page and "succeeds from every start state" in page
    assert "--seeds 0,1" in page and elements.text.count("delta(1,") >= 1
    drawn = [attributes for tag, attributes in elements.found if tag == "svg" and attributes.get("class") == "tree"]
    assert len(drawn) == len(data_of(page)["trees"]) > 2


def test_the_page_needs_nothing_else(folder: Path) -> None:
    page = report([folder], Wishes(episodes=1))
    assert set(re.findall(r"https?://[\w./]+", page)) == {"http://www.w3.org/2000/svg"}
    for tag, attributes in Elements(page).found:
        assert tag not in ("link", "img", "iframe", "object", "base")
        assert "src" not in attributes and (attributes.get("href") or "#").startswith("#")
    assert "default-src 'none'" in page


def test_the_page_is_the_same_again(folder: Path) -> None:
    assert report([folder], Wishes(episodes=1)) == report([folder], Wishes(episodes=1))


def test_names_in_files_do_nothing(folder: Path, tmp_path: Path) -> None:
    copy = tmp_path / "copy"
    copy.mkdir()
    for file in (folder / "seed-0").iterdir():
        (copy / file.name).write_bytes(file.read_bytes())
    (copy / "rules.pl").unlink()
    summary = json.loads((copy / "run.json").read_text())
    summary["learner"] = summary["domain"]["parameters"][HOSTILE] = summary["options"][HOSTILE] = HOSTILE
    summary["nppg"] = HOSTILE
    (copy / "run.json").write_bytes(sealed(json.dumps(summary).encode()))
    page = report([copy], Wishes(episodes=1))
    assert "<img" not in page
    assert not any(tag == "img" or "onerror" in attributes for tag, attributes in Elements(page).found)
    assert page.count("</script>") == 2


def test_names_of_objects_do_nothing() -> None:
    domain = nppg.open_domain("blocks_world", {"blocks": 3})
    policy = Policy(domain, nppg.language_bias_of(domain))
    state = (("goal_on", HOSTILE, "b2"), ("on", HOSTILE, "floor"), ("on", "b2", HOSTILE), ("on", "b3", "floor"))
    episode = generate_episode(policy, np.random.default_rng(0), start=state)
    player = Player()
    player.add(HOSTILE, policy, policy.bias, [Played(HOSTILE, episode)])
    page = Page(HOSTILE, HOSTILE, [(HOSTILE, HOSTILE)], [Section("a", HOSTILE, HOSTILE, "")], HOSTILE, player.data())
    assert "<img" not in page.html() and data_of(page.html())["policies"][0]["name"] == HOSTILE


@given(st.text())
def test_data_stay_in_their_block(text: str) -> None:
    written = embedded({"text": text})
    assert "<" not in written and json.loads(written) == {"text": text}


def test_the_player_tells_what_the_policy_does(folder: Path) -> None:
    policy = Policy.load(folder / "seed-0" / "model.pl")
    episode = generate_episode(policy, np.random.default_rng(1))
    player = Player()
    order = player.add("it", policy, policy.bias, [Played("one", episode)])
    assert sorted(order) == list(range(len(policy.trees)))
    data = player.data()
    (own,) = data["policies"]
    for step, told in zip(episode.steps, own["episodes"][0]["steps"], strict=True):
        texts = [data["texts"][number] for number in told["a"]]
        assert texts[told["c"]] == str(step.actions[step.chosen])
        assert told["p"][told["c"]] == pytest.approx(step.probabilities[step.chosen], abs=1e-4)
        for text, row in zip(texts, told["r"], strict=True):
            given, _, rest = data["rows"][row]
            number = list(map(str, step.actions)).index(text)
            assert sum(value for _, value, _ in given) + rest == pytest.approx(step.potentials[number], abs=1e-4)
    leaves = own["leaves"][0]
    assert sum(each["n"] for each in leaves.values()) == own["pairs"]
    assert own["pairs"] == sum(len(step.actions) for step in episode.steps)
    assert sum(each["c"] for each in leaves.values()) == len(episode.steps)


def test_a_long_episode_makes_a_small_page() -> None:
    domain = nppg.open_domain("grid")
    policy = Policy(domain, nppg.language_bias_of(domain))
    episode = generate_episode(policy, np.random.default_rng(0))
    steps = (episode.steps * 10_000)[:10_000]
    player = Player()
    player.add("it", policy, policy.bias, [Played("long", replace(episode, steps=steps))])
    assert len(player.data()["policies"][0]["episodes"][0]["steps"]) == 10_000
    assert len(embedded(player.data())) < 2_000_000


def test_every_shipped_domain_is_drawn() -> None:
    for name in ("blocks_world", "corridor", "delivery", "grid", "noisy_blocks", "rover"):
        domain = nppg.open_domain(name)
        for state in visited(domain, 3):
            own = domain.interpreted(state)
            found = shapes(domain, state) or FactsDrawing([own.facts], own.static.facts).shapes(own.facts)
            assert found
            for kind, *args in found:
                numbers = {"box": 4, "disc": 3, "line": 4, "text": 2}[str(kind)]
                assert all(isinstance(each, int | float) for each in args[:numbers])
                assert len(args) == numbers + {"box": 2, "disc": 2, "line": 1, "text": 1}[str(kind)]
                assert kind == "text" or args[numbers] in TONES


def test_things_are_on_and_in_others() -> None:
    same = [("holding", "cart", "box"), ("at", "bed", "hall")]
    one = [*same, ("at", "ball", "hall"), ("at", "cart", "hall"), ("on", "a", "b"), ("on", "b", "c")]
    two = [*same, ("at", "ball", "yard"), ("at", "cart", "yard"), ("on", "a", "c"), ("dark",)]
    places = Places([one, two])
    forest = places.forest(one)
    below = {"ball": "hall", "bed": "hall", "cart": "hall", "hall": None, "box": "cart", "a": "b", "b": "c", "c": None}
    assert forest.parents == below
    assert forest.stacked == {"a", "b"} and not forest.notes
    assert places.forest(two).loose == ["dark"]


def test_circles_do_no_harm() -> None:
    facts = [("on", "a", "b"), ("on", "b", "a"), ("on", "c", "c")]
    forest = Places([facts]).forest(facts)
    assert len(FactsDrawing([facts], ()).shapes(facts)) > 0 and None in forest.parents.values()


@settings(max_examples=30, deadline=None)
@given(st.lists(st.tuples(st.integers(0, 7), st.integers(0, 7)), min_size=1, max_size=14), st.integers(1, 3))
def test_places_on_ways_lie_apart(pairs: list[tuple[int, int]], width: int) -> None:
    ways = needed((f"l{a}", f"l{b}") for a, b in pairs if a != b)
    names = component(ways)
    if not names:
        return
    sizes = {name: (float(width), 1.0) for name in names}
    found = placed(names, ways, sizes)
    assert set(found) == set(names) and np.isfinite(list(found.values())).all()
    for i, one in enumerate(names):
        for other in names[:i]:
            apart = np.abs(np.subtract(found[one], found[other]))
            assert apart[0] > width - 1e-6 or apart[1] > 1 - 1e-6


def test_an_order_is_drawn_by_its_steps() -> None:
    assert needed([("a", "b"), ("b", "c"), ("a", "c")]) == [("a", "b"), ("b", "c")]
    assert needed([("a", "b"), ("b", "a"), ("b", "c")]) == [("a", "b"), ("b", "c")]


def test_rows_are_as_wide_as_they_may_be() -> None:
    found = rows(["a", "b", "c"], {name: (2.0, 1.0) for name in "abc"}, 0.5, 5.0)
    assert found == {"a": (1.0, -1.0), "b": (3.5, -1.0), "c": (1.0, -2.5)}


@given(st.floats(-1e6, 1e6), st.floats(1e-3, 1e6))
def test_ticks_are_few_and_within(low: float, size: float) -> None:
    found = list(ticks(low, low + size))
    assert 1 <= len(found) <= 11
    assert all(low - size * 1e-6 <= tick <= low + size * (1 + 1e-6) for tick in found)


def test_a_chart_escapes_its_labels() -> None:
    line = Line(HOSTILE, 0, False, [0, 1], [0.5, 0.5], [0.1, 0.1], 2)
    assert "<img" not in chart([line], "success", keys=True)


def test_nppg_report(folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    output = tmp_path / "page.html"
    assert main(["report", str(folder / "seed-0"), "--episodes", "1", "--output", str(output)]) == 0
    assert str(output) in capsys.readouterr().out and output.read_text().startswith("<!DOCTYPE html>")
    assert main(["report", str(folder / "seed-0" / "rules.pl"), "--episodes", "0", "--output", str(output)]) == 0


def test_a_certificate_of_another_model_is_left_out(folder: Path) -> None:
    model = folder / "seed-1" / "rules.pl"
    assert main(["prove", str(model), "--output", str(model.with_name("proof.json"))]) == 0
    assert "What is proven" in page_of([folder / "seed-1"], Wishes(0)).html()
    model.write_bytes(sealed(model.read_bytes() + b"\n"))
    assert "What is proven" not in page_of([folder / "seed-1"], Wishes(0)).html()


@pytest.mark.parametrize(
    ("file", "text", "said"),
    [
        ("run.json", "{", "is no run.json of nppg"),
        ("run.json", "[" * 100_000, "is no run.json of nppg"),
        ("run.json", '{"episodes": 1}', "has no checksum"),
        ("run.json", sealed(b'{"episodes": 1, "options": [], "domain": 7}').decode(), "model.pl: cannot be read"),
        ("curve.csv", "episode,success\nx,1\n", "curve.csv:2: 'x' is no number for episode"),
        ("curve.csv", "episode,success,greedy_success\n0,nan,1\n", "curve.csv:2: 'nan' is no number for success"),
        ("curve.csv", "\x00\xff", "curve.csv"),
    ],
)
def test_mistakes_in_files(
    folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], file: str, text: str, said: str
) -> None:
    copy = tmp_path / "copy"
    copy.mkdir()
    for name in ("run.json", "curve.csv"):
        (copy / name).write_bytes((folder / "seed-0" / name).read_bytes())
    (copy / file).write_bytes(text.encode("latin-1"))
    assert main(["report", str(copy), "--output", str(tmp_path / "page.html")]) == 2
    captured = capsys.readouterr()
    assert said in captured.err
    assert captured.err.count("\n") == 1 and not (tmp_path / "page.html").exists()


def test_folders_that_are_none(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["report", str(tmp_path)]) == 2
    assert "is no folder of a run" in capsys.readouterr().err
    assert main(["curves", str(tmp_path / "nothing")]) == 2
    assert "there is no such folder" in capsys.readouterr().err


def test_nppg_curves(folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    output = tmp_path / "curves.svg"
    assert main(["curves", str(folder), "--output", str(output)]) == 0
    assert "2 runs, stochastic policy: success" in capsys.readouterr().out
    assert output.read_text().startswith("<svg")
    assert main(["curves", str(folder / "seed-0"), str(folder / "seed-1"), "--output", str(output)]) == 0


def test_compare(folder: Path) -> None:
    rules = Policy.load(folder / "seed-0" / "rules.pl")
    uniform = Policy(rules.domain, rules.bias)
    same = nppg.compare([rules, rules], episodes=5)
    assert same.states == same.agreeing > 0 and same.distance == 0 and not same.differences
    other = nppg.compare([rules, Policy.load(folder / "seed-1" / "model.pl"), uniform], episodes=5)
    assert other.states == other.agreeing + len(other.differences) and 0 < other.distance <= 1
    assert str(other.states) in str(other) and other._repr_html_().startswith("<p>")
    for bad in ([rules], [rules, Policy(Domain("blocks_world"), rules.bias)]):
        with pytest.raises(NppgError):
            nppg.compare(bad)


def test_watching_prints_where_there_is_no_notebook(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    domain = nppg.open_domain("blocks_world", {"blocks": 3})
    bias = replace(nppg.language_bias_of(domain))
    nppg.run(domain, bias, Options(episodes=20), tmp_path, 10, report=nppg.watch())
    assert "episode 20 of 20" in capsys.readouterr().out
