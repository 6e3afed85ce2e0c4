"""A referee that speaks rightly or wrongly: standin.py MODE. Each player is asked in turn for a number, ten rounds."""
import os
import sys
import time

mode = sys.argv[1]


def say(name, *lines):
    print(f"[[{name}] {len(lines)}]", *lines, sep="\n")


def hear():
    head = sys.stdin.readline()
    if not head:
        sys.exit()
    name, count = head.strip("[]\n").split("] ")
    return name, [sys.stdin.readline().rstrip("\n") for _ in range(int(count))]


def ask(player, count, limit, *lines):
    hear()
    say("VIEW", f"KEY_FRAME {turn}", '{"ms": "%s"}' % "|".join(map(str, shown)) if mode == "shown" else "{}")
    if mode in ("monitored", "struck", "shown") and turn == 0 and player == 0:
        say("MONITORING")
    if mode == "view":
        say("METADATA", str(time.time_ns()))
    if lines:
        say("NEXT_PLAYER_INPUT", *lines)
    say("NEXT_PLAYER_INFO", player, count, limit)
    sys.stdout.flush()
    return hear()


def misbehave():
    if mode == "exit":
        print("the map is missing", file=sys.stderr)
        sys.exit(3)
    if mode == "fail":
        say("FAIL", "java.lang.NullPointerException", "at Referee.gameTurn")
    if mode == "silence":
        time.sleep(1000)
    if mode == "flood":
        while True:
            say("SUMMARY", "x" * 60000)
    if mode == "errors":
        sys.stderr.write("e" * 10000000)
        sys.exit(4)
    if mode == "unknown":
        say("GARBAGE", "1")
    if mode == "noise":
        print("debug: 7 bodies")
    if mode == "lines":
        print("[[VIEW] 9999999999]")
    if mode == "number":
        say("NEXT_PLAYER_INFO", 0, 1, 9999999999)
    if mode == "huge":
        print("[[VIEW] 999999999]")
        while True:
            print("x" * 60000)
    if mode == "nobody":
        say("NEXT_PLAYER_INFO", 7, 1, 100)
    if mode == "few":
        say("SCORES", "0 1")
    if mode == "endless":
        while True:
            say("NEXT_PLAYER_INFO", 0, 0, 100)
            sys.stdout.flush()
            hear()
            hear()
    if mode == "children":
        if os.fork() == 0:
            time.sleep(1000)
        sys.exit(5)
    sys.stdout.flush()


_, (players, seed, *properties) = hear()
players = int(players)
turn = 0
if mode == "scores":
    hear()
    say("SCORES", *(f"{player} 3" for player in range(players)))
    sys.exit()
scores = [0] * players
late = [0] * players
shown = [0] * players
for turn in range(10):
    for player in range(players):
        if scores[player] < 0 and mode in ("thrown", "struck", "shown"):
            continue
        if turn == 3 and player == 1 and mode not in ("good", "view", "chance", "thrown", "struck", "shown"):
            misbehave()
        if mode == "pairs":
            ask(player, 0, 1000, f"setup of {player}")
        name, lines = ask(player, 1, 150 if mode in ("struck", "shown") else 3000, seed, *properties, str(turn))
        if mode in ("monitored", "struck", "shown") and name == "SET_PLAYER_OUTPUT":
            assert len(lines) == 2, lines
            shown[player] = int(lines[0])
            late[player] += int(lines[0]) > 100
            lines = lines[1:]
        if mode in ("struck", "shown") and late[player] == 3:       # as the SDK from 4.7.2 on
            scores[player] = -1
            continue
        if mode == "thrown" and turn == 3 and lines == ["2"]:
            scores[player] = -1
            say("SUMMARY", "a turn", f"\u00a4RED\u00a4${player}: no such cell\u00a7RED\u00a7")
            continue
        if name == "SET_PLAYER_TIMEOUT":
            print(f"{player} is late in turn {turn}", file=sys.stderr)
            scores[player] -= 1
        else:
            scores[player] += int(lines[0])
        if mode == "chance":
            scores[player] += time.time_ns() % 1000
            say("SUMMARY", str(scores[player]))
hear()
say("METADATA", "end")
say("SCORES", *(f"{player} {score}" for player, score in enumerate(scores)))
sys.stdout.flush()
if mode == "stays":
    time.sleep(1000)
