"""A game for psyleague with a referee that speaks the old mode of cg-brutaltester: play_game.py REFEREE BOT BOT."""
import json
import subprocess
import sys


def start(program):
    return subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)


referee, *bots = [start(program) for program in sys.argv[1:]]
referee.stdin.write(f"###Start {len(bots)}\n")
referee.stdin.flush()
line = referee.stdout.readline()
while not line.startswith("###End"):
    word, bot, *count = line.split()
    bot = bots[int(bot)]
    if word == "###Input":
        line = referee.stdout.readline()
        while not line.startswith("###"):
            bot.stdin.write(line)
            line = referee.stdout.readline()
        bot.stdin.flush()
    else:
        for _ in range(int(count[0])):
            referee.stdin.write(bot.stdout.readline())
        referee.stdin.flush()
        line = referee.stdout.readline()
ends = line.split()[1:]
for each in [referee, *bots]:
    each.kill()
    each.wait()
print(json.dumps({"ranks": [ends.index(str(bot)) for bot in range(len(bots))], "errors": [0] * len(bots),
                  "test_data": {}, "player_data": [{} for _ in bots]}))
