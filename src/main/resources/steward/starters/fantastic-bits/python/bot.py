#!/usr/bin/env python3
"""A starter bot for Fantastic Bits: copy it and make it better. It needs nothing but Python 3.

The referee starts this program once per match and sends one JSON object a line:
one "setup" line, then one "turn" line per turn, and one "end" line.
Every "turn" line must be answered with exactly one line. Use stderr for your own notes:
    print("hello", file=sys.stderr)
"""
import json
import math
import sys

FULL_POWER = 150
FULL_THROW = 500


def distance(a, b):
    return math.hypot(a["x"] - b["x"], a["y"] - b["y"])


def go(goal):
    return {"x": goal["x"], "y": goal["y"], "power": FULL_POWER}


def commands(frame, setup):
    """Decide what our two wizards do, the one with the lower id first."""
    me = setup["player"]
    goal = {"x": setup["goal"]["x"], "y": (setup["goal"]["top"] + setup["goal"]["bottom"]) / 2}
    costs = {spell["spell"]: spell["cost"] for spell in setup["spells"]}
    magic = frame["magic"][me]
    entities = frame["entities"]
    mine = [entity for entity in entities if entity.get("player") == me]
    snaffles = [entity for entity in entities if entity["kind"] == "snaffle"]
    bludgers = [entity for entity in entities if entity["kind"] == "bludger"]

    answer = []
    for wizard in mine:
        free = [snaffle for snaffle in snaffles if snaffle["id"] not in (w["snaffle"] for w in mine)]
        bludger = min(bludgers, key=lambda b: distance(wizard, b))
        if wizard["snaffle"] >= 0:
            # It holds a snaffle, for this turn only: throw it, or it just drops it.
            answer.append({"x": goal["x"], "y": goal["y"], "throw": FULL_THROW})
        elif magic >= costs["obliviate"] + 30 and distance(wizard, bludger) < 2000:
            # With magic to spare: the bludger forgets both of our wizards for some turns. The other spells:
            #     petrificus (the target stops), accio (it comes), flipendo (it is pushed away from the wizard)
            answer.append({"spell": "obliviate", "target": bludger["id"]})
            magic -= costs["obliviate"]
        elif free:
            nearest = min(free, key=lambda s: distance(wizard, s))
            if len(snaffles) > 1:
                snaffles.remove(nearest)        # the other wizard goes for another one
            answer.append(go({"x": nearest["x"] + nearest["vx"], "y": nearest["y"] + nearest["vy"]}))
        else:
            answer.append(go(wizard))           # there is no command for waiting: it goes to where it is
    return answer


def main():
    setup = {}
    for line in sys.stdin:                  # ends when the referee closes our input
        frame = json.loads(line)
        if frame["type"] == "setup":
            setup = frame                   # our number, the goal, costs of spells, what ends the game
        elif frame["type"] == "turn":
            print(json.dumps({"wizards": commands(frame, setup)}), flush=True)   # without flush it would wait in vain
        elif frame["type"] == "end":
            break


if __name__ == "__main__":
    main()
