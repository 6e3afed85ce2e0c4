"""Speed and memory of the environments: ``python -m steward_podrace.bench``.

One step is one turn of one race, with the opponent ``racer`` and observations. Every row is the best of some rounds: by
the clock, and by the processor time of all threads, which other programs on the machine disturb less.
"""

import argparse
import ctypes
import math
import os
import shutil
import subprocess
import sys
import tempfile
import time
import tracemalloc
from collections.abc import Callable
from pathlib import Path

import numpy as np

from . import module_name
from .races import Races, official_map

RACES, STEPS, ROUNDS = 4096, 100, 7
SHIM = """#include "steward_podrace.hpp"
using namespace steward;
static Map* map; static State state;
extern "C" void start(const double* places, int n) {
    std::vector<std::pair<double, double>> all;
    for (int k = 0; k < n; k++) all.push_back({places[2 * k], places[2 * k + 1]});
    map = new Map(all); state = map->start();
}
extern "C" void turn(const double* commands) {
    Commands given;
    for (int pod = 0; pod < 4; pod++)
        given.target(pod, commands[3 * pod], commands[3 * pod + 1], static_cast<int>(commands[3 * pod + 2]));
    map->play(state, given);
}
"""


def best(run: Callable[[], int], rounds: int = ROUNDS) -> tuple[float, float]:
    """The greatest number of steps a second of some rounds, and of a second of processor time."""
    most = [0.0, 0.0]
    for _ in range(rounds):
        begin = time.perf_counter(), time.process_time()
        steps = run()
        spent = time.perf_counter() - begin[0], time.process_time() - begin[1]
        most = [max(each, steps / seconds) for each, seconds in zip(most, spent)]
    return most[0], most[1]


def environment(count: int, threads: int, copy: bool) -> Callable[[], int]:
    """Steps of some races with random actions."""
    races = Races(count, threads=threads, copy=copy, seed=1)
    races.reset()
    rng = np.random.default_rng(1)
    actions = [rng.uniform(-1, 1, (count, 6)).astype(np.float32) * np.float32([1, 1, 0.4] * 2) for _ in range(16)]

    def run() -> int:
        for k in range(STEPS):
            races.step(actions[k % 16])
        return STEPS * count

    return run


class PlainPods:
    """A textbook turn in Python: steering, thrust, drag; impacts by pairs in the order of time. Four pods."""

    def __init__(self, places: list[tuple[float, float]]):
        self.places = places
        self.pods = [[8000.0 + 1500 * k, 4500.0, 0.0, 0.0, 0.0, 1] for k in range(4)]

    def impact(self, a: list, b: list, left: float) -> float | None:
        dx, dy, vx, vy = b[0] - a[0], b[1] - a[1], b[2] - a[2], b[3] - a[3]
        square, along = vx * vx + vy * vy, dx * vx + dy * vy
        root = along * along - square * (dx * dx + dy * dy - 640000)
        if along >= 0 or square == 0 or root < 0:
            return None
        found = (-along - math.sqrt(root)) / square
        return found if 0 <= found <= left else None

    def turn(self) -> None:
        for pod in self.pods:
            x, y = self.places[pod[5]]
            wanted = math.atan2(y - pod[1], x - pod[0])
            turned = (wanted - pod[4] + math.pi) % (2 * math.pi) - math.pi
            pod[4] += max(-math.pi / 10, min(math.pi / 10, turned))
            pod[2] += 200 * math.cos(pod[4])
            pod[3] += 200 * math.sin(pod[4])
        left = 1.0
        while left > 0:
            found = [
                (time, i, j)
                for i in range(4)
                for j in range(i)
                if (time := self.impact(self.pods[i], self.pods[j], left)) is not None
            ]
            step, i, j = min(found, default=(left, 0, 0))
            for pod in self.pods:
                pod[0] += pod[2] * step
                pod[1] += pod[3] * step
            left -= step
            if not found:
                break
            a, b = self.pods[i], self.pods[j]
            nx, ny = (b[0] - a[0]) / 800, (b[1] - a[1]) / 800
            force = ((a[2] - b[2]) * nx + (a[3] - b[3]) * ny) / 2
            force += max(120, force)
            for pod, sign in ((a, -force), (b, force)):
                pod[2] += sign * nx
                pod[3] += sign * ny
        for pod in self.pods:
            pod[0], pod[1] = round(pod[0]), round(pod[1])
            pod[2], pod[3] = int(pod[2] * 0.85), int(pod[3] * 0.85)
            x, y = self.places[pod[5]]
            if math.hypot(x - pod[0], y - pod[1]) < 600:
                pod[5] = (pod[5] + 1) % len(self.places)


