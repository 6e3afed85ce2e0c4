"""A contestant's bot in Python: plays both leagues, which it tells apart by the first line it reads."""
import math
import sys


def race_alone(line):
    while True:
        x, y, next_x, next_y, dist, angle = [int(i) for i in line.split()]
        opponent_x, opponent_y = [int(i) for i in input().split()]
        print("angle", angle, file=sys.stderr)
        thrust = 0 if abs(angle) > 90 else 60 if dist < 1200 else 100
        print(next_x, next_y, thrust, "%d° to go" % angle)
        line = input()


def race(laps):
    checkpoints = []
    for _ in range(int(input())):
        checkpoints.append([int(i) for i in input().split()])
    turn = 0
    while True:
        pods = [[int(i) for i in input().split()] for _ in range(4)]
        turn += 1
        for number, (x, y, vx, vy, angle, next_id) in enumerate(pods[:2]):
            target_x = checkpoints[next_id][0] - 3.2 * vx
            target_y = checkpoints[next_id][1] - 3.2 * vy
            wanted = math.degrees(math.atan2(target_y - y, target_x - x))
            off = 0 if angle < 0 else abs((wanted - angle + 180) % 360 - 180)
            if turn == 40:
                print(target_x, target_y, "SHIELD", "ouch")
            else:
                print(target_x, target_y, 0 if off > 80 else 200)


first = input()
try:
    if " " in first:
        race_alone(first)
    else:
        race(int(first))
except EOFError:
    pass
