#!/usr/bin/env python3
"""A starter bot for the pod race: copy it and make it better. It needs nothing but Python 3.

It speaks CodinGame's lines. At the start: laps, the number of checkpoints, and one line "x y" for each.
Every turn: four lines "x y vx vy angle nextCheckpoint", your two pods first, then the other player's.
Answer every turn with one line for each of your pods: "x y thrust", a place to steer at and 0 to 200;
in place of the thrust you can say SHIELD or BOOST (the boost works once). Use stderr for notes:
    print("hello", file=sys.stderr)
"""
import math
import sys

OWN = 2
PODS = 4
DRIFT_TURNS = 4       # how many turns of its own speed a pod takes into account when it aims
FULL_THRUST = 200


def numbers():
    """Read one line of whole numbers; the program ends when the referee closes our input."""
    line = sys.stdin.readline()
    if not line:
        sys.exit(0)
    return [int(word) for word in line.split()]


def command(pod, checkpoints):
    """Decide what one of our pods does."""
    x, y, vx, vy, angle, next_checkpoint = pod
    goal_x, goal_y = checkpoints[next_checkpoint]

    # A pod keeps most of its speed from turn to turn. Aim beside the checkpoint, against that drift.
    target_x = goal_x - DRIFT_TURNS * vx
    target_y = goal_y - DRIFT_TURNS * vy

    # A pod can turn by only 18 degrees a turn, so give no thrust while it looks elsewhere (-1: looks nowhere yet).
    wanted = math.degrees(math.atan2(target_y - y, target_x - x))
    off = (wanted - angle + 180) % 360 - 180                # -180..180, 0 is straight ahead
    thrust = 0 if angle >= 0 and abs(off) > 80 else FULL_THRUST
    return f"{target_x} {target_y} {thrust}"


def main():
    numbers()                                               # laps
    checkpoints = [numbers() for _ in range(numbers()[0])]
    while True:
        pods = [numbers() for _ in range(PODS)]
        for pod in pods[:OWN]:
            print(command(pod, checkpoints))
        sys.stdout.flush()                                  # without flush the referee would wait in vain


if __name__ == "__main__":
    main()
