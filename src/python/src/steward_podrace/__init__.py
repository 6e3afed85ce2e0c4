"""Thousands of exact pod races at once, and Steward's replays as tables.

Turns, maps, ends and ranks are those of Steward's engine for the scene ``mad-pod-racing``, to the last bit. NumPy is
all that is needed; with Gymnasium there are :class:`RaceVectorEnv` and :class:`RaceEnv`, with PettingZoo
:func:`parallel_env`.
"""

from importlib.util import find_spec

from ._core import module_name
from .network import Network, export
from .opponents import Pool
from .races import STATE, Races, Turn, official_map
from .replays import Replay, read_replay
from .show import show

__all__ = [
    "STATE",
    "Network",
    "Pool",
    "Races",
    "Replay",
    "Turn",
    "export",
    "module_name",
    "official_map",
    "read_replay",
    "show",
]
__version__ = "0.3.0"


def _is_new_enough() -> bool:
    if find_spec("gymnasium") is None:
        return False
    from gymnasium import vector

    return hasattr(vector, "AutoresetMode")


def __getattr__(name: str) -> object:
    if name in ("RaceEnv", "RaceVectorEnv"):
        raise ImportError(f"{name}: expected gymnasium 1.1 or newer: pip install 'steward-podrace[gymnasium]'")
    if name in ("ParallelRace", "parallel_env"):
        raise ImportError(f"{name}: expected pettingzoo and gymnasium: pip install 'steward-podrace[pettingzoo]'")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


if _is_new_enough():
    import gymnasium

    from .envs import RaceEnv, RaceVectorEnv

    __all__ += ["RaceEnv", "RaceVectorEnv"]
    if "steward/PodRace-v0" not in gymnasium.registry:
        gymnasium.register("steward/PodRace-v0", entry_point=RaceEnv, vector_entry_point=RaceVectorEnv)

    if find_spec("pettingzoo") is not None:
        from .parallel import ParallelRace, parallel_env

        __all__ += ["ParallelRace", "parallel_env"]
