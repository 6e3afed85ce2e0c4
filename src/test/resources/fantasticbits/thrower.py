import math
import sys

# A Fantastic Bits bot as a contestant writes it: it reads the site's lines, splits the snaffles and throws at the goal.

my_team = int(input())
goal = (16000, 3750) if my_team == 0 else (0, 3750)

while True:
    try:
        my_score, my_magic = [int(i) for i in input().split()]
    except EOFError:
        break
    other_score, other_magic = [int(i) for i in input().split()]
    wizards, snaffles, bludgers = [], [], []
    for _ in range(int(input())):
        words = input().split()
        entity = dict(id=int(words[0]), x=int(words[2]), y=int(words[3]), vx=int(words[4]), vy=int(words[5]),
                      state=int(words[6]))
        if words[1] == "WIZARD":
            wizards.append(entity)
        elif words[1] == "SNAFFLE":
            snaffles.append(entity)
        elif words[1] == "BLUDGER":
            bludgers.append(entity)
    taken = set()
    for wizard in wizards:
        def far(other):
            return math.hypot(other["x"] - wizard["x"], other["y"] - wizard["y"])

        free = [s for s in snaffles if s["id"] not in taken] or snaffles
        if wizard["state"] == 1:
            print("THROW", goal[0], goal[1], 500, "goal!")
        elif my_magic >= 5 and far(min(bludgers, key=far)) < 1500:
            print("OBLIVIATE", min(bludgers, key=far)["id"])
            my_magic -= 5
        elif free:
            snaffle = min(free, key=far)
            taken.add(snaffle["id"])
            print("MOVE", snaffle["x"] + snaffle["vx"], snaffle["y"] + snaffle["vy"], 150)
        else:
            print("MOVE", 8000, 3750, 100)
    sys.stdout.flush()