def plain_python() -> Callable[[], int]:
    """Turns in Python, one race, no observations."""
    pods = PlainPods([tuple(each) for each in official_map(1).tolist()])

    def run() -> int:
        for _ in range(2000):
            pods.turn()
        return 2000

    return run


def by_ctypes() -> Callable[[], int] | None:
    """Turns of the header by ctypes, one race, no observations; None without a compiler."""
    compiler = shutil.which("c++") or shutil.which("g++") or shutil.which("clang++")
    if compiler is None:
        return None
    folder = Path(tempfile.mkdtemp())
    try:
        (folder / "shim.cpp").write_text(SHIM)
        made = subprocess.run(
            [
                compiler,
                "-std=c++17",
                "-O2",
                "-fPIC",
                "-shared",
                f"-I{Path(__file__).parent / 'include'}",
                "-o",
                folder / "shim.so",
                folder / "shim.cpp",
            ],
            capture_output=True,
            check=False,
        )
        if made.returncode != 0:
            return None
        library = ctypes.CDLL(str(folder / "shim.so"))
    finally:
        shutil.rmtree(folder)
    places = official_map(1)
    library.start(places.ctypes.data_as(ctypes.c_void_p), len(places))
    rng = np.random.default_rng(1)
    commands = [
        np.column_stack([rng.uniform(0, 16000, 4), rng.uniform(0, 9000, 4), np.full(4, 200)]) for _ in range(16)
    ]
    pointers = [each.ctypes.data_as(ctypes.c_void_p) for each in commands]

    def run() -> int:
        for k in range(50_000):
            library.turn(pointers[k % 16])
        return 50_000

    return run


def resident() -> int:
    """Bytes that the process has in memory; 0 where that cannot be told."""
    try:
        return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")
    except (OSError, ValueError):
        return 0


def memory(count: int) -> tuple[int, int]:
    """Bytes that races add to the process, and the peak of allocations over 1,000 steps above their start."""
    from .envs import RaceVectorEnv

    actions = np.zeros((count, 6), np.float32)
    actions[:, [1, 4]] = 1
    before = resident()
    env = RaceVectorEnv(count, copy=False, seed=1)
    env.reset()
    for _ in range(200):  # so that a first end has come
        env.step(actions)
    added = resident() - before
    tracemalloc.start()
    env.step(actions)
    start = tracemalloc.get_traced_memory()[0]
    tracemalloc.reset_peak()
    for _ in range(1000):
        env.step(actions)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    return added, peak - start


def child(module: str, *words: str) -> subprocess.Popen:
    """This program in a process of its own, for one number."""
    return subprocess.Popen(
        [sys.executable, "-m", "steward_podrace.bench", *words],
        stdout=subprocess.PIPE,
        text=True,
        env={**os.environ, "STEWARD_PODRACE_MODULE": module},
    )


def numbers(process: subprocess.Popen) -> tuple[float, float]:
    """The numbers that it prints."""
    wall, cpu = map(float, process.communicate()[0].split())
    return wall, cpu


def table() -> None:
    """Prints all rows."""

    def row(name: str, steps: tuple[float, float] | None) -> None:
        said = "untried: no C++ compiler" if steps is None else f"{steps[0]:>12,.0f} {steps[1]:>12,.0f}"
        print(f"{name:58} {said}", flush=True)

    print(f"{'steps a second':58} {'clock':>12} {'processor':>12}")
    row("pure Python, one race, no observations", best(plain_python()))
    shim = by_ctypes()
    row("the header by ctypes, one race, no observations", None if shim is None else best(shim))
    for module in dict.fromkeys(["plain", module_name()]):
        for copy in ("copy", "place"):
            row(
                f"{RACES} races, 1 thread, {module}, {'copy=True' if copy == 'copy' else 'copy=False'}",
                numbers(child(module, "--only", copy, "--threads", "1")),
            )
    row(f"{2 * RACES} races, 2 threads", numbers(child("", "--only", "place", "--threads", "2")))
    pair = [child("", "--only", "place", "--threads", "1") for _ in range(2)]
    both = [numbers(each) for each in pair]
    row(f"2 processes of {RACES} races, together", (both[0][0] + both[1][0], (both[0][1] + both[1][1]) / 2))
    added, few = memory(RACES)[0], memory(16)[1]
    print(f"{RACES} races add {added / 1e6:.1f} MB to the process")
    print(
        f"1,000 steps with copy=False: the peak of allocations is {few} bytes above its start with 16 races, "
        f"{memory(RACES)[1]} with {RACES}"
    )


def main() -> None:
    """Prints the table, or the number of one row."""
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--only", choices=["copy", "place"])
    options.add_argument("--threads", type=int, default=1)
    chosen = options.parse_args()
    if chosen.only is None:
        table()
    else:
        print(*best(environment(RACES * chosen.threads, chosen.threads, chosen.only == "copy")))


if __name__ == "__main__":
    main()
