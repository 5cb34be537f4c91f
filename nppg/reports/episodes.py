"""Episodes for the player of a page: states as shapes, actions with probabilities, the rules that decided.

What comes again is written once: shapes, states, texts, rules, and what the rules say of pairs with the same answers.
So also a long episode makes a small page.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.terms import texts
from nppg.learning.episode import Episode, Step, generate_episode
from nppg.policy.explanation import InWords
from nppg.policy.policy import Policy
from nppg.policy.reasons import Change, Reasons
from nppg.reports.drawn_facts import FactsDrawing
from nppg.worlds.domain import Domain
from nppg.worlds.pddl_domain import PddlDomain
from nppg.worlds.shapes import Shape, shapes
from nppg.worlds.world import Action, State

_ACTIONS = 14  # of a state that are told
_RULES = 10  # of an action
_EXAMPLES = 6  # of a leaf
_EXPLAINED = 400  # steps of a page that are told what would have to be otherwise


class Played(NamedTuple):
    """An episode with its name."""

    name: str
    episode: Episode


class Numbered:
    """Things, each once, by number."""

    def __init__(self) -> None:
        self._numbers: dict[Hashable, int] = {}

    def __call__(self, thing: Hashable) -> int:
        return self._numbers.setdefault(thing, len(self._numbers))

    def all(self) -> list:
        """In order."""
        return list(self._numbers)


class Player:
    """Gathers what the page's player shows, of one domain."""

    def __init__(self) -> None:
        self.shapes, self.states, self.texts, self.rules, self.rows = (Numbered() for _ in range(5))
        self.policies: list[dict[str, Any]] = []
        self._explained = 0

    def data(self) -> dict[str, Any]:
        """For the page."""
        return {
            "shapes": self.shapes.all(),
            "states": self.states.all(),
            "texts": self.texts.all(),
            "rules": [[str(rule), rule.words] for rule in self.rules.all()],
            "rows": self.rows.all(),
            "policies": self.policies,
        }

    def add(self, name: str, policy: Policy, bias: LanguageBias, played: Sequence[Played]) -> list[int]:
        """A policy with its episodes. Returns the numbers of its trees, from 0, those first that weigh most in them."""
        told = _Told(self, policy, bias, played)
        episodes = [
            {
                "name": each.name,
                "success": each.episode.success if policy.domain.has_goal else None,
                "return": round(each.episode.undiscounted, 6),
                "steps": [told.step(step) for step in each.episode.steps],
                "last": told.state(each.episode.actual),
            }
            for each in played
        ]
        self.policies.append(
            {
                "name": name,
                "words": bool(bias.sentences),
                "summed": told.reasons is not None,
                "episodes": episodes,
                "leaves": told.leaves(),
                "pairs": told.pairs,
            }
        )
        return np.argsort(-told.weights, kind="stable").tolist()

    def drawn(self, found: Iterable[Shape]) -> int:
        """The number of a state of these shapes."""
        return self.states(tuple(self.shapes(shape) for shape in found))

    def is_to_explain(self) -> bool:
        """Whether one more step is told what would have to be otherwise."""
        self._explained += 1
        return self._explained <= _EXPLAINED


