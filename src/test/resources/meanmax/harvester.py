import math
import sys

# A Mean Max bot as a contestant writes it: it reads the site's lines and stops its reaper in a wreck.


def value():
    return int(input())


while True:
    try:
        my_score = value()
    except EOFError:
        break
    enemy_scores = [value(), value()]
    my_rage = value()
    enemy_rages = [value(), value()]
    units = []
    for _ in range(value()):
        words = input().split()
        units.append(dict(id=int(words[0]), type=int(words[1]), player=int(words[2]), mass=float(words[3]),
                          radius=int(words[4]), x=int(words[5]), y=int(words[6]), vx=int(words[7]), vy=int(words[8]),
                          extra=int(words[9]), extra2=int(words[10])))
    reaper, destroyer, doof = [next(u for u in units if u["type"] == t and u["player"] == 0) for t in range(3)]
    wrecks = [u for u in units if u["type"] == 4]
    tankers = [u for u in units if u["type"] == 3]
    rivals = [u for u in units if u["type"] == 0 and u["player"] > 0]

    def far(a, b):
        return math.hypot(a["x"] - b["x"], a["y"] - b["y"])

    if wrecks:
        wreck = min(wrecks, key=lambda w: far(reaper, w) - 300 * w["extra"])
        dx = wreck["x"] - reaper["x"] - reaper["vx"]
        dy = wreck["y"] - reaper["y"] - reaper["vy"]
        power = min(300, int(math.hypot(dx, dy) * reaper["mass"]))
        print(reaper["x"] + dx, reaper["y"] + dy, power, "water")
    else:
        print(destroyer["x"], destroyer["y"], 300)
    if tankers:
        tanker = min(tankers, key=lambda t: far(destroyer, t))
        print(tanker["x"] + tanker["vx"], tanker["y"] + tanker["vy"], 300)
    else:
        print("WAIT")
    rival = min(rivals, key=lambda r: far(doof, r))
    if my_rage >= 30 and far(doof, rival) < 1800 and far(rival, reaper) > 2500:
        print("SKILL", rival["x"], rival["y"], "oil")
    else:
        print(rival["x"], rival["y"], 300)
    sys.stdout.flush()
