"""The race for PettingZoo: two players with two pods each, who act at the same time."""

from typing import Any

import numpy as np
from pettingzoo import ParallelEnv

from .envs import spaces_of
from .races import Races, whole

AGENTS = ["player_0", "player_1"]


class ParallelRace(ParallelEnv):
    """One race between two agents. Rewards: 1 for a victory, -1 for a loss, at the end. ``rules``, ``maps``,
    ``observations``, ``actions`` and ``seed`` are those of :class:`Races`."""

    metadata = {"name": "steward_podrace_v0", "render_modes": [], "is_parallelizable": True}

    def __init__(
        self,
        render_mode: None = None,
        *,
        rules: str = "live",
        maps: Any = "official",
        observations: str = "site",
        actions: str = "continuous",
        seed: int | None = None,
    ):
        if render_mode is not None:
            raise ValueError(f"render_mode: found {render_mode!r}, expected None")
        self.render_mode = None
        self.races = Races(
            1,
            opponent=lambda seen: None,
            rules=rules,
            maps=maps,
            observations=observations,
            actions=actions,
            autoreset=False,
            seed=seed,
        )
        self.possible_agents = list(AGENTS)
        self.agents: list[str] = []
        spaces = [spaces_of(self.races) for _ in AGENTS]  # each has a random state of its own
        self.observation_spaces = {agent: each[0] for agent, each in zip(AGENTS, spaces)}
        self.action_spaces = {agent: each[1] for agent, each in zip(AGENTS, spaces)}

    def observation_space(self, agent: str) -> Any:
        """The space of an agent's observations."""
        return self.observation_spaces[agent]

    def action_space(self, agent: str) -> Any:
        """The space of an agent's actions."""
        return self.action_spaces[agent]

    def reset(self, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[dict, dict]:
        """Begins a race: with a seed that of ``steward match --seed``, else one that follows from the last seed."""
        if seed is not None:
            self.races.seed(whole("seed", seed, 0, 2**64 - 1))
        self.races.reset()
        self.agents = list(AGENTS)
        return self._seen(), {agent: {} for agent in AGENTS}

    def _seen(self) -> dict[str, np.ndarray]:
        return {agent: self.races.observe(seat)[0] for seat, agent in enumerate(AGENTS)}

    def step(self, actions: dict[str, Any]) -> tuple[dict, dict, dict, dict, dict]:
        """Plays one turn by an action of each agent."""
        if not isinstance(actions, dict) or set(actions) != set(self.agents) or not self.agents:
            found = f"those of {list(actions)}" if isinstance(actions, dict) else f"{actions!r:.80}"
            raise ValueError(f"actions: found {found}, expected those of {self.agents or 'a race: reset it first'}")
        races = self.races
        given = [races.actions([actions[agent]], f"action of {agent}") for agent in AGENTS]
        races._open()
        _, rewards, _, ended = races.step_both(*given)
        reward = float(rewards[0])
        if ended:
            self.agents = []
        return (
            self._seen(),
            {"player_0": reward, "player_1": -reward},
            dict.fromkeys(AGENTS, ended > 0),
            dict.fromkeys(AGENTS, False),
            {agent: {} for agent in AGENTS},
        )

    def close(self) -> None:
        """Refuses all further calls."""
        self.races.close()


def parallel_env(**settings: Any) -> ParallelRace:
    """An environment for PettingZoo; see :class:`ParallelRace`."""
    return ParallelRace(**settings)
