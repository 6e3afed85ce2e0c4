"""Speed and memory of the environments: ``python -m steward_podrace.bench``.

One step is one turn of one race, with the opponent ``racer`` and observations. Rows take turns within each round, so
that other work on the machine meets them all; medians of the rounds are printed, by the clock and by the processor time
of all threads. The last columns are medians of each round's ratio, by processor time, to turns of the header alone,
compiled with the same instructions: the turns of such races, and of races whose pods all aim at their checkpoints.
"""

import argparse
import ctypes
import math
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
import tracemalloc
from collections.abc import Callable
from pathlib import Path

import numpy as np

from . import module_name
from . import races as races_module
from ._core import load
from .races import Races, official_map

RACES, STEPS, ROUNDS = 4096, 100, 15
HEADER_RACES, HEADER_PASSES = 64, 30
"""Races whose turns the header plays alone, and how often in a round."""
SHIM = """#include "steward_podrace.hpp"
using namespace steward;
static Map* map; static State state; static std::vector<Commands> all;
static Commands read(const double* from) {
    Commands given;
    for (int pod = 0; pod < 4; pod++)
        given.target(pod, from[3 * pod], from[3 * pod + 1], static_cast<int>(from[3 * pod + 2]));
    return given;
}
extern "C" void start(const double* places, int n, const double* commands, int count) {
    std::vector<std::pair<double, double>> found;
    for (int k = 0; k < n; k++) found.push_back({places[2 * k], places[2 * k + 1]});
    map = new Map(found); state = map->start();
    for (int k = 0; k < count; k++) all.push_back(read(commands + 12 * k));
}
extern "C" void turn(const double* commands) { map->play(state, read(commands)); }
extern "C" void race(int turns, int passes) {
    for (int pass = 0; pass < passes; pass++)
        for (std::size_t k = 0; k < all.size(); k++) {
            if (k % turns == 0) state = map->start();
            map->play(state, all[k]);
        }
}
"""

Rate = tuple[float, float]
"""Steps a second, and steps a second of processor time."""


def rate(run: Callable[[], int]) -> Rate:
    """The rate of one run, which returns its steps."""
    begin = time.perf_counter(), time.process_time()
    steps = run()
    return steps / (time.perf_counter() - begin[0]), steps / (time.process_time() - begin[1])


def random_actions(count: int) -> list[np.ndarray]:
    """Actions of 16 steps."""
    rng = np.random.default_rng(1)
    return [rng.uniform(-1, 1, (count, 6)).astype(np.float32) * np.float32([1, 1, 0.4] * 2) for _ in range(16)]


def environment(count: int, threads: int, copy: bool, module: str) -> Callable[[], int]:
    """Steps of some races with random actions."""
    races_module.core = load(module)
    races = Races(count, threads=threads, copy=copy, seed=1)
    races.reset()
    actions = random_actions(count)

    def run() -> int:
        for k in range(STEPS):
            races.step(actions[k % 16])
        return STEPS * count

    return run


def commands_of_races(aimed: bool) -> np.ndarray:
    """Commands of the first turns of races on one map, ``[races, turns, 4, (x, y, thrust)]``: of the environment's, or
    with pods that aim some 500 u beside the next checkpoint, against their drift, a third of them with less thrust."""
    races, actions = Races(HEADER_RACES, maps=[official_map(1)], seed=1), random_actions(HEADER_RACES)
    races.reset()
    rng, places = np.random.default_rng(1), official_map(1)
    made = np.empty((HEADER_RACES, STEPS, 4, 3))
    for k in range(STEPS):
        if aimed:
            state = races.states()
            goals = places[(state["passed"] + 1) % len(places)]
            drift = 3 * np.stack([state["vx"], state["vy"]], -1)
            made[:, k, :, :2] = goals - drift + rng.integers(-500, 500, (HEADER_RACES, 4, 2))
            power = rng.integers(0, 200, (HEADER_RACES, 4))
            made[:, k, :, 2] = np.where(rng.random(power.shape) < 1 / 3, power, 200)
            races.play(made[:, k])
        else:
            made[:, k, :2], made[:, k, 2:] = races.commands(actions[k % 16], 0), races.racer(1)
            races.step(actions[k % 16])
    return made


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


def compiled(*flags: str, aimed: bool = False) -> ctypes.CDLL | None:
    """The header as a library with a race begun; None without a compiler."""
    compiler = shutil.which("c++") or shutil.which("g++") or shutil.which("clang++")
    if compiler is None:
        return None
    folder = Path(tempfile.mkdtemp())
    try:
        (folder / "shim.cpp").write_text(SHIM)
        call = [compiler, "-std=c++17", *flags, "-fPIC", "-shared", f"-I{Path(__file__).parent / 'include'}"]
        call += ["-o", str(folder / "shim.so"), str(folder / "shim.cpp")]
        if subprocess.run(call, capture_output=True, check=False).returncode != 0:
            return None
        library = ctypes.CDLL(str(folder / "shim.so"))
    finally:
        shutil.rmtree(folder)
    places, commands = official_map(1), commands_of_races(aimed)
    library.start(
        places.ctypes.data_as(ctypes.c_void_p),
        len(places),
        commands.ctypes.data_as(ctypes.c_void_p),
        HEADER_RACES * STEPS,
    )
    return library