class _Told:
    """What is told of one policy's episodes."""

    def __init__(self, player: Player, policy: Policy, bias: LanguageBias, played: Sequence[Played]):
        self.player, self.policy, self.bias = player, policy, bias
        self.reasons: Reasons | None = policy.reasons(bias)
        self.pairs = 0
        self._draw = Drawing(policy.domain, [each.episode for each in played])
        self._known: dict[bytes, list[Change]] = {}
        self._written: dict[Action, str] = {}
        self._leaves: list[dict[int, dict[str, Any]]] = [{} for _ in policy.trees]
        self.weights = np.zeros(len(policy.trees))  # how far apart each tree has put the actions of a state, in all

    def _text(self, action: Action) -> str:
        if action not in self._written:
            self._written[action] = texts([action])[0]
        return self._written[action]

    def state(self, state: State) -> int:
        """The number of the drawn state."""
        return self.player.drawn(self._draw(state))

    def step(self, step: Step) -> dict[str, Any]:
        """The state, the likeliest actions and the chosen one, and what the rules say of each."""
        policy, player = self.policy, self.player
        state, actions = self.state(step.actual), list(step.actions)
        if len(step.potentials) != len(actions):
            scores = policy.scores(step.state, actions)
            answers, potentials, probabilities = scores
        else:
            answers, potentials, probabilities = step.answers, step.potentials, step.probabilities
        if self.reasons and answers.shape[1] != policy.width:
            answers = policy.answers(step.state, actions)
        order = np.argsort(-potentials, kind="stable")[:_ACTIONS].tolist()
        if step.chosen not in order:
            order = [*order[:-1], step.chosen]
        words = [self._text(actions[i]) for i in order]
        told: dict[str, Any] = {
            "s": state,
            "a": [player.texts(text) for text in words],
            "p": [round(float(probabilities[i]), 4) for i in order],
            "c": order.index(step.chosen),
            "n": len(actions),
            "w": round(step.reward, 6),
        }
        if self.reasons:
            told["r"] = [player.rows(self._row(self.reasons, answers[i])) for i in order]
            if player.is_to_explain():
                told["o"] = self._otherwise(step, self.reasons, actions, answers)
            self._note(self.reasons, answers, actions, state, step.chosen)
        return told

    def _row(self, reasons: Reasons, row: np.ndarray) -> tuple:
        """The weightiest rules with what they give, and what the others do together."""
        given = sorted(reasons.summed(row).items(), key=lambda each: -abs(each[1][0]))
        number = self.player.rules
        kept = [(number(reasons.rules[rule]), round(value, 6), trees) for rule, (value, trees) in given[:_RULES]]
        rest = [value for _, (value, _) in given[_RULES:]]
        return (tuple(kept), len(rest), round(sum(rest), 6))

    def _otherwise(self, step: Step, reasons: Reasons, actions: Sequence, answers: np.ndarray) -> list:
        key = answers.tobytes()
        if key not in self._known:
            self._known[key] = reasons.changes(answers, self.policy.potentials_of)
        changes = self._known[key]
        if not changes:
            return []
        told = InWords(self.policy, self.bias, step.state)
        named = [self._text(actions[each.best]) for each in changes]
        return [
            [self.player.texts(name), self.player.texts(told(each.test, actions[each.action])), int(each.holds)]
            for name, each in zip(named, changes, strict=True)
        ]

    def _note(self, reasons: Reasons, answers: np.ndarray, actions: Sequence, state: int, chosen: int) -> None:
        """Notes which pairs come to which leaf: how many, and some of them, chosen ones first."""
        self.pairs += len(actions)
        found = [reasons.leaves(row) for row in answers]
        given = np.array([[own[leaf] for own, leaf in zip(reasons.values, each, strict=True)] for each in found])
        self.weights += np.ptp(given, axis=0)
        for i in [chosen, *(i for i in range(len(actions)) if i != chosen)]:
            for own, leaf in zip(self._leaves, found[i], strict=True):
                known = own.setdefault(leaf, {"n": 0, "c": 0, "e": []})
                known["n"] += 1
                known["c"] += i == chosen
                if len(known["e"]) < _EXAMPLES and all(state != each[0] for each in known["e"]):
                    known["e"].append((state, self.player.texts(self._text(actions[i])), int(i == chosen)))

    def leaves(self) -> list[dict[int, dict[str, Any]]]:
        """For each tree its leaves by number: how many pairs came there, how many were chosen, and examples."""
        return self._leaves


class Drawing:
    """Draws states: as the domain does, else from their facts, of which those of the episodes tell what they mean."""

    def __init__(self, domain: Domain, episodes: Sequence[Episode]):
        self._domain = domain
        self._of: dict[int, FactsDrawing] = {}
        self._wanted = [domain.names.goal[each] for each in domain.wanted] if isinstance(domain, PddlDomain) else []
        self._owns: bool | None = None
        self._episodes = [[step.actual for step in each.steps] + [each.actual] for each in episodes]
        self._known: dict[tuple, Sequence[Shape]] = {}

    def __call__(self, state: State) -> Sequence[Shape]:
        facts = tuple(self._domain.interpreted(state).facts)
        static = id(self._domain.interpreted(state).static)
        if self._owns is None:
            self._owns = bool(shapes(self._domain, state))
        if (facts, static) not in self._known:
            self._known[facts, static] = shapes(self._domain, state) if self._owns else self._drawn(state)
        return self._known[facts, static]

    def _drawn(self, state: State) -> Sequence[Shape]:
        own = self._domain.interpreted(state)
        if id(own.static) not in self._of:
            worlds = [self._domain.interpreted(each) for states in self._episodes for each in states]
            alike = [each.facts for each in worlds if each.static is own.static] or [own.facts]
            self._of[id(own.static)] = FactsDrawing(alike, own.static.facts, self._wanted)
        return self._of[id(own.static)].shapes(own.facts)


def played(policy: Policy, count: int, seed: int) -> list[Played]:
    """So many episodes, from start states that are drawn or of the domain's problems, one after the other."""
    rng = np.random.default_rng(seed)
    found = []
    domain = policy.domain
    chosen = domain.chosen
    for i in range(count):
        number = chosen[i % len(chosen)] if chosen else None
        start = domain.problem(number) if number is not None else None
        name = domain.problems[number] if number is not None else f"episode {i + 1}"
        found.append(Played(name, generate_episode(policy, rng, start=start)))
    return found
