#!/usr/bin/env python3
"""A starter bot for the pod race: copy it and make it better. It needs nothing but Python 3.

The referee starts this program once per match and sends one JSON object a line:
one "setup" line, then one "turn" line per turn, and one "end" line.
Every "turn" line must be answered with exactly one line. Use stderr for your own notes:
    print("hello", file=sys.stderr)
"""
import json
import math
import sys

FULL_THRUST = 200
DRIFT_TURNS = 4       # how many turns of its own speed a pod takes into account when it aims


def command(pod, checkpoints, full_thrust):
    """Decide what one of our pods does: a place to steer at, and a thrust from 0 to full_thrust."""
    goal = checkpoints[pod["nextCheckpoint"]]

    # A pod keeps most of its speed from turn to turn. Aim beside the goal, against that drift.
    x = goal["x"] - DRIFT_TURNS * pod["vx"]
    y = goal["y"] - DRIFT_TURNS * pod["vy"]

    # The heading is in degrees, and None before the first command (then any direction is possible).
    # A pod can turn by only 18 degrees a turn, so give no thrust while it looks elsewhere.
    thrust = full_thrust
    if pod["heading"] is not None:
        wanted = math.degrees(math.atan2(y - pod["y"], x - pod["x"]))
        angle = (wanted - pod["heading"] + 180) % 360 - 180     # -180..180, 0 is straight ahead
        if abs(angle) > 80:
            thrust = 0

    # Instead of "thrust" a command can say "shield": True or "boost": True (the boost works once).
    return {"x": x, "y": y, "thrust": thrust}


def main():
    setup = {}
    for line in sys.stdin:                  # ends when the referee closes our input
        frame = json.loads(line)
        if frame["type"] == "setup":
            setup = frame                   # checkpoints, laps, radii, our player number, ...
        elif frame["type"] == "turn":
            full_thrust = setup.get("maximumThrust", FULL_THRUST)
            mine = [pod for pod in frame["pods"] if pod["player"] == setup["player"]]
            answer = {"pods": [command(pod, setup["checkpoints"], full_thrust) for pod in mine]}
            print(json.dumps(answer), flush=True)   # without flush the referee would wait in vain
        elif frame["type"] == "end":
            break


if __name__ == "__main__":
    main()
