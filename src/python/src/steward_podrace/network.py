"""A small network as a policy, and its export as a bot of one file."""

from collections.abc import Sequence
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np

from .races import array, choice, whole

BLOCK = {"site": 38, "full": 44}
"""Numbers of an observation that belong to one pod; two numbers of the race follow both pods' blocks."""
LONGEST = 100_000
"""Characters of a bot that the site takes."""


class Network:
    """A policy for continuous actions: one network that drives each of both pods by the numbers of its own block.

    :param layers: pairs of weights ``[inputs, outputs]`` and biases ``[outputs]``; tanh follows each. The last has two
        outputs, turn and thrust, or three, with shield and boost.
    :param inputs: which numbers of a pod's block the first layer takes, all by default
    :param observations: of which it is made, ``"site"`` or ``"full"``
    """

    def __init__(
        self, layers: Sequence[tuple[Any, Any]], inputs: Sequence[int] | None = None, observations: str = "site"
    ):
        choice("observations", observations, list(BLOCK))
        self.observations = observations
        block = BLOCK[observations]
        if inputs is not None and (not isinstance(inputs, (list, tuple, range, np.ndarray)) or not len(inputs)):
            raise ValueError(f"inputs: found {inputs!r:.80}, expected a list of numbers 0..{block - 1}")
        self.inputs = [whole("inputs", each, 0, block - 1) for each in (range(block) if inputs is None else inputs)]
        try:
            pairs = [(weights, biases) for weights, biases in layers]
        except (TypeError, ValueError):
            raise ValueError(f"layers: found {layers!r:.80}, expected pairs of weights and biases") from None
        self.layers = [
            (_numbers("weights", weights).astype(np.float64), _numbers("biases", biases).astype(np.float64))
            for weights, biases in pairs
        ]
        width = len(self.inputs)
        for weights, biases in self.layers:
            if (
                weights.ndim != 2
                or weights.shape[0] != width
                or biases.shape != weights.shape[1:]
                or not (np.isfinite(weights).all() and np.isfinite(biases).all())
            ):
                raise ValueError(
                    f"layers: found weights {weights.shape} and biases {biases.shape}, expected finite ones, "
                    f"{width} inputs and a bias for each output"
                )
            width = weights.shape[1]
        if width not in (2, 3) or not self.layers:
            raise ValueError(f"layers: found {width} outputs, expected 2 or 3")

    def __call__(self, observations: np.ndarray) -> np.ndarray:
        """Actions ``[n, 6]`` of observations ``[n, numbers]``."""
        block, seen = BLOCK[self.observations], _numbers("observations", observations)
        if seen.ndim != 2 or seen.shape[1] != 2 * block + 2:
            raise ValueError(f"observations: found the shape {seen.shape}, expected (n, {2 * block + 2})")
        values = seen[:, : 2 * block].reshape(-1, 2, block)[:, :, self.inputs].astype(np.float64)
        for weights, biases in self.layers:
            values = np.tanh(values @ weights + biases)
        actions = np.zeros((len(seen), 2, 3), np.float32)
        actions[:, :, : values.shape[2]] = values
        return actions.reshape(-1, 6)


def _numbers(name: str, value: Any) -> np.ndarray:
    found = array(name, value)
    if found.dtype.kind not in "biuf":
        raise ValueError(f"{name}: found {found.dtype}, expected numbers")
    return found


def export(policy: Network, path: str | Path) -> None:
    """Writes a network as a bot of one file, which needs the standard library alone and speaks the text protocol."""
    if not isinstance(policy, Network):
        raise ValueError(f"policy: found {type(policy).__name__}, expected a Network")
    if policy.observations != "site":
        raise ValueError("policy: found one of observations 'full', which no bot is told, expected 'site'")
    layers = [(weights.T.tolist(), biases.tolist()) for weights, biases in policy.layers]
    template = files(__package__).joinpath("exported_bot.py").read_text("utf-8")
    text = template.replace("INPUTS: list = []", f"INPUTS: list = {policy.inputs}").replace(
        "LAYERS: list = []", f"LAYERS: list = {layers}"
    )
    if len(text) > LONGEST:
        raise ValueError(
            f"policy: found a bot of {len(text)} characters, expected at most {LONGEST}: a smaller network"
        )
    Path(path).write_text(text, "utf-8")
