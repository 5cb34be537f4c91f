"""What ACE's settings say, but for the language: see mode_terms.py."""

from __future__ import annotations

from collections.abc import Iterable

from nppg.bridge.terms import Ground
from nppg.errors import NppgError, Problem, suggestion
from nppg.tilde.program import Clause
from nppg.tilde.task import CLASSIFY, REGRESS, Settings
from nppg.tilde.terms import (
    Indicator,
    arguments,
    elements,
    indicator,
    told,
)

LANGUAGE = ("rmode", "warmode", "lookahead", "auto_lookahead")
_VALUE_NAMES = """
accuracy classes confidence_level discretize exhaustive_lookahead ftest heuristic load max_lookahead minimal_cases
pruning random_validation_set tilde_maxdepth tilde_mode typed_language
"""
_TERM_NAMES = "euclid predicate predict root to_be_discretized type"
_SILENT_NAMES = """
add_predictions_to bg_file combination_rule compatibility example_cache execute expert_implicit_language
generation_order granularity huge intra_literal_sharing kb_file language_warnings leave_out log_pid
mi_distance_maxsample minconf minfreq multiscore odbc old_expand outerloop output_dir output_options precompute
prune_rules query_batch_size report_timings resume show_averages single_query_generation talking
tilde_rst_optimization tilde_version transform_queries use_package use_packs warmr_assoc warmr_assoc_output_options
warmr_maxdepth write_predictions
"""
_VALUES, _TERMS = _VALUE_NAMES.split(), _TERM_NAMES.split()
_SILENT = frozenset(_SILENT_NAMES.split())  # of no meaning for the tree
_NOT_CARRIED_OVER = {
    "constraint": "modes and types alone say what may be tested",
    "discretization": "thresholds are those of to_be_discretized, or found anew at each node: rmode(+X =< #)",
    "m_estimate": "a leaf predicts by the shares of its examples",
    "random_test_set": "nppg tilde predict judges other examples",
    "sampling_strategy": "all examples are looked at",
    "special_test": "constants are those of the modes",
}
_HEURISTICS = {"gain": "gain", "gainratio": "gain_ratio", "gain_ratio": "gain_ratio"}
_PRUNING = {"c45": "c45", "none": "none", "no": "none", "off": "none", "safe": "safe", "vsb": "validation"}


class Given:
    """What a settings file says; what is unknown is told in `left_out`, with its line."""

    def __init__(self, clauses: Iterable[Clause], left_out: list[Problem]):
        self.left_out = left_out
        self.values: dict[str, Clause] = {}  # the last of each name
        self.terms: dict[str, list[Clause]] = {}
        self.language: list[Clause] = []
        known = [*_VALUES, *_TERMS, *LANGUAGE]
        for clause in clauses:
            name, arity = clause.predicate
            if clause.kind == "rule" and clause.calls:
                left_out.append(clause.problem(f"a setting is a fact: the rule {name}/{arity} is left out"))
            elif name in LANGUAGE and arity == (2 if name.endswith("lookahead") else 1):
                self.language.append(clause)
            elif name in _VALUES and arity == 1:
                self.values[name] = clause
            elif name in _TERMS:
                self.terms.setdefault(name, []).append(clause)
            elif (name, arguments(clause.data)) in (("sampling_strategy", ("none",)), ("discretization", ("none",))):
                continue
            elif name in _NOT_CARRIED_OVER:
                self._aside(clause, f"is not carried over: {_NOT_CARRIED_OVER[name]}")
            elif name not in _SILENT:
                self._aside(clause, f"is no setting that nppg knows{suggestion(name, known)}")
            elif name == "leave_out" and arguments(clause.data) != ("false",):
                self._aside(clause, "is for the command line: --cross-validate")

    def _aside(self, clause: Clause, why: str) -> None:
        self.left_out.append(clause.problem(f"{told(clause.data)} is left aside: it {why}"))

    def value(self, name: str, default: Ground) -> Ground:
        clause = self.values.get(name)
        return arguments(clause.data)[0] if clause else default

    def whole(self, name: str, default: int, least: int = 0) -> int:
        """A whole number; what is none is told, and the default stands."""
        value = self.value(name, default)
        if type(value) is int and value >= least:
            return value
        if value != "inf":
            self._aside(self.values[name], f"has to be a whole number of at least {least}")
        return default

    def share(self, name: str, default: float) -> float:
        value = self.value(name, default)
        if type(value) in (int, float) and 0 < value <= 1:  # type: ignore[operator]
            return float(value)  # type: ignore[arg-type]
        self._aside(self.values[name], "has to be a number above 0 and at most 1")
        return default

    @property
    def load(self) -> str:
        return str(self.value("load", ""))

    @property
    def classes(self) -> tuple[Ground, ...]:
        listed = elements(self.value("classes", ("[]",)))
        return tuple(listed or ())

    @property
    def is_typed(self) -> bool:
        return self.value("typed_language", "no") in ("yes", "on", "true")

    def settings(self) -> Settings:
        """How the tree is grown. Raises NppgError where it is to be none that nppg grows."""
        mode = str(indicator(self.value("tilde_mode", CLASSIFY))[0])
        if mode not in ("classify", "classification", "regress", "regression"):
            raise NppgError(
                [self.values["tilde_mode"].problem(f"tilde_mode({mode}) is none of nppg's: classify or regression")]
            )
        kind = REGRESS if mode.startswith("regress") else CLASSIFY
        heuristic = "gain_ratio" if kind == CLASSIFY else "variance"
        given = self.value("heuristic", "")
        if kind == CLASSIFY and given:
            heuristic = _HEURISTICS.get(str(given), heuristic)
            if given not in _HEURISTICS:
                self._aside(self.values["heuristic"], f"is none of nppg's heuristics: {' or '.join(_HEURISTICS)}")
        pruning = _PRUNING.get(str(self.value("pruning", "c45")), "")
        if not pruning:
            self._aside(self.values["pruning"], f"is none of nppg's: {', '.join(_PRUNING)}")
        if self.value("accuracy", 1.0) not in (1, 1.0):
            self._aside(self.values["accuracy"], "is not carried over: only a pure node is a leaf")
        share = self.value("random_validation_set", 0)
        return Settings(
            mode=kind,
            heuristic=heuristic,
            minimal_cases=self.whole("minimal_cases", 2, 1),
            max_depth=self.whole("tilde_maxdepth", 0),
            significance=self.share("ftest", 0.05) if kind == REGRESS else 1.0,
            pruning="none" if kind == REGRESS else pruning or "c45",
            confidence=self.share("confidence_level", 0.25),
            validation_share=float(share) if isinstance(share, int | float) and 0 < share <= 0.9 else 0.25,
        )

    def types(self, declared: Iterable[tuple[Indicator, tuple[str, ...]]]) -> dict[Indicator, tuple[str, ...]]:
        """Those of the predicates, where the language is typed."""
        return dict(declared) if self.is_typed else {}
