import math
import sys

# A Poker Chip Race bot as a contestant writes it: it flees from the nearest bigger chip and waits otherwise.

player_id = int(input())
while True:
    try:
        own = int(input())
    except EOFError:
        break
    chips = []
    for _ in range(int(input())):
        words = input().split()
        chips.append((int(words[0]), int(words[1])) + tuple(float(word) for word in words[2:]))
    for chip in chips[:own]:
        assert chip[1] == player_id

        def far(other):
            return math.hypot(other[3] - chip[3], other[4] - chip[4]) - other[2] - chip[2]

        bigger = [other for other in chips if other[2] > chip[2] and other[1] != player_id]
        danger = min(bigger, key=far, default=None)
        if danger and far(danger) < 40:
            print(2 * chip[3] - danger[3], 2 * chip[4] - danger[4], "help")
        else:
            print("wait")
    sys.stdout.flush()
