"""Races of the Java engine, as `gradlew raceGames` writes them; see RaceGames.java for the format."""

import os
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

TURN_WORDS = 12 + 4 + 32 + 2 + 1


class Game(NamedTuple):
    seed: int
    contest: bool
    checkpoints: np.ndarray
    turns: np.ndarray
    """Words of 8 bytes, ``[turns, TURN_WORDS]``, uint64."""
    ending: int
    ranks: tuple[int, int]


def read() -> tuple[list[Game], np.ndarray]:
    """All games, and angles with cosine and sine."""
    path = os.environ.get("STEWARD_GAMES")
    if not path or not Path(path).exists():
        pytest.skip("no races of the engine: ./gradlew pythonTest writes them")
    words, games, at = np.fromfile(path, "<u8"), [], 0
    numbers = words.view("<f8")
    while words[at] == 1:
        seed, contest, count = (int(each) for each in words[at + 1 : at + 4])
        checkpoints = numbers[at + 4 : at + 4 + 2 * count].reshape(count, 2)
        at = begin = at + 4 + 2 * count
        while words[at] == 2:
            at += 1 + TURN_WORDS
        turns = words[begin:at].reshape(-1, 1 + TURN_WORDS)[:, 1:]
        games.append(
            Game(seed, contest == 1, checkpoints, turns, int(words[at + 1]), tuple(map(int, words[at + 2 : at + 4])))
        )
        at += 4
    return games, numbers[at + 1 :].reshape(-1, 3)
