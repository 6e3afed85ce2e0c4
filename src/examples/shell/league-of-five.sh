#!/bin/sh
# A league of five versions of one bot, which differ by their thrust: which is best, and how sure is that?
set -e
cat > bot.py << 'END'
import json, sys
setup = json.loads(sys.stdin.readline())
for frame in map(json.loads, sys.stdin):
    if frame["type"] == "end": break
    mine = [pod for pod in frame["pods"] if pod["player"] == setup["player"]]
    goals = [setup["checkpoints"][pod["nextCheckpoint"]] for pod in mine]
    print(json.dumps({"pods": [{"x": goal["x"] - 3 * pod["vx"], "y": goal["y"] - 3 * pod["vy"],
        "thrust": int(sys.argv[1])} for pod, goal in zip(mine, goals)]}), flush=True)
END
steward league init night --scene mad-pod-racing
for thrust in 100 120 140 160 200; do steward league add night "thrust$thrust=python3 bot.py $thrust"; done
steward league run night --games 20 --threads auto --quiet
steward league table night
