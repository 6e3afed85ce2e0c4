"""Two players take 1 to 3 stones in turn from a heap; who takes the last one wins."""
import random
import sys


def say(name, *lines):
    print(f"[[{name}] {len(lines)}]", *lines, sep="\n")


def hear():
    head = sys.stdin.readline()
    if not head:
        sys.exit()                                # the host has gone
    name, count = head.strip("[]\n").split("] ")
    return name, [sys.stdin.readline().rstrip("\n") for _ in range(int(count))]


_, (players, seed, *properties) = hear()          # INIT: 2, seed=7
heap = random.Random(seed).randint(15, 25)
scores = {"0": 0, "1": 0}
turn = 0
while heap > 0 and min(scores.values()) >= 0:
    player = turn % 2
    hear()                                        # GET_GAME_INFO
    say("VIEW", f"KEY_FRAME {turn}", '{"heap": %d}' % heap)
    say("SUMMARY", f"{heap} stones are left")
    say("NEXT_PLAYER_INPUT", heap)
    say("NEXT_PLAYER_INFO", player, 1, 1000 if turn < 2 else 50)
    sys.stdout.flush()
    name, lines = hear()                          # SET_PLAYER_OUTPUT or SET_PLAYER_TIMEOUT
    take = int(lines[0]) if name == "SET_PLAYER_OUTPUT" and lines[0].isdigit() else 0
    if 1 <= take <= min(3, heap):
        heap -= take
        scores[str(player)] = int(heap == 0)
    else:
        scores[str(player)] = -1                  # no answer in time, or a bad one
    turn += 1
hear()
say("VIEW", f"KEY_FRAME {turn}", '{"heap": %d}' % heap)
say("SCORES", *(f"{player} {score}" for player, score in scores.items()))
sys.stdout.flush()
