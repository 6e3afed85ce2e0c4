"""Races side by side in NumPy alone: what both environments are made of, and what a search uses."""

import operator
from collections.abc import Callable, Sequence
from numbers import Real
from typing import Any, NamedTuple

import numpy as np

from ._core import core
from .opponents import pool_of

STATE = np.dtype(
    [
        ("x", "f8", 4),
        ("y", "f8", 4),
        ("vx", "f8", 4),
        ("vy", "f8", 4),
        ("heading", "f8", 4),
        ("shield_timer", "i4", 4),
        ("boost_left", "i4", 4),
        ("heavy", "i4", 4),
        ("passed", "i4", 4),
        ("turns_left", "i4", 2),
        ("out_turn", "i4", 2),
        ("turn", "i4"),
        ("ending", "i4"),
        ("opponent", "i4"),
        ("fresh", "i4"),
        ("over", "i4"),
        ("checkpoints", "i4"),
        ("seed", "u8"),
        ("stream", "u8"),
        ("checkpoint_x", "f8", 16),
        ("checkpoint_y", "f8", 16),
    ]
)
"""State of one race. Pods 0 and 1 are player 0's.

Places in u, speeds in u a turn, headings in radians (NaN while unset); ``heavy``: 1 while a raised shield makes the pod
weigh 10; ``out_turn``: 2147483647 for a player who is in; ``ending``: 0 none, 1 finished, 2 all others out, 3 all out,
4 at most 500 turns; ``opponent``: number of the pool's member; ``fresh``: 1 if the next start is from ``seed`` itself;
``stream``: what later starts follow from.
"""

REWARDS = ("result", "progress", "lead")
NEVER = 2147483647


class Turn(NamedTuple):
    """One step of all races, for a reward of one's own. Races that a step begins anew have a turn of 0 in ``after``."""

    before: np.ndarray
    """States ahead of the step, of the type STATE."""
    after: np.ndarray
    """States behind it, of the same type."""
    terminated: np.ndarray
    """True of races that ended."""
    result: np.ndarray
    """1 for a victory of player 0, 0.5 for a draw, 0 for a loss; of races that ended."""


def whole(name: str, value: Any, low: int, high: int) -> int:
    """A whole number of a range, or ValueError."""
    try:
        number = operator.index(value)
    except TypeError:
        raise ValueError(f"{name}: found {value!r}, expected a whole number {low}..{high}") from None
    if isinstance(value, bool) or not low <= number <= high:
        raise ValueError(f"{name}: found {value!r}, expected a whole number {low}..{high}")
    return number


def choice(name: str, value: Any, words: Sequence[str]) -> int:
    """The index of a word, or ValueError."""
    if not isinstance(value, str) or value not in words:
        raise ValueError(f"{name}: found {value!r}, expected one of {', '.join(map(repr, words))}")
    return list(words).index(value)


def flag(name: str, value: Any) -> bool:
    """True or False, or ValueError."""
    if not isinstance(value, (bool, np.bool_)):
        raise ValueError(f"{name}: found {value!r}, expected True or False")
    return bool(value)


def array(name: str, value: Any) -> np.ndarray:
    """Any rectangular array, or ValueError."""
    try:
        return np.asarray(value)
    except ValueError:
        raise ValueError(f"{name}: found rows of several lengths, expected one array") from None


def official_map(seed: int) -> np.ndarray:
    """Checkpoints ``[n, 2]`` that a seed draws, those of ``steward match --seed``."""
    return np.array(core.draw(whole("seed", seed, 0, 2**64 - 1)))


def _maps(maps: Any) -> list[list[tuple[float, float]]]:
    if isinstance(maps, str):
        choice("maps", maps, ["official"])
        return []
    try:
        given = [[(x, y) for x, y in each] for each in maps]
    except (TypeError, ValueError):
        raise ValueError(f"maps: found {maps!r:.80}, expected 'official' or maps of checkpoints (x, y)") from None
    found = [[(_place(x), _place(y)) for x, y in each] for each in given]
    if not found:
        raise ValueError("maps: found none, expected 'official' or at least one map of checkpoints (x, y)")
    for each in found:
        if not 2 <= len(each) <= 16:
            raise ValueError(f"maps: found {len(each)} checkpoints, expected 2..16")
        if each[0] == each[1]:
            raise ValueError("maps: found the first two checkpoints in one place, expected two places")
    return found


