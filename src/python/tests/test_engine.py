"""The C++ race beside the Java engine: states, ends, ranks, hashes, and the commands of racer."""

import numpy as np
import pytest

from steward_podrace import Races
from steward_podrace import races as races_module
from steward_podrace._core import load

from games import read

FIELDS = ("x", "y", "vx", "vy", "heading", "shield_timer", "boost_left", "passed")


def modules():
    return [name for name in ("plain", "avx2") if name == "plain" or load("plain").HAS_AVX2]


def same(found, expected):
    """Bit by bit, but that all NaN are one."""
    return (found.view("u8") == expected.view("u8")) | (np.isnan(found) & np.isnan(expected))


@pytest.mark.parametrize("module", modules())
@pytest.mark.parametrize("contest", [False, True])
def test_every_state_end_rank_and_hash_is_the_engines(module, contest, monkeypatch):
    monkeypatch.setattr(races_module, "core", load(module))
    games = [game for game in read()[0] if game.contest == contest]
    races = Races(len(games), rules="contest" if contest else "live")
    races.seed([game.seed for game in games])
    races.reset()
    start = races.states()
    for k, game in enumerate(games):
        n = len(game.checkpoints)
        assert start["checkpoints"][k] == n
        np.testing.assert_array_equal(start["checkpoint_x"][k, :n], game.checkpoints[:, 0])
        np.testing.assert_array_equal(start["checkpoint_y"][k, :n], game.checkpoints[:, 1])
    differ = commanded = turns = 0
    for turn in range(max(len(game.turns) for game in games)):
        rows = np.array([game.turns[min(turn, len(game.turns) - 1)] for game in games])
        going = np.array([turn < len(game.turns) for game in games])
        commands = rows[:, :12].copy().view("f8").reshape(-1, 4, 3)
        marks = rows[:, 12:16].reshape(-1, 2, 2)
        commands[commands[..., 2] == -1, :2] = 0
        faults = marks[..., 0] == 1
        for player in range(2):
            drives = going & (marks[:, player, 1] == 1) & ~faults[:, player]
            commanded += drives.sum()
            own = races.racer(player)
            wrong = drives & (own != commands[:, 2 * player : 2 * player + 2]).any((1, 2))
            assert not wrong.any(), f"racer in game {np.flatnonzero(wrong)[0]}, turn {turn}: {own[wrong][0]}"
        races.play(commands, faults)
        states = races.states()
        after = rows[:, 16:48].copy().view("f8").reshape(-1, 4, 8)
        for k, field in enumerate(FIELDS):
            equal = same(np.ascontiguousarray(states[field], "f8"), np.ascontiguousarray(after[:, :, k]))
            differ += (going & ~equal.all(1)).sum()
        differ += (going & (states["turns_left"] != rows[:, 48:50].copy().view("f8")).any(1)).sum()
        differ += (going & (races.hashes() != rows[:, 50])).sum()
        turns += going.sum()
        assert differ == 0, f"turn {turn}"
    states = races.states()
    np.testing.assert_array_equal(states["ending"], [game.ending for game in games])
    np.testing.assert_array_equal(states["turn"], [len(game.turns) for game in games])
    np.testing.assert_array_equal(races.ranks(), [game.ranks for game in games])
    print(f"{module}, contest {contest}: {len(games)} games, {turns} turns, {commanded} answers of racer, 0 different")
    assert turns > 0 and commanded > 0


@pytest.mark.parametrize("module", modules())
def test_sines_are_those_of_StrictMath(module):
    angles = read()[1]
    found = np.array([load(module).strict_turn(angle) for angle in angles[:, 0]])
    np.testing.assert_array_equal(found, angles[:, 1:])
