"""Opponents: ``"racer"``, a policy, or a pool of both with weights."""

from collections.abc import Callable, Sequence
from numbers import Real
from typing import Any

import numpy as np

Policy = Callable[[np.ndarray], Any]
"""A policy takes observations ``[n, numbers]`` of its own seat and returns actions ``[n, ...]``."""


class Pool:
    """Opponents of which each race draws one when it begins, with probabilities in proportion to their weights.

    >>> Pool([("racer", 1), (policy, 3)])
    """

    def __init__(self, members: Sequence[tuple[str | Policy, float]]):
        try:
            self.members = [(member, weight) for member, weight in members]
        except (TypeError, ValueError):
            raise ValueError(f"pool: found {members!r}, expected pairs of an opponent and a weight") from None
        if not self.members:
            raise ValueError("pool: found no opponent, expected at least one")
        for member, weight in self.members:
            if not callable(member) and not (isinstance(member, str) and member == "racer"):
                raise ValueError(f"opponent: found {member!r:.80}, expected 'racer', a policy or a Pool")
            if not isinstance(weight, Real) or isinstance(weight, bool) or not 0 < weight <= 1e300:
                raise ValueError(f"pool: found the weight {weight!r:.80}, expected a number above 0, up to 1e300")
        self.members = [(member, float(weight)) for member, weight in self.members]


def pool_of(opponent: Any) -> Pool:
    """The pool that an argument ``opponent`` stands for."""
    return opponent if isinstance(opponent, Pool) else Pool([(opponent, 1)])