def _place(value: Any) -> float:
    if not isinstance(value, Real) or isinstance(value, bool) or not (value == 0 or 2.0**-100 <= abs(value) <= 1e6):
        raise ValueError(f"maps: found the coordinate {value!r:.80}, expected a number up to 1e6 in size")
    return float(value)


class Races:
    """``num_envs`` races, each between the caller (player 0) and an opponent, in lockstep.

    :param opponent: ``"racer"``, a policy (observations of its seat to actions), or a :class:`Pool`
    :param rules: ``"live"``, today's server, or ``"contest"``, the published referee
    :param maps: ``"official"``, or maps of checkpoints ``(x, y)`` of which each race draws one
    :param observations: ``"site"``, what a bot is told, or ``"full"``; see docs/python.md
    :param actions: ``"continuous"``, ``[6]`` numbers in -1..1, or ``"discrete"``, ``[4]`` choices
    :param reward: ``"result"``, ``"progress"``, ``"lead"``, or a function of a :class:`Turn` to ``[num_envs]``
    :param autoreset: whether a step begins a race anew that is over; otherwise it is refused
    :param seed: race k begins with the match of seed ``seed + k``; drawn if None
    :param threads: that share out the races
    :param copy: whether returned arrays are new ones; otherwise they are overwritten by the next call
    """

    def __init__(
        self,
        num_envs: int = 1,
        *,
        opponent: Any = "racer",
        rules: str = "live",
        maps: Any = "official",
        observations: str = "site",
        actions: str = "continuous",
        reward: str | Callable[[Turn], Any] = "result",
        autoreset: bool = True,
        seed: int | None = None,
        threads: int = 1,
        copy: bool = True,
    ):
        self.num_envs = whole("num_envs", num_envs, 1, 1 << 24)
        self.settings = {
            "opponent": opponent,
            "rules": rules,
            "maps": maps,
            "observations": observations,
            "actions": actions,
            "reward": reward,
            "autoreset": autoreset,
            "threads": threads,
            "copy": copy,
        }
        self.pool = pool_of(opponent)
        self.discrete = choice("actions", actions, ["continuous", "discrete"]) == 1
        self.action_shape = (4,) if self.discrete else (6,)
        self.copy = flag("copy", copy)
        self.closed = False
        self._reward = None if isinstance(reward, str) else reward
        if self._reward is not None and not callable(reward):
            raise ValueError(f"reward: found {reward!r}, expected a function or one of {', '.join(map(repr, REWARDS))}")
        self._batch = core.Batch(
            races=self.num_envs,
            threads=whole("threads", threads, 1, 256),
            contest=choice("rules", rules, ["live", "contest"]) == 1,
            maps=_maps(maps),
            members=[(weight, member == "racer") for member, weight in self.pool.members],
            full=choice("observations", observations, ["site", "full"]) == 1,
            discrete=self.discrete,
            reward=0 if self._reward is not None else choice("reward", reward, REWARDS),
            autoreset=flag("autoreset", autoreset),
        )
        self._step = self._batch.step_discrete if self.discrete else self._batch.step
        n, numbers = self.num_envs, self._batch.observation_size
        self.observation_shape = (numbers,)
        self._kept = self._new()
        self._all = np.ones(n, np.bool_)
        self.results = np.zeros(n)
        """Of races that ended in the last step: 1 for a victory, 0.5 for a draw, 0 for a loss."""
        self.turns = np.zeros(n, np.int64)
        """Of races that ended in the last step: their turns."""
        self._policies = [(k, member) for k, (member, _) in enumerate(self.pool.members) if member != "racer"]
        if self._policies:
            self._foreign = np.empty((n, numbers), np.float32)
            self._answers = np.zeros((n, *self.action_shape), np.int64 if self.discrete else np.float32)
        first = int(np.random.SeedSequence().generate_state(1, np.uint64)[0] >> 1) if seed is None else seed
        self.seed(first)
        self._batch.reset(self._all, self._kept[0])  # so that every race has a state from the beginning
        self.seed(first)

    def _new(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        n = self.num_envs
        return np.empty((n, self._batch.observation_size), np.float32), np.empty(n), np.empty(n, np.bool_)

    def _open(self) -> None:
        if self.closed:
            raise ValueError("the environment is closed: expected one that is open")

    def _mask(self, mask: Any) -> np.ndarray:
        if mask is None:
            return self._all
        found = array("mask", mask)
        if found.dtype != np.bool_ or found.shape != (self.num_envs,):
            raise ValueError(f"mask: found {found.dtype} of the shape {found.shape}, expected bool ({self.num_envs},)")
        return np.ascontiguousarray(found)

    def seed(self, seed: int | Sequence[int | None], mask: Any = None) -> None:
        """Chooses the seeds of the next starts: ``seed + k``, or one for each race, None to leave it; of a mask's races
        if there is one."""
        self._open()
        chosen = self._mask(mask)
        n, most = self.num_envs, 2**64 - 1
        if isinstance(seed, (list, tuple, np.ndarray)):
            if len(seed) != n:
                raise ValueError(f"seed: found {len(seed)} seeds, expected {n}")
            chosen = chosen & np.array([each is not None for each in seed], np.bool_)
            values = [0 if each is None else whole("seed", each, 0, most) for each in seed]
        else:
            first = whole("seed", seed, 0, most)
            values = [(first + k) & most for k in range(n)]
        self._batch.seed(np.array(values, np.uint64), chosen)

    def reset(self, mask: Any = None) -> np.ndarray:
        """Begins all races, or those of a mask, anew. Returns all observations ``[num_envs, numbers]``, float32."""
        self._open()
        chosen = self._mask(mask)
        out = np.empty_like(self._kept[0]) if self.copy else self._kept[0]
        if chosen is not self._all:
            self._batch.observe(0, out)
        self._batch.reset(chosen, out)
        return out

    def restart(self, mask: np.ndarray, observations: np.ndarray) -> None:
        """Begins the races of a mask anew and writes their observations into an array."""
        self._batch.reset(self._mask(mask), observations)

    def actions(self, actions: Any, name: str = "actions", rows: int | None = None) -> np.ndarray:
        """Actions in the type and order of the compiled module, or ValueError."""
        shape = (self.num_envs if rows is None else rows, *self.action_shape)
        found = array(name, actions)
        kinds = "iu" if self.discrete else "iuf"
        if found.shape != shape or found.dtype.kind not in kinds:
            expected = "whole numbers" if self.discrete else "numbers"
            raise ValueError(f"{name}: found {found.dtype} of the shape {found.shape}, expected {expected} of {shape}")
        with np.errstate(over="ignore"):
            return np.ascontiguousarray(found, np.int64 if self.discrete else np.float32)

    def _opponents(self) -> np.ndarray | None:
        """Actions of the opponents that are policies."""
        if not self._policies:
            return None
        self._batch.observe(1, self._foreign)
        if len(self.pool.members) == 1:
            seen = self._foreign.copy() if self.copy else self._foreign
            self._answers[:] = self.actions(self._policies[0][1](seen), "the opponent's actions")
            return self._answers
        drawn = np.empty(self.num_envs, np.int64)
        self._batch.opponents(drawn)
        for k, policy in self._policies:
            rows = np.flatnonzero(drawn == k)
            if rows.size:
                self._answers[rows] = self.actions(policy(self._foreign[rows]), "the opponent's actions", rows.size)
        return self._answers

    def step(self, actions: Any) -> tuple[np.ndarray, np.ndarray, np.ndarray, int]:
        """Plays one turn of every race.

        :returns: observations ``[num_envs, numbers]`` in float32, rewards in float64, what ended in bool, how many
        """
        self._open()
        return self.step_both(self.actions(actions), self._opponents())

    def step_both(
        self, actions: np.ndarray, foreign: np.ndarray | None
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray, int]:
        """Plays one turn by actions that :meth:`actions` returned, of both players where the opponent is a policy."""
        observations, rewards, terminated = self._new() if self.copy else self._kept
        before = self.states() if self._reward is not None else None
        ended = self._step(actions, foreign, observations, rewards, terminated, self.results, self.turns)
        if before is not None:
            rewards[:] = self._own_reward(Turn(before, self.states(), terminated, self.results))
        return observations, rewards, terminated, ended

    def _own_reward(self, turn: Turn) -> np.ndarray:
        found = array("reward", self._reward(turn))
        if found.shape != (self.num_envs,) or found.dtype.kind not in "biuf" or not np.isfinite(found).all():
            raise ValueError(
                f"reward: found {found.dtype} of the shape {found.shape}, expected finite numbers ({self.num_envs},)"
            )
        return np.where(turn.after["turn"] == 0, 0, found)  # a step that begins a race anew has no reward

    def play(self, commands: Any, faults: Any = None) -> None:
        """Plays one turn of races that are not over by commands ``[num_envs, 4, (x, y, thrust)]`` of all pods.

        Thrust: 0..200, or -1 no command, -2 shield, -3 boost. ``faults``, bool ``[num_envs, 2]``, puts players out.
        """
        self._open()
        given, faulty = (
            array("commands", commands),
            np.zeros((self.num_envs, 2), np.bool_) if faults is None else array("faults", faults),
        )
        if given.dtype.kind not in "iuf" or given.shape != (self.num_envs, 4, 3):
            raise ValueError(
                f"commands: found {given.dtype} of the shape {given.shape}, expected numbers of ({self.num_envs}, 4, 3)"
            )
        if faulty.dtype != np.bool_ or faulty.shape != (self.num_envs, 2):
            raise ValueError(
                f"faults: found {faulty.dtype} of the shape {faulty.shape}, expected bool ({self.num_envs}, 2)"
            )
        self._batch.play(np.ascontiguousarray(given, np.float64), np.ascontiguousarray(faulty))

    def observe(self, seat: int = 0) -> np.ndarray:
        """Observations ``[num_envs, numbers]`` of player 0 or 1."""
        self._open()
        out = np.empty((self.num_envs, self._batch.observation_size), np.float32)
        self._batch.observe(whole("seat", seat, 0, 1), out)
        return out

    def commands(self, actions: Any, seat: int = 0) -> np.ndarray:
        """Commands ``[num_envs, 2, (x, y, thrust)]`` that continuous actions of a player stand for in these states."""
        self._open()
        if self.discrete:
            raise ValueError("commands: found discrete actions, expected continuous ones")
        out = np.empty((self.num_envs, 2, 3))
        self._batch.orders(whole("seat", seat, 0, 1), self.actions(actions), out)
        return out

    def racer(self, seat: int = 1) -> np.ndarray:
        """Commands ``[num_envs, 2, (x, y, thrust)]`` of ``builtin:racer`` as player 0 or 1."""
        self._open()
        out = np.empty((self.num_envs, 2, 3))
        self._batch.racer(whole("seat", seat, 0, 1), out)
        return out

    def hashes(self) -> np.ndarray:
        """Hash of each state, as it stands in a replay."""
        self._open()
        out = np.empty(self.num_envs, np.uint64)
        self._batch.hashes(out)
        return out

    def ranks(self) -> np.ndarray:
        """How many are ahead of each player, ``[num_envs, 2]``."""
        self._open()
        out = np.empty((self.num_envs, 2), np.int32)
        self._batch.ranks(out)
        return out

    def states(self) -> np.ndarray:
        """A copy of all states, ``[num_envs]`` of :data:`STATE`."""
        self._open()
        out = np.empty(self.num_envs, STATE)
        self._batch.save(out.view(np.uint8).reshape(self.num_envs, -1))
        return out

    def set_states(self, states: np.ndarray) -> None:
        """Sets all states, ``[num_envs]`` of :data:`STATE`; none changes if one is refused."""
        self._open()
        if not isinstance(states, np.ndarray) or states.dtype != STATE or states.shape != (self.num_envs,):
            found = (
                f"{states.dtype} of the shape {states.shape}" if isinstance(states, np.ndarray) else repr(states)[:80]
            )
            raise ValueError(f"states: found {found}, expected the type STATE of ({self.num_envs},)")
        self._batch.load(np.ascontiguousarray(states).view(np.uint8).reshape(self.num_envs, -1))

    def clone(self) -> "Races":
        """Races of the same settings in the same states, with the same starts to come."""
        other = Races(self.num_envs, **self.settings, seed=0)
        other.set_states(self.states())
        return other

    def close(self) -> None:
        """Refuses all further calls, and frees the races and their threads."""
        self.closed = True
        self._batch = self._step = None
