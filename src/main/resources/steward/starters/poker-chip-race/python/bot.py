#!/usr/bin/env python3
"""A starter bot for the Poker Chip Race: copy it and make it better. It needs nothing but Python 3.

The referee starts this program once per match and sends one JSON object a line:
one "setup" line, then one "turn" line per turn, and one "end" line.
Every "turn" line must be answered with exactly one line. Use stderr for your own notes:
    print("hello", file=sys.stderr)
"""
import json
import math
import sys

ENOUGH = 12     # a chip that comes nearer by this many u per turn just drifts: every push costs it 1/15 of its area


def distance(a, b):
    return math.hypot(a["x"] - b["x"], a["y"] - b["y"])


def approach(chip, prey):
    """How much nearer the two come per turn."""
    x, y = prey["x"] - chip["x"], prey["y"] - chip["y"]
    return (x * (chip["vx"] - prey["vx"]) + y * (chip["vy"] - prey["vy"])) / math.hypot(x, y)


def command(chip, chips, me):
    """Decide what one of our chips does. A bigger chip eats a smaller one; the mass is the area."""
    prey = [other for other in chips if other["radius"] < chip["radius"] and other.get("player") != me]
    if not prey:
        return {"wait": True}
    nearest = min(prey, key=lambda other: distance(chip, other) - chip["radius"] - other["radius"])
    if approach(chip, nearest) >= ENOUGH:
        return {"wait": True}
    # Aim ahead of it. A chip with a radius of 5 or less cannot push itself: then this does nothing.
    turns = distance(chip, nearest) / 15
    return {"x": nearest["x"] + turns * (nearest["vx"] - chip["vx"]),
            "y": nearest["y"] + turns * (nearest["vy"] - chip["vy"])}


def main():
    me = 0
    for line in sys.stdin:                  # ends when the referee closes our input
        frame = json.loads(line)
        if frame["type"] == "setup":
            me = frame["player"]            # and the table, and what ends the game
        elif frame["type"] == "turn":
            chips = {chip["id"]: chip for chip in frame["chips"]}
            answer = [command(chips[own], frame["chips"], me) for own in frame["own"]]
            print(json.dumps({"chips": answer}), flush=True)    # without flush it would wait in vain
        elif frame["type"] == "end":
            break


if __name__ == "__main__":
    main()
