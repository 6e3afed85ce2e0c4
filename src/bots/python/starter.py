#!/usr/bin/env python3
"""A starter bot for pod-race: copy it and make it better. It needs nothing but Python 3.

The referee sends one JSON object a line: a "setup", a "turn" for every turn, and an "end". Every "turn" is answered by
one line. Use stderr for your own notes: print("hello", file=sys.stderr)
"""
import json
import math
import sys
from typing import NamedTuple


class Checkpoint(NamedTuple):
    x: int
    y: int


class Pod(NamedTuple):
    player: int
    x: float
    y: float
    vx: float
    vy: float
    heading: float
    next: int


def main():
    frame = read_frame()                # before the first turn
    player = integer(frame, "player")
    laps = integer(frame, "laps")
    maximumThrust = integer(frame, "maximumThrust")
    checkpoints = [Checkpoint(integer(each, "x"), integer(each, "y"))
        for each in frame.get("checkpoints", [])]
    while True:
        frame = read_frame()            # every turn
        turnsLeft = integer(frame, "turnsLeft")
        pods = [Pod(integer(each, "player"), number(each, "x"), number(each, "y"), number(each, "vx"),
            number(each, "vy"), number(each, "heading"), integer(each, "nextCheckpoint"))
            for each in frame.get("pods", [])]

        # Change this: it decides what you answer.
        # A pod keeps most of its speed from turn to turn: aim beside the checkpoint, against 4 turns of that.
        # A pod can turn by only 18 degrees a turn, so give no thrust while it looks elsewhere.
        # Its heading is in degrees, and -1 before the first command: then any direction is possible.
        # In place of the thrust a command can have shield: true or boost: true (the boost works once).
        answers = []
        for pod in pods:
            if not (pod.player == player):
                continue
            targetX = checkpoints[pod.next].x - 4 * pod.vx
            targetY = checkpoints[pod.next].y - 4 * pod.vy
            if pod.heading >= 0 and degreesOff(pod.x, pod.y, pod.heading, targetX, targetY) > 80:
                answers.append({"x": targetX, "y": targetY, "thrust": 0})
            else:
                answers.append({"x": targetX, "y": targetY, "thrust": maximumThrust})
        # Without flush the referee would wait in vain.
        print(json.dumps({"pods": answers}), flush=True)


def degreesOff(x, y, heading, other_x, other_y):
    """How many degrees, 0..180, a heading is off the direction from a place to another."""
    wanted = math.degrees(math.atan2(other_y - y, other_x - x))
    return abs((wanted - heading + 180) % 360 - 180)


# Reading. There is nothing to change from here on.
def read_frame():
    """The next frame; the program ends with the last one."""
    line = sys.stdin.readline()
    frame = json.loads(line) if line else {"type": "end"}
    if frame["type"] == "end":
        sys.exit(0)
    return frame


def number(values, key):
    """A number of an object, -1 if there is none."""
    value = values.get(key)
    return -1 if value is None else value


def integer(values, key):
    return int(number(values, key))


def word(values, key):
    return str(values.get(key, ""))


if __name__ == "__main__":
    main()
