"""The paper's variants, and those beside it, compared on a numeric and on a relational domain.

python -m benchmarks.variants --seeds 5
"""

from __future__ import annotations

import argparse
from statistics import mean

from nppg import Domain, LanguageBias, Options, evaluate, train
from nppg.shipped import locate

WORLDS: dict[str, dict] = {
    "corridor": {"episodes": 150, "min_examples": 200, "episodes_per_iteration": 5, "step_size": 0.5},
    "delivery": {"episodes": 600},
}
SETTINGS: list[tuple[str, dict]] = [
    ("as shipped: the paper's", {}),
    ("`models: per-action`", {"models": "per-action"}),
    ("`update: taken`", {"update": "taken"}),
    ("`line_search: 3`", {"line_search": 3}),
    ("`normalise: yes`", {"normalise": "yes"}),
    ("`critic: value`", {"critic": "value"}),
    ("`critic: value`, `cut_off: bootstrap`", {"critic": "value", "cut_off": "bootstrap"}),
    ("`critic: value`, `trace: 0.9`", {"critic": "value", "trace": 0.9}),
    ("the same, `normalise: yes`", {"critic": "value", "trace": 0.9, "normalise": "yes"}),
    ("`step: second-order`", {"step": "second-order"}),
    ("the same, `critic: value`, `trace: 0.9`", {"step": "second-order", "critic": "value", "trace": 0.9}),
]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--seeds", type=int, default=5, help="seeds 0 to N - 1")
    seeds = parser.parse_args().seeds
    worlds = [(Domain(each), LanguageBias.load(locate(each, "language_bias", ".yaml"))) for each in WORLDS]
    columns = [f"{name}, {what}" for name in WORLDS for what in ("return", "worst", "success")]
    print(f"| setting | {' | '.join(columns)} |", "|---" * (len(columns) + 1) + "|", sep="\n", flush=True)
    for name, changes in SETTINGS:
        cells = []
        for (domain, bias), base in zip(worlds, WORLDS.values(), strict=True):
            runs = [list(train(domain, bias, Options(**(base | changes), seed=seed)))[-1] for seed in range(seeds)]
            found = [evaluate(run.policy, 500, seed=1000) for run in runs]
            gains = [each.mean_return or 0.0 for each in found]
            cells += [mean(gains), min(gains), mean(each.success for each in found)]
        print(f"| {name} | {' | '.join(f'{each:.2f}' for each in cells)} |", flush=True)


if __name__ == "__main__":
    main()
