"""The page in a real browser, where Chromium is there: no errors, the player steps, nothing is too wide."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from dataclasses import replace
from html import escape, unescape
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nppg
from nppg import Options, Policy
from nppg.learning.episode import generate_episode
from nppg.reports.build import Wishes, page_of
from nppg.reports.episodes import Played, Player
from nppg.reports.page import Page

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
FLAGS = ("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run")
FLAGS += ("--disable-background-networking", "--disable-component-update", "--disable-sync")
pytestmark = pytest.mark.skipif(CHROMIUM is None, reason="there is no Chromium")

WATCH = "<script>window.wrong = []; addEventListener('error', (event) => wrong.push(event.message));</script>"
# The page stands in a frame of the width that is asked for: a window cannot be as narrow as a telephone.
FRAME = """<!DOCTYPE html><meta charset="utf-8"><iframe style="width:{width}px;height:900px" srcdoc="{page}"></iframe>
<pre id="result"></pre><script>
addEventListener("load", () => setTimeout(() => {{
  const view = frames[0], page = view.document, told = {{ wrong: view.wrong }};
  const click = (element) => element.dispatchEvent(new view.Event("click", {{ bubbles: true }}));
  try {{ {script} }} catch (error) {{ told.wrong.push(String(error)); }}
  told.over = page.documentElement.scrollWidth - view.innerWidth;
  document.getElementById("result").textContent = JSON.stringify(told);
}}, 100));</script>"""
STEPS = """
  const where = () => page.querySelector(".where").textContent;
  const buttons = page.querySelectorAll(".controls button");
  told.begin = where();
  click(buttons[3]); told.second = where(); told.moved = page.querySelectorAll(".stage .fresh").length;
  click(buttons[4]); told.end = where(); told.said = page.querySelector(".end").textContent;
  click(buttons[0]); told.again = where();
  told.chances = [...page.querySelectorAll(".chance")].map((each) => Number(each.textContent));
  told.reasons = page.querySelectorAll(".because li").length;
  for (const each of page.querySelectorAll("details")) each.open = true;
  click(page.querySelector(".leaf"));
  told.path = page.querySelectorAll(".unfolded .path li").length;
  told.examples = page.querySelectorAll(".examples svg").length;
  const before = view.getComputedStyle(page.body).backgroundColor;
  click(page.getElementById("theme"));
  told.themed = view.getComputedStyle(page.body).backgroundColor !== before;
"""


def browse(page: str, script: str, width: int, folder: Path) -> dict[str, Any]:
    """What a script finds in a page of this width."""
    assert CHROMIUM
    file = folder / f"page{width}.html"
    page = page.replace("<head>", f"<head>{WATCH}")
    file.write_text(FRAME.format(width=width, page=escape(page, True), script=script), encoding="utf-8")
    flags = [*FLAGS, f"--user-data-dir={folder / 'profile'}", "--virtual-time-budget=8000", "--dump-dom"]
    spoken = {**os.environ, "LANG": "C.UTF-8"}
    done = subprocess.run([CHROMIUM, *flags, file.as_uri()], capture_output=True, text=True, timeout=240, env=spoken)
    found = done.stdout.split('<pre id="result">')[-1].split("</pre>")[0]
    assert found.startswith("{"), done.stderr[-2000:]
    return json.loads(unescape(found))


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Page:
    folder = tmp_path_factory.mktemp("run")
    domain = nppg.open_domain("blocks_world", {"blocks": 4})
    nppg.run(domain, nppg.language_bias_of(domain), Options(episodes=60), folder, 20)
    return page_of([folder], Wishes(episodes=3, seed=1, prove=True))


@pytest.mark.parametrize("width", [400, 1600])
def test_the_page_works_and_fits(page: Page, width: int, tmp_path: Path) -> None:
    told = browse(page.html(), STEPS, width, tmp_path)
    assert told["wrong"] == [] and told["over"] <= 0
    episode = page.data["policies"][0]["episodes"][0]
    count = len(episode["steps"])
    assert told["begin"] == told["again"] == f"step 1 of {count}"
    assert told["end"] == f"after {count} steps" and told["said"].startswith("The goal is")
    assert told["second"] == (f"step 2 of {count}" if count > 1 else told["end"]) and told["moved"] > 0
    assert told["chances"] == pytest.approx(episode["steps"][0]["p"], abs=1e-4)
    assert told["reasons"] > 0 and told["path"] > 0 and told["examples"] >= 0 and told["themed"]


def test_ten_thousand_steps(page: Page, tmp_path: Path) -> None:
    domain = nppg.open_domain("grid")
    policy = Policy(domain, nppg.language_bias_of(domain))
    episode = generate_episode(policy, np.random.default_rng(0))
    player = Player()
    long = replace(episode, steps=(episode.steps * 10_000)[:10_000])
    player.add("it", policy, policy.bias, [Played("long", long)])
    script = """
      const slider = page.querySelector("input[type=range]");
      for (let i = 0; i <= 10000; i += 100) { slider.value = i; slider.dispatchEvent(new view.Event("input")); }
      told.end = page.querySelector(".where").textContent;
    """
    data = {**player.data(), "trees": []}
    html = page._replace(data=data, sections=[each for each in page.sections if each.name == "episodes"]).html()
    told = browse(html, script, 1600, tmp_path)
    assert told["wrong"] == [] and told["end"] == "after 10000 steps"
