import sys, threading, time

KIND = sys.argv[1]


def burn(seconds, clock):
    end = clock() + seconds
    while clock() < end:
        sum(range(500))


def turn(first):
    if KIND == 'clock':
        burn(0.045, time.monotonic)
    elif KIND == 'work':
        burn(0.045, time.process_time)
    elif KIND == 'sleep':
        time.sleep(0.045)
    elif KIND == 'read':
        len(open('big.txt').read().split('7'))
    elif KIND == 'start' and first:
        time.sleep(0.3)
        burn(0.3, time.process_time)
    elif KIND == 'threads':
        all = [threading.Thread(target=burn, args=(0.01, time.thread_time)) for _ in range(4)]
        [each.start() for each in all]
        [each.join() for each in all]
    elif KIND == 'garbage':
        burn(0.03, lambda: [dict(a=[k]) for k in range(500)] and time.process_time())


first = True
for line in sys.stdin:
    if '"turn"' in line[:20]:
        turn(first)
        first = False
        print('{"pods":[{"x":1,"y":1,"thrust":0}]}', flush=True)
