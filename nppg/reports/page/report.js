"use strict";
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const root = document.documentElement;
  const svgns = "http://www.w3.org/2000/svg";

  const make = (name, attributes = {}, ...children) => {
    const element = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    element.append(...children);
    return element;
  };
  const drawn = (name, attributes) => {
    const element = document.createElementNS(svgns, name);
    for (const key in attributes) element.setAttribute(key, attributes[key]);
    return element;
  };
  const signed = (value) => (value < 0 ? "−" : "+") + Number(Math.abs(value).toPrecision(4));
  const text = (number) => data.texts[number];

  // light and dark, copying, where one is

  const dark = () => root.dataset.theme ? root.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
  document.getElementById("theme").addEventListener("click", () => { root.dataset.theme = dark() ? "light" : "dark"; });

  for (const each of document.querySelectorAll(".command")) {
    const button = make("button", { type: "button" }, "copy");
    button.addEventListener("click", () => {
      navigator.clipboard?.writeText(each.querySelector("code").textContent);
      button.textContent = "copied";
    });
    each.append(button);
  }

  const links = new Map([...document.querySelectorAll(".bar a")].map((each) => [each.hash.slice(1), each]));
  const watch = new IntersectionObserver((entries) => {
    for (const each of entries) if (each.isIntersecting) {
      links.forEach((link) => link.classList.remove("here"));
      links.get(each.target.id)?.classList.add("here");
    }
  }, { rootMargin: "-20% 0px -70% 0px" });
  document.querySelectorAll("main > section").forEach((each) => watch.observe(each));

  // states

  const bounds = (states) => {
    let [left, low, right, high] = [Infinity, Infinity, -Infinity, -Infinity];
    const seen = new Set();
    for (const state of states) for (const number of data.states[state]) {
      if (seen.has(number)) continue;
      seen.add(number);
      const [kind, ...n] = data.shapes[number];
      const box = kind === "box" ? [n[0], n[1], n[0] + n[2], n[1] + n[3]]
        : kind === "disc" ? [n[0] - n[2], n[1] - n[2], n[0] + n[2], n[1] + n[2]]
        : kind === "line" ? [Math.min(n[0], n[2]), Math.min(n[1], n[3]), Math.max(n[0], n[2]), Math.max(n[1], n[3])]
        : [n[0], n[1] - 0.2, n[0], n[1] + 0.2];
      left = Math.min(left, box[0]); low = Math.min(low, box[1]);
      right = Math.max(right, box[2]); high = Math.max(high, box[3]);
    }
    return left > right ? [0, 0, 1, 1] : [left, low, right, high];
  };

  const scene = (state, frame, before) => {
    const [left, low, right, high] = frame;
    const room = Math.max(right - left, high - low) * 0.03 || 0.5;
    const unit = Math.max(right - left, (high - low) * 1.2, 1) / 28;
    const view = [left - room, -high - room, right - left + 2 * room, high - low + 2 * room];
    const svg = drawn("svg", { class: "state", viewBox: view.map((each) => each.toFixed(3)).join(" "), role: "img" });
    svg.setAttribute("aria-label", "a state");
    const old = before === undefined ? null : new Set(data.states[before]);
    const label = (words, x, y, width, height, kind) => {
      const size = Math.min(height, width * 0.94 / Math.max(words.length * 0.6, 1));
      const element = drawn("text", { class: kind, x, y, "font-size": size.toFixed(4) });
      element.textContent = words;
      svg.append(element);
    };
    for (const number of data.states[state]) {
      const [kind, ...n] = data.shapes[number];
      const fresh = old && !old.has(number) ? " fresh" : "";
      if (kind === "box") {
        const [x, y, width, height, tone, words] = n;
        if (tone !== "bare" && tone !== "note") svg.append(drawn("rect", {
          class: `tone-${tone}${fresh}`, x, y: -y - height, width, height, rx: Math.min(0.12, width / 6, height / 6) }));
        const most = tone === "bare" || tone === "note" ? height * 0.78 : Math.min(height * 0.46, unit * 1.6);
        if (words) label(words, x + width / 2, -y - height / 2, width, most, tone === "note" ? "note" : "");
      } else if (kind === "disc") {
        const [x, y, radius, tone, words] = n;
        svg.append(drawn("circle", { class: `tone-${tone}${fresh}`, cx: x, cy: -y, r: radius }));
        if (words) label(words, x, -y, radius * 2, radius * 0.8, "");
      } else if (kind === "line") {
        svg.append(drawn("line", { class: `tone-${n[4]}`, x1: n[0], y1: -n[1], x2: n[2], y2: -n[3] }));
      } else label(n[2], n[0], -n[1], 1e9, unit, "loose");
    }
    return svg;
  };

  // what the rules say

  const saying = (row, words) => {
    const [given, more, rest] = data.rows[row];
    const most = Math.max(...given.map((each) => Math.abs(each[1])), 1e-12);
    const list = make("ol", { class: "because" });
    for (const [rule, value, trees] of given) {
      const bar = make("span", { class: `given ${value < 0 ? "down" : "up"}`, style: `--share:${(Math.abs(value) / most).toFixed(3)}` }, signed(value));
      const from = trees > 1 ? make("small", {}, ` ${trees} trees`) : "";
      list.append(make("li", {}, bar, make("span", { class: words ? "words" : "prolog" }, data.rules[rule][words ? 1 : 0], from)));
    }
    if (more) list.append(make("li", {}, make("span", { class: "given" }, signed(rest)), make("span", {}, `${more} more rules together`)));
    return list;
  };

  // the player

  const place = document.getElementById("player");
  if (place && data.policies.some((each) => each.episodes.length)) {
    const choice = make("select", { "aria-label": "episode" });
    const all = [];
    data.policies.forEach((policy) => policy.episodes.forEach((episode) => {
      const end = episode.success === null ? `return ${episode.return}` : episode.success ? "goal reached" : "goal missed";
      choice.append(make("option", { value: all.length }, `${policy.name}: ${episode.name} (${end}, ${episode.steps.length} steps)`));
      all.push([policy, episode]);
    }));
    const button = (name, title, action) => {
      const element = make("button", { type: "button", title, "aria-label": title }, name);
      element.addEventListener("click", action);
      return element;
    };
    let [policy, episode] = all[0];
    let at = 0, picked = -1, frame = null, timer = 0, prolog = false;
    const stage = make("div", { class: "stage" });
    const side = make("div", { class: "side" });
    const slider = make("input", { type: "range", min: 0, step: 1, value: 0, "aria-label": "step" });
    const strip = drawn("svg", { class: "strip", preserveAspectRatio: "none", "aria-hidden": "true" });
    const where = make("output", { class: "where" });
    const go = (to) => { at = Math.min(Math.max(to, 0), episode.steps.length); picked = -1; show(); };
    const stop = () => { clearInterval(timer); timer = 0; play.textContent = "▶"; };
    const play = button("▶", "play (space)", () => {
      if (timer) return stop();
      if (at === episode.steps.length) at = -1;
      play.textContent = "❚❚";
      const quick = Math.max(60, Math.min(900, 30000 / Math.max(episode.steps.length, 1)));
      timer = setInterval(() => { if (at >= episode.steps.length) stop(); else go(at + 1); }, quick);
    });
    const controls = make("div", { class: "controls" },
      button("«", "first step (Home)", () => go(0)), button("‹", "step back (←)", () => go(at - 1)), play,
      button("›", "step on (→)", () => go(at + 1)), button("»", "last state (End)", () => go(episode.steps.length)), where);
    place.append(make("div", { class: "choice" }, choice), make("div", { class: "scene" }, stage, side),
      make("div", { class: "time" }, strip, slider), controls);

    const open = (number) => {
      [policy, episode] = all[number];
      choice.value = number;
      at = 0; picked = -1;
      frame = bounds([...new Set([...episode.steps.map((step) => step.s), episode.last])]);
      slider.max = episode.steps.length;
      const count = Math.min(episode.steps.length, 400);
      strip.replaceChildren();
      strip.setAttribute("viewBox", `0 0 ${Math.max(count, 1)} 1`);
      for (let i = 0; i < count; i++) {
        const from = Math.floor(i * episode.steps.length / count), to = Math.floor((i + 1) * episode.steps.length / count);
        let least = 1;
        for (let j = from; j < to; j++) least = Math.min(least, episode.steps[j].p[episode.steps[j].c]);
        strip.append(drawn("rect", { x: i + 0.1, width: 0.8, y: 1 - Math.max(least, 0.03), height: Math.max(least, 0.03) }));
      }
      show();
    };

    const actions = (step) => {
      const list = make("ol", { class: "actions" });
      step.a.forEach((action, i) => {
        const chosen = i === step.c;
        const line = make("button", { type: "button", class: chosen ? "chosen" : "", style: `--share:${step.p[i]}`, "aria-pressed": i === picked },
          make("span", { class: "what" }, text(action)), make("span", { class: "chance" }, step.p[i].toFixed(4)));
        line.addEventListener("click", () => { picked = i; show(); });
        list.append(make("li", {}, line));
      });
      if (step.n > step.a.length) list.append(make("li", { class: "more" }, `and ${step.n - step.a.length} more`));
      return list;
    };

    const show = () => {
      const step = episode.steps[at];
      const state = step ? step.s : episode.last;
      stage.replaceChildren(scene(state, frame, at ? episode.steps[at - 1].s : undefined));
      slider.value = at;
      strip.style.setProperty("--at", at / Math.max(episode.steps.length, 1));
      where.textContent = step ? `step ${at + 1} of ${episode.steps.length}` : `after ${episode.steps.length} steps`;
      side.replaceChildren();
      if (!step) {
        const end = episode.success === null ? "The episode is over." : episode.success ? "The goal is reached." : "The goal is not reached.";
        side.append(make("p", { class: "end" }, end), make("p", { class: "quiet" }, `The return is ${episode.return}.`));
        return;
      }
      side.append(actions(step));
      if (!step.r) return;
      const shown = picked < 0 ? step.c : picked;
      const words = policy.words && !prolog;
      const why = make("div", { class: "why" }, make("h4", {}, picked < 0 || picked === step.c ? "why " : "about ", make("code", {}, text(step.a[shown]))));
      if (policy.words) {
        const other = button(prolog ? "in words" : "as Prolog", "how rules are told", () => { prolog = !prolog; show(); });
        why.firstChild.append(other);
      }
      why.append(saying(step.r[shown], words));
      if (step.o && step.o.length) {
        const list = make("ul", {});
        for (const [other, test, holds] of step.o) list.append(make("li", {}, make("code", {}, text(other)), `, if ${text(test)}${holds ? " no longer held" : " held"}`));
        why.append(make("h4", {}, "it would rather choose"), list);
      }
      side.append(why);
    };

    choice.addEventListener("change", () => { stop(); open(Number(choice.value)); });
    slider.addEventListener("input", () => go(Number(slider.value)));
    strip.addEventListener("click", (event) => {
      const box = strip.getBoundingClientRect();
      go(Math.floor((event.clientX - box.left) / box.width * episode.steps.length));
    });
    let visible = false;
    new IntersectionObserver((entries) => { visible = entries.at(-1).isIntersecting; }).observe(place);
    document.addEventListener("keydown", (event) => {
      if (!visible || event.altKey || event.ctrlKey || event.metaKey || event.target.closest("input, select, .wide")) return;
      const keys = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: episode.steps.length };
      if (event.key in keys) go(keys[event.key]);
      else if (event.key === " " && !event.target.closest("button, summary, a")) play.click();
      else if (event.key === "]") open((Number(choice.value) + 1) % all.length);
      else if (event.key === "[") open((Number(choice.value) + all.length - 1) % all.length);
      else return;
      event.preventDefault();
    });
    open(0);
  }

  // a leaf unfolds

  const leaf = (tree, number, panel, group) => {
    const policy = data.policies[tree.policy];
    const path = make("ol", { class: "path" });
    for (const [test, yes] of tree.paths[number]) path.append(make("li", { class: yes ? "yes" : "no" }, make("code", {}, test)));
    if (!tree.paths[number].length) path.append(make("li", {}, "every action comes here"));
    panel.replaceChildren(make("h4", {}, "the way to this leaf"), path);
    if (tree.said.length) panel.append(make("p", { class: "said" }, tree.said[number]));
    panel.append(make("pre", { class: "rule" }, make("code", {}, tree.rules[number])));
    const met = policy?.leaves[tree.tree]?.[number];
    if (policy && policy.pairs) panel.append(make("p", { class: "note" }, met
      ? `Of the ${policy.pairs.toLocaleString("en")} actions in the states of the episodes, ${met.n.toLocaleString("en")} came here; ${met.c.toLocaleString("en")} of them were chosen.`
      : "No action in the states of the episodes came here."));
    if (met) {
      const examples = make("div", { class: "examples" });
      for (const [state, action, chosen] of met.e) examples.append(make("figure", { class: chosen ? "chosen" : "" }, scene(state, bounds([state])), make("figcaption", {}, make("code", {}, text(action)))));
      panel.append(examples);
    }
    group.closest("svg").querySelectorAll(".leaf").forEach((each) => each.classList.toggle("picked", each === group));
    panel.hidden = false;
  };
  for (const wide of document.querySelectorAll(".wide[data-tree]")) {
    const tree = data.trees[Number(wide.dataset.tree)];
    const panel = make("div", { class: "unfolded", "aria-live": "polite", hidden: "" });
    wide.after(panel);
    for (const group of wide.querySelectorAll(".leaf")) {
      const unfold = () => leaf(tree, Number(group.dataset.leaf), panel, group);
      group.setAttribute("tabindex", "0");
      group.setAttribute("role", "button");
      group.addEventListener("click", unfold);
      group.addEventListener("keydown", (event) => {
        if (event.key === "Enter" || event.key === " ") { event.preventDefault(); unfold(); }
      });
    }
    const centre = () => { wide.scrollLeft = (wide.scrollWidth - wide.clientWidth) / 2; };
    wide.closest("details")?.addEventListener("toggle", centre);
    centre();
  }

  // states elsewhere on the page

  for (const each of document.querySelectorAll("[data-state]")) {
    const state = Number(each.dataset.state);
    each.replaceChildren(scene(state, bounds([state])));
  }
})();
