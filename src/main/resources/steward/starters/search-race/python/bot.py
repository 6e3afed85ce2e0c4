#!/usr/bin/env python3
"""A starter bot for the search race: copy it and make it better. It needs nothing but Python 3.

The referee starts this program once per race and sends one JSON object a line:
one "setup" line, then one "turn" line per turn, and one "end" line.
Every "turn" line must be answered with exactly one line. Use stderr for your own notes:
    print("hello", file=sys.stderr)
"""
import json
import math
import sys

FULL_THRUST = 200
DRIFT_TURNS = 4       # how many turns of its own speed the car takes into account when it aims


def command(car, checkpoints, full_thrust):
    """Decide what the car does: a place to turn toward, and a thrust from 0 to full_thrust."""
    goal = checkpoints[car["nextCheckpoint"]]

    # The car keeps most of its speed from turn to turn. Aim beside the goal, against that drift.
    x = goal["x"] - DRIFT_TURNS * car["vx"]
    y = goal["y"] - DRIFT_TURNS * car["vy"]

    # The heading is in whole degrees. The car can turn by only 18 degrees a turn, so give no thrust
    # while it looks elsewhere.
    wanted = math.degrees(math.atan2(y - car["y"], x - car["x"]))
    angle = (wanted - car["heading"] + 180) % 360 - 180         # -180..180, 0 is straight ahead
    thrust = full_thrust if abs(angle) < 75 else 0

    # Instead of "x" and "y" a command can say "turn": by how many degrees, a whole number -18..18.
    return {"x": x, "y": y, "thrust": thrust}


def main():
    setup = {}
    for line in sys.stdin:                  # ends when the referee closes our input
        frame = json.loads(line)
        if frame["type"] == "setup":
            setup = frame                   # checkpoints, laps, radius, ...
        elif frame["type"] == "turn":
            full_thrust = setup.get("maximumThrust", FULL_THRUST)
            answer = command(frame["car"], setup["checkpoints"], full_thrust)
            print(json.dumps(answer), flush=True)   # without flush the referee would wait in vain
        elif frame["type"] == "end":
            break


if __name__ == "__main__":
    main()
