#!/usr/bin/env python3
"""A starter bot for Mean Max: copy it and make it better. It needs nothing but Python 3.

The referee starts this program once per match and sends one JSON object a line:
one "setup" line, then one "turn" line per turn, and one "end" line.
Every "turn" line must be answered with exactly one line. Use stderr for your own notes:
    print("hello", file=sys.stderr)
"""
import json
import math
import sys

FULL_POWER = 300


def distance(a, b):
    return math.hypot(a["x"] - b["x"], a["y"] - b["y"])


def nearest(to, things):
    return min(things, key=lambda thing: distance(to, thing), default=None)


def stop_at(looter, goal):
    """The thrust that brings a looter to a place and lets it stay there: its own speed is taken away."""
    x = goal["x"] - looter["x"] - looter["vx"]
    y = goal["y"] - looter["y"] - looter["vy"]
    power = min(FULL_POWER, math.hypot(x, y) * looter["mass"])     # power / mass is what its speed gains
    return {"x": looter["x"] + x, "y": looter["y"] + y, "power": power}


def go(goal):
    return {"x": goal["x"], "y": goal["y"], "power": FULL_POWER}


def commands(frame, me):
    """Decide what our reaper, destroyer and doof do, in this order."""
    units = frame["units"]
    mine = {unit["kind"]: unit for unit in units if unit.get("player") == me}
    reaper = mine["reaper"]
    destroyer, doof = mine.get("destroyer", reaper), mine.get("doof", reaper)    # lower leagues have none of these
    tankers = [unit for unit in units if unit["kind"] == "tanker"]
    rivals = [unit for unit in units if unit["kind"] == "reaper" and unit["player"] != me]

    # The reaper takes water from wrecks: it has to stop in one. Until there is one, stay near the destroyer.
    wreck = nearest(reaper, frame["wrecks"])
    reap = stop_at(reaper, wreck) if wreck else go(destroyer)

    # The destroyer sinks tankers by touching them.
    tanker = nearest(destroyer, tankers)
    destroy = go(tanker) if tanker else {"wait": True}

    # The doof gets in the way of others; its speed gives rage. With enough of it, a looter can cast its skill:
    #     {"x": ..., "y": ..., "skill": True}     within 2000 u: tar (reaper), grenade (destroyer), oil (doof)
    annoy = go(nearest(doof, rivals))
    return [reap, destroy, annoy]


def main():
    me = 0
    for line in sys.stdin:                  # ends when the referee closes our input
        frame = json.loads(line)
        if frame["type"] == "setup":
            me = frame["player"]            # and radii, costs of skills, what ends the game
        elif frame["type"] == "turn":
            print(json.dumps({"looters": commands(frame, me)}), flush=True)   # without flush it would wait in vain
        elif frame["type"] == "end":
            break


if __name__ == "__main__":
    main()
