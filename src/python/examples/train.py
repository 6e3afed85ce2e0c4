"""Trains a small network against racer by evolution strategies, in NumPy alone, and writes it as a bot of one file.

    python examples/train.py --seed 1 --threads 2 --out bot.py
    steward match --bot 'codingame:python3 bot.py' --bot builtin:regular --games 20 --swap

Method: antithetic Gaussian perturbations, ranks in place of returns, Adam (Salimans and others 2017, "Evolution
Strategies as a Scalable Alternative to Reinforcement Learning"). A return is the number of checkpoints
that the better pod has passed when the race ends. Training ends when 196 of 200 games of its own are won.
"""

import argparse
import time

import numpy as np

from steward_podrace import Network, RaceVectorEnv, export

PAIRS, GAMES, TURNS = 32, 32, 250
"""Perturbations with both signs, races of each, and turns of a race that count."""
INPUTS = list(range(8))
"""Own speed, direction and distance of the next checkpoint and of the one after it."""
SHAPES = ((len(INPUTS), 16), (16, 2))
SIGMA, RATE = 0.1, 0.05


def unpack(parameters: np.ndarray) -> list[tuple[np.ndarray, np.ndarray]]:
    """Layers of parameters ``[..., count]``."""
    layers, at = [], 0
    for rows, columns in SHAPES:
        weights = parameters[..., at : at + rows * columns].reshape(*parameters.shape[:-1], rows, columns)
        at += rows * columns
        layers.append((weights, parameters[..., at : at + columns]))
        at += columns
    return layers


def returns(env: RaceVectorEnv, population: np.ndarray, seed: int) -> np.ndarray:
    """Mean progress of each member, ``[members]``; all play on the same maps."""
    members, games = len(population), env.num_envs // len(population)
    layers = unpack(population.astype(np.float32))
    seen, _ = env.reset(seed=[seed + k for _ in range(members) for k in range(games)])
    total, going = np.zeros(env.num_envs), np.ones(env.num_envs, bool)
    actions = np.zeros((members, games * 2, 3), np.float32)
    for _ in range(TURNS):
        values = seen[:, :76].reshape(-1, 2, 38)[:, :, INPUTS].reshape(members, games * 2, -1)
        for weights, biases in layers:
            values = np.tanh(values @ weights + biases[:, None])
        actions[:, :, :2] = values
        seen, rewards, ended, _, _ = env.step(actions.reshape(env.num_envs, 6))
        total += np.where(going, rewards, 0)
        going &= ~ended
    return total.reshape(members, games).mean(1)


def share(policy: Network, opponent: object, games: int, seed: int, threads: int = 1) -> float:
    """Share of the games that a policy wins; a draw is half a game."""
    env = RaceVectorEnv(games, opponent=opponent, seed=seed, threads=threads)
    seen, _ = env.reset()
    results = np.full(games, np.nan)
    while np.isnan(results).any():
        seen, _, ended, _, infos = env.step(policy(seen))
        first = ended & np.isnan(results)
        if first.any():
            results[first] = infos["result"][first]
    return float(results.mean())


def regular(seen: np.ndarray) -> np.ndarray:
    """The bot regular as far as an observation tells: aims against its drift, the less thrust the more it turns."""
    actions = np.zeros((len(seen), 2, 3), np.float32)
    for k in range(2):
        pod = seen[:, 38 * k : 38 * k + 5].astype(np.float64)
        forward, right = (1e4 * pod[:, 4] * pod[:, 2 + each] - 3e3 * pod[:, each] for each in range(2))
        angle = np.arctan2(right, forward)
        actions[:, k, 0] = np.clip(np.degrees(angle) / 18, -1, 1)
        actions[:, k, 1] = np.floor(200 * np.maximum(0, np.cos(angle))) / 100 - 1
    return actions.reshape(-1, 6)


def train(seed: int, threads: int, minutes: float) -> Network:
    """Returns a network that beats racer, or the last one when the time is over."""
    rng = np.random.default_rng(seed)
    count = sum(rows * columns + columns for rows, columns in SHAPES)
    mean, first, second = rng.normal(0, 0.3, count), np.zeros(count), np.zeros(count)
    env = RaceVectorEnv(2 * PAIRS * GAMES, reward="progress", copy=False, seed=seed, threads=threads)
    begin = time.monotonic()
    print(f"untrained: {share(Network(unpack(mean), INPUTS), 'racer', 100, 10**9):.0%} of 100 games against racer")
    for generation in range(1, 10**6):
        noise = rng.normal(size=(PAIRS, count))
        found = returns(env, np.concatenate([mean + SIGMA * noise, mean - SIGMA * noise]), int(rng.integers(2**40)))
        ranks = found.argsort().argsort() / (len(found) - 1) - 0.5
        gradient = (ranks[:PAIRS] - ranks[PAIRS:]) @ noise / PAIRS
        first = 0.9 * first + 0.1 * gradient
        second = 0.99 * second + 0.01 * gradient**2
        mean = mean + RATE * (first / (1 - 0.9**generation)) / (np.sqrt(second / (1 - 0.99**generation)) + 1e-8)
        if generation % 5 == 0:
            policy = Network(unpack(mean.astype(np.float32)), INPUTS)
            won = share(policy, "racer", 200, 2 * 10**9, threads)
            spent = time.monotonic() - begin
            print(
                f"{spent:4.0f} s, generation {generation}: {found.mean():.2f} checkpoints, {won:.0%} of 200 games",
                flush=True,
            )
            if won >= 0.98 or spent > 60 * minutes:
                return policy


def main() -> None:
    """Trains, tests on games of other seeds, and exports."""
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--threads", type=int, default=2)
    options.add_argument("--minutes", type=float, default=10)
    options.add_argument("--out", default="bot.py")
    chosen = options.parse_args()
    policy = train(chosen.seed, chosen.threads, chosen.minutes)
    print(
        f"trained: {share(policy, 'racer', 100, 10**9):.0%} of 100 games against racer, "
        f"{share(policy, regular, 100, 10**9):.0%} against regular by observation"
    )
    export(policy, chosen.out)
    print(f"{chosen.out} written")


if __name__ == "__main__":
    main()
