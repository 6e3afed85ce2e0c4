"""A host in the manner of the SDK's runner: runner.py SEED PLAYER... -- REFEREE... prints the result of a game as JSON.
A PLAYER is its answers ANSWER[@MS] with commas between, the last one for ever; - is no answer."""
import json
import subprocess
import sys

words = sys.argv[2:]
split = words.index("--")
players = [script.split(",") for script in words[:split]]
referee = subprocess.Popen(words[split + 1:], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
asked = [0] * len(players)
keys = [str(player) for player in range(len(players))]
result = {"errors": {key: [] for key in keys}, "outputs": {key: [None] for key in keys}, "summaries": [], "views": [],
          "scores": {}, "uinput": [f"seed={sys.argv[1]}"], "metadata": "", "tooltips": [],
          "ids": {key: int(key) for key in keys},
          "agents": [{"index": int(key), "name": "P" + key, "agentId": int(key)} for key in keys]}


def say(name, *lines):
    print(f"[[{name}] {len(lines)}]", *lines, sep="\n", file=referee.stdin, flush=True)


say("INIT", len(players), "seed=" + sys.argv[1])
timed = False
while not result["scores"]:
    say("GET_GAME_INFO")
    heard = {}
    while not heard.keys() & {"NEXT_PLAYER_INFO", "SCORES"}:
        name, count = referee.stdout.readline().strip("[]\n").split("] ")
        heard[name] = [referee.stdout.readline().rstrip("\n") for _ in range(int(count))]
    timed |= "MONITORING" in heard
    result["views"].append("\n".join(heard["VIEW"]) + "\n" if "VIEW" in heard else None)
    result["summaries"].append("\n".join(heard.get("SUMMARY", [])))
    if "SCORES" in heard:
        result["metadata"] = "\n".join(heard.get("METADATA", []))
        result["scores"] = {line.split()[0]: int(line.split()[1]) for line in heard["SCORES"]}
        break
    player = int(heard["NEXT_PLAYER_INFO"][0])
    script = players[player]
    answer, _, ms = script[min(asked[player], len(script) - 1)].partition("@")
    asked[player] += 1
    for key in keys:
        result["outputs"][key].append(answer + "\n" if key == str(player) and answer != "-" else None)
    say("SET_PLAYER_TIMEOUT") if answer == "-" else say("SET_PLAYER_OUTPUT", *([ms or 0] if timed else []), answer)
print(json.dumps(result))
