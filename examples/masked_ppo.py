"""Another library learns the blocks world: MaskablePPO of sb3-contrib, a neural policy.

pip install 'nppg[gym]' sb3-contrib
python examples/masked_ppo.py --blocks 4 --steps 50000 --seed 0
"""

from __future__ import annotations

import argparse
import time

import gymnasium
import torch
from sb3_contrib import MaskablePPO

import nppg.gym_env  # noqa: F401  registers the environments


def success(model: MaskablePPO, env: gymnasium.Env, starts: int, greedy: bool) -> float:
    """The share of episodes that reach the goal in the minimal number of moves; their starts are those of seed 0."""
    reached = 0
    for number in range(starts):
        observation, info = env.reset(seed=0 if number == 0 else None)
        over = False
        while not over:
            mask = info["action_mask"].astype(bool)
            action, _ = model.predict(observation, deterministic=greedy, action_masks=mask)
            observation, _, terminated, truncated, info = env.step(int(action))
            over = terminated or truncated
        reached += info["is_success"]
    return reached / starts


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--blocks", type=int, default=4)
    parser.add_argument("--steps", type=int, default=50_000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--starts", type=int, default=1000, help="episodes of each evaluation")
    options = parser.parse_args()
    torch.set_num_threads(1)
    name = "nppg/blocks_world-bounded-v0"
    env = gymnasium.make(name, parameters={"blocks": options.blocks}, horizon_factor=4)
    test = gymnasium.make(name, parameters={"blocks": options.blocks}, slots=env.unwrapped.slots)
    print(f"{name}, {options.blocks} blocks: observation {env.observation_space.shape}, seed {options.seed}")
    model = MaskablePPO("MlpPolicy", env, gamma=0.9, seed=options.seed, device="cpu")

    def report(when: str) -> None:
        sampled, greedy = (success(model, test, options.starts, each) for each in (False, True))
        print(f"{when}: success {sampled:.3f} sampled, {greedy:.3f} greedy, over {options.starts} starts", flush=True)

    report("before")
    begin = time.perf_counter()
    model.learn(options.steps)
    print(f"learned from {model.num_timesteps} steps in {time.perf_counter() - begin:.0f} s")
    report("after")


if __name__ == "__main__":
    main()
