"""Answers each number by what two threads compute; a timer's signal arrives all the time."""
import signal
import sys
import threading

ticks = [0]


def tick(number, frame):
    ticks[0] += 1


def work(seed, into, place):
    value = seed
    for _ in range(3000):
        value = (value * 1103515245 + 12345) % (1 << 31)
    into[place] = value


signal.signal(signal.SIGALRM, tick)
signal.setitimer(signal.ITIMER_REAL, 0.003, 0.003)
for line in sys.stdin:
    found = [0, 0]
    threads = [threading.Thread(target=work, args=(int(line) + k, found, k)) for k in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    print(found[0] + found[1], flush=True)
