"""Environments for Gymnasium: one race, and many that are the same as so many single ones."""

from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces
from gymnasium.vector import AutoresetMode
from gymnasium.vector.utils import batch_space

from .races import Races, whole

BOUND = 1e7
"""No number of an observation is greater: places and speeds are below 2^30 u."""


def spaces_of(races: Races) -> tuple[spaces.Box, spaces.Space]:
    """The spaces of a single race's observation and action."""
    seen = spaces.Box(-BOUND, BOUND, races.observation_shape, np.float32)
    return seen, spaces.MultiDiscrete([7, 5, 7, 5]) if races.discrete else spaces.Box(
        -1, 1, races.action_shape, np.float32
    )


class RaceEnv(gymnasium.Env):
    """One race against an opponent. Arguments are those of :class:`Races`; ``info`` of the last step has ``result``
    (1, 0.5 or 0) and ``turns``."""

    metadata = {"render_modes": []}

    def __init__(self, render_mode: None = None, **settings: Any):
        self.render_mode = _none(render_mode)
        self.races = Races(1, autoreset=False, **settings)
        self.observation_space, self.action_space = spaces_of(self.races)

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[np.ndarray, dict]:
        """Begins a race: with a seed that of ``steward match --seed``, else one that follows from the last seed."""
        if seed is not None:
            seed = whole("seed", seed, 0, 2**64 - 1)
            self.races.seed(seed)
        super().reset(seed=seed)
        return self.races.reset()[0], {}

    def step(self, action: Any) -> tuple[np.ndarray, float, bool, bool, dict]:
        """Plays one turn. Races are never truncated: 500 turns are an end by the rules."""
        races = self.races
        given = races.actions([action], "action")
        races._open()
        seen, rewards, terminated, ended = races.step_both(given, races._opponents())
        info = {"result": float(races.results[0]), "turns": int(races.turns[0])} if ended else {}
        return seen[0], float(rewards[0]), bool(terminated[0]), False, info

    def states(self) -> np.ndarray:
        """The state, one of the type STATE."""
        return self.races.states()

    def set_states(self, states: np.ndarray) -> None:
        """Sets the state."""
        self.races.set_states(states)

    def clone(self) -> "RaceEnv":
        """An environment in the same state, with the same starts to come."""
        other = RaceEnv(**{name: value for name, value in self.races.settings.items() if name != "autoreset"}, seed=0)
        other.set_states(self.states())
        return other

    def close(self) -> None:
        """Refuses all further calls."""
        self.races.close()


class RaceVectorEnv(gymnasium.vector.VectorEnv):
    """Many races in lockstep, equal to as many :class:`RaceEnv` in a SyncVectorEnv, in each mode of autoreset.

    Arguments are those of :class:`Races`, which is in ``races``; ``autoreset_mode`` is a mode of Gymnasium or its name.
    With ``copy=False`` all arrays that are returned are overwritten by the next call.
    """

    metadata = {"render_modes": []}

    def __init__(
        self,
        num_envs: int = 1,
        *,
        autoreset_mode: AutoresetMode | str = AutoresetMode.NEXT_STEP,
        render_mode: None = None,
        **settings: Any,
    ):
        try:
            self.autoreset_mode = AutoresetMode(autoreset_mode)
        except ValueError:
            raise ValueError(
                f"autoreset_mode: found {autoreset_mode!r}, expected one of "
                f"{', '.join(repr(mode.value) for mode in AutoresetMode)}"
            ) from None
        self.render_mode = _none(render_mode)
        self.metadata = {**self.metadata, "autoreset_mode": self.autoreset_mode}
        self.races = Races(num_envs, autoreset=self.autoreset_mode == AutoresetMode.NEXT_STEP, **settings)
        self.num_envs = self.races.num_envs
        self.single_observation_space, self.single_action_space = spaces_of(self.races)
        self.observation_space = batch_space(self.single_observation_space, self.num_envs)
        self.action_space = batch_space(self.single_action_space, self.num_envs)
        self._truncated = np.zeros(self.num_envs, np.bool_)
        self._values = np.zeros(self.num_envs), np.zeros(self.num_envs, np.int64)

    def reset(self, *, seed: Any = None, options: dict[str, Any] | None = None) -> tuple[np.ndarray, dict]:
        """Begins all races anew, or those of ``options={"reset_mask": ...}``. ``seed`` is a number, to which each adds
        its index, or a list with a number or None for each."""
        mask = None
        if options is not None and not isinstance(options, dict):
            raise ValueError(f"options: found {options!r:.80}, expected a dict or None")
        if options is not None and "reset_mask" in options:
            mask = options["reset_mask"]
            if (
                not isinstance(mask, np.ndarray)
                or mask.dtype != np.bool_
                or mask.shape != (self.num_envs,)
                or not mask.any()
            ):
                raise ValueError(
                    f"reset_mask: found {mask!r}, expected a bool array ({self.num_envs},), one at least true"
                )
        if seed is not None:
            self.races.seed(seed, mask)
        return self.races.reset(mask), {}

    def step(self, actions: Any) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, dict[str, Any]]:
        """Plays one turn of every race. Of races that ended, ``infos`` has ``result`` and ``turns``."""
        seen, rewards, terminated, ended = self.races.step(actions)
        infos = self._infos(seen, terminated) if ended else {}
        return seen, rewards, terminated, self._truncated.copy() if self.races.copy else self._truncated, infos

    def _infos(self, seen: np.ndarray, terminated: np.ndarray) -> dict[str, Any]:
        copy = self.races.copy
        infos: dict[str, Any] = {}
        for name, kept, found in zip(("result", "turns"), self._values, (self.races.results, self.races.turns)):
            values = np.zeros_like(kept) if copy else kept
            values[:] = 0
            np.copyto(values, found, where=terminated)
            infos[name], infos[f"_{name}"] = values, terminated.copy() if copy else terminated
        if self.autoreset_mode != AutoresetMode.SAME_STEP:
            return infos
        last = np.full(self.num_envs, None, object)
        for k in np.flatnonzero(terminated):
            last[k] = seen[k].copy()
        self.races.restart(terminated, seen)
        mask = terminated.copy()
        return {"final_obs": last, "_final_obs": mask, "final_info": infos, "_final_info": mask.copy()}

    def states(self) -> np.ndarray:
        """A copy of all states, of the type STATE."""
        return self.races.states()

    def set_states(self, states: np.ndarray) -> None:
        """Sets all states."""
        self.races.set_states(states)

    def clone(self) -> "RaceVectorEnv":
        """An environment in the same states, with the same starts to come."""
        settings = {name: value for name, value in self.races.settings.items() if name != "autoreset"}
        other = RaceVectorEnv(self.num_envs, autoreset_mode=self.autoreset_mode, **settings, seed=0)
        other.set_states(self.states())
        return other

    def close_extras(self, **kwargs: Any) -> None:
        """Refuses all further calls."""
        self.races.close()


def _none(render_mode: Any) -> None:
    if render_mode is not None:
        raise ValueError(f"render_mode: found {render_mode!r}, expected None: replays are drawn by show()")