def header(module: str, aimed: bool) -> Callable[[], int] | None:
    """Turns of the header alone, compiled as a module is."""
    library = compiled("-O3", *(["-mavx2"] if module == "avx2" else []), aimed=aimed)
    if library is None:
        return None

    def run() -> int:
        library.race(STEPS, HEADER_PASSES)
        return HEADER_RACES * STEPS * HEADER_PASSES

    return run


def by_ctypes() -> Callable[[], int] | None:
    """Turns of the header by ctypes, one race, no observations; None without a compiler."""
    library = compiled("-O2")
    if library is None:
        return None
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
    try:
        from .envs import RaceVectorEnv as Environment
    except ImportError:  # no Gymnasium
        Environment = Races
    actions = np.zeros((count, 6), np.float32)
    actions[:, [1, 4]] = 1
    before = resident()
    env = Environment(count, copy=False, seed=1)
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


def child() -> subprocess.Popen:
    """A process that runs a round for each line it reads."""
    call = [sys.executable, "-m", "steward_podrace.bench", "--child"]
    return subprocess.Popen(call, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)


def together(children: list[subprocess.Popen]) -> Rate:
    """The rates of a round of all children at once: the sum by the clock, the mean by processor time."""
    for each in children:
        each.stdin.write("\n")
        each.stdin.flush()
    found = [tuple(map(float, each.stdout.readline().split())) for each in children]
    return sum(each[0] for each in found), statistics.mean(each[1] for each in found)


def table(rounds: int) -> None:
    """Prints all rows."""
    added, few, many = *memory(RACES)[:1], memory(16)[1], memory(RACES)[1]
    modules = list(dict.fromkeys(["plain", module_name()]))
    rows: dict[str, Callable[[], int] | None] = {"pure Python, one race, no observations": plain_python()}
    rows["the header by ctypes, one race, no observations"] = by_ctypes()
    base: dict[str, list[str]] = {}
    for module in modules:
        alone = [f"turns of the header alone, {module}, {which}" for which in ("of such races", "of aimed ones")]
        rows.update({name: header(module, aimed) for name, aimed in zip(alone, (False, True))})
        for copy in (True, False):
            name = f"{RACES} races, 1 thread, {module}, copy={copy}"
            rows[name], base[name] = environment(RACES, 1, copy, module), alone
    threads, processes = f"{2 * RACES} races, 2 threads", f"2 processes of {RACES} races, together"
    rows[threads] = environment(2 * RACES, 2, False, modules[-1])
    base[threads] = base[processes] = alone
    found: dict[str, list[Rate]] = {name: [] for name in [*rows, processes]}
    children = [child(), child()]
    together(children)
    for _ in range(rounds):
        for name, run in rows.items():
            if run is not None:
                found[name].append(rate(run))
        found[processes].append(together(children))
    for each in children:
        each.communicate()
    print(f"{'steps a second':58} {'clock':>12} {'processor':>12} {'of the header':>15}")
    for name, rates in found.items():
        if not rates:
            print(f"{name:58} untried: no C++ compiler")
            continue
        clock, processor = (statistics.median(each[k] for each in rates) for k in range(2))
        ratios = [
            statistics.median(a[1] / b[1] for a, b in zip(rates, found[each]))
            for each in base.get(name, ())
            if found[each]
        ]
        print(f"{name:58} {clock:12,.0f} {processor:12,.0f}", *(f"{each:7.3f}" for each in ratios))
    share = statistics.median(a[0] / b[0] for a, b in zip(found[threads], found[processes]))
    print(f"2 threads reach {share:.2f} of what 2 processes reach together, by the clock")
    print(f"{RACES} races add {added / 1e6:.1f} MB to the process")
    print(
        f"1,000 steps with copy=False: the peak of allocations is {few} bytes above its start with 16 races, "
        f"{many} with {RACES}"
    )


def main() -> None:
    """Prints the table, or runs rounds for another process."""
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--rounds", type=int, default=ROUNDS)
    options.add_argument("--child", action="store_true", help=argparse.SUPPRESS)
    chosen = options.parse_args()
    if chosen.rounds < 1:
        options.error(f"--rounds: found {chosen.rounds}, expected at least 1")
    if not chosen.child:
        table(chosen.rounds)
        return
    run = environment(RACES, 1, False, module_name())
    for _ in sys.stdin:
        print(*rate(run), flush=True)


if __name__ == "__main__":
    main()
