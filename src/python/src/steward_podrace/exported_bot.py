"""A bot for the pod race, written by steward_podrace.export(): one network drives both pods, the text protocol."""

import math
import struct

INPUTS: list = []
LAYERS: list = []


def single(value):
    """The nearest number of single precision: observations and actions are of that type."""
    return struct.unpack("f", struct.pack("f", value))[0]


def ahead(pod, checkpoints):
    """The unit vector of a pod's heading; while it has none, the direction to its next checkpoint."""
    if pod[4] >= 0:
        return math.cos(pod[4] * 0.017453292519943295), math.sin(pod[4] * 0.017453292519943295)
    dx, dy = checkpoints[pod[5]][0] - pod[0], checkpoints[pod[5]][1] - pod[1]
    distance = math.sqrt(dx * dx + dy * dy)
    return (dx / distance, dy / distance) if distance else (1.0, 0.0)


def block(me, pods, passed, timers, boosts, checkpoints, to_finish):
    """The numbers that a pod sees, each forward and to the right of it."""
    c, s = ahead(pods[me], checkpoints)
    x, y, vx, vy, _, following = pods[me]
    out = []

    def add(px, py, scale):
        out.append((c * px + s * py) * scale)
        out.append((c * py - s * px) * scale)

    add(vx, vy, 1e-3)
    for each in (following, (following + 1) % len(checkpoints)):
        dx, dy = checkpoints[each][0] - x, checkpoints[each][1] - y
        distance = math.sqrt(dx * dx + dy * dy)
        add(dx / (distance or 1), dy / (distance or 1), 1)
        out.append(distance * 1e-4)
    out += [passed[me] * (1.0 / to_finish), timers[me] * 0.25, boosts[me]]
    for other in (1 - me, 2, 3):
        ox, oy, ovx, ovy, _, goal = pods[other]
        add(ox - x, oy - y, 1e-4)
        add(ovx - vx, ovy - vy, 1e-3)
        add(*ahead(pods[other], checkpoints), 1)
        add(checkpoints[goal][0] - ox, checkpoints[goal][1] - oy, 1e-4)
        out.append(passed[other] * (1.0 / to_finish))
    return out


def network(values):
    for weights, biases in LAYERS:
        values = [math.tanh(sum(w * v for w, v in zip(row, values)) + b) for row, b in zip(weights, biases)]
    return [single(value) for value in values] + [0.0]


def main():
    laps = int(input())
    checkpoints = [tuple(map(int, input().split())) for _ in range(int(input()))]
    n = len(checkpoints)
    passed, timers, boosts = [0] * 4, [0, 0], [1, 1]
    shown = [1] * 4
    while True:
        try:
            pods = [tuple(map(int, input().split())) for _ in range(4)]
        except EOFError:
            return
        for k, pod in enumerate(pods):
            passed[k] += (pod[5] - shown[k]) % n
            shown[k] = pod[5]
        for me in range(2):
            seen = block(me, pods, passed, timers, boosts, checkpoints, laps * n)
            turn, thrust, special = network([single(seen[k]) for k in INPUTS])[:3]
            a = turn * 18 * 0.017453292519943295
            c, s = ahead(pods[me], checkpoints)
            x = math.floor(pods[me][0] + 10000 * (c * math.cos(a) - s * math.sin(a)) + 0.5)
            y = math.floor(pods[me][1] + 10000 * (s * math.cos(a) + c * math.sin(a)) + 0.5)
            shield, boost = special > 0.5, special < -0.5
            timers[me] = 4 if shield else max(0, timers[me] - 1)
            boosts[me] = 0 if boost else boosts[me]
            print(
                x, y, "SHIELD" if shield else "BOOST" if boost else math.floor((thrust + 1) * 100 + 0.5), flush=me == 1
            )


main()
