"""An exported bot gives the commands of its policy, in both seats."""

import subprocess
import sys

import numpy as np
import pytest

from steward_podrace import Network, Races, export

GAMES = 3


def lines(races, seat, setup):
    """What the site tells a player: the setup, then a line a pod."""
    state, out = races.states()[0], []
    n = int(state["checkpoints"])
    if setup:
        out += ["3", str(n)] + [
            f"{x:.0f} {y:.0f}" for x, y in zip(state["checkpoint_x"][:n], state["checkpoint_y"][:n])
        ]
    for pod in (2 * seat, 2 * seat + 1, 2 - 2 * seat, 3 - 2 * seat):
        degrees = np.degrees(state["heading"][pod]) % 360
        angle = -1 if np.isnan(degrees) else int(np.floor(degrees + 0.5))
        out.append(
            f"{state['x'][pod]:.0f} {state['y'][pod]:.0f} {state['vx'][pod]:.0f} {state['vy'][pod]:.0f} {angle} "
            f"{(state['passed'][pod] + 1) % n}"
        )
    return "\n".join(out) + "\n"


@pytest.mark.parametrize("seat", [0, 1])
@pytest.mark.parametrize("outputs", [2, 3])
def test_commands_of_the_bot_are_the_policys(seat, outputs, tmp_path):
    rng, words = np.random.default_rng(outputs), {-2: "SHIELD", -3: "BOOST"}
    # aims at the next checkpoint, with some chance in all other numbers
    first, last = rng.normal(0, 0.3, (38, 8)), rng.normal(0, 0.5, (8, outputs))
    first[3, 0], last[0] = 3, 0
    last[0, 0] = 3
    policy = Network([(first, rng.normal(0, 0.1, 8)), (last, np.array([0, 2, 0.3][:outputs]))])
    export(policy, tmp_path / "bot.py")
    for game in range(GAMES):
        races = Races(1, seed=100 * seat + game, autoreset=False)
        races.reset()
        turns = 0
        with subprocess.Popen(
            [sys.executable, "-S", "bot.py"], cwd=tmp_path, text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE
        ) as bot:
            while not races.states()["over"][0]:
                bot.stdin.write(lines(races, seat, turns == 0))
                bot.stdin.flush()
                own = races.commands(policy(races.observe(seat)), seat)
                said = [bot.stdout.readline().strip() for _ in range(2)]
                assert said == [f"{x:.0f} {y:.0f} {words.get(int(thrust), int(thrust))}" for x, y, thrust in own[0]], (
                    turns
                )
                commands = np.zeros((1, 4, 3))
                commands[:, 2 * seat : 2 * seat + 2] = own
                commands[:, 2 - 2 * seat : 4 - 2 * seat] = races.racer(1 - seat)
                races.play(commands)
                turns += 1
            bot.stdin.close()
            assert bot.wait() == 0
        assert turns > 50
