"""The package as people have it: from its source archive, beside libraries that change arithmetic, without leaks."""

import os
import shutil
import subprocess
import sys
import tarfile
import textwrap
from pathlib import Path

import pytest

from steward_podrace import bench
from steward_podrace._core import load

from test_engine import modules

HOME = Path(__file__).parents[1]


def python(code, **environment):
    return subprocess.run(
        [sys.executable, "-c", textwrap.dedent(code)],
        capture_output=True,
        text=True,
        check=True,
        env={**os.environ, **environment},
    ).stdout.strip()


def test_the_source_archive_builds_and_plays_elsewhere(tmp_path):
    call = [sys.executable, "-m", "build", "--sdist", "--no-isolation", "-o", tmp_path, HOME]
    subprocess.run(call, check=True, capture_output=True)
    with tarfile.open(next(tmp_path.glob("*.tar.gz"))) as archive:
        archive.extractall(tmp_path / "elsewhere", filter="data")
    source = next((tmp_path / "elsewhere").iterdir())
    assert (source / "LICENSE").read_bytes() == (HOME / "LICENSE").read_bytes()
    subprocess.run(
        [
            sys.executable,
            "-m",
            "pip",
            "install",
            "-q",
            "--no-build-isolation",
            "--no-deps",
            "--target",
            tmp_path / "site",
            source,
        ],
        check=True,
        capture_output=True,
    )
    said = python(
        """
        import numpy as np, steward_podrace
        races = steward_podrace.Races(8, seed=1)
        races.reset()
        for _ in range(200):
            races.step(np.ones((8, 6)))
        print(steward_podrace.__file__, races.states()["turn"].max() > 50)
        """,
        PYTHONPATH=str(tmp_path / "site"),
    )
    assert said.startswith(str(tmp_path / "site")) and said.endswith("True")


def test_a_module_is_chosen_at_import():
    name = "import steward_podrace; print(steward_podrace.module_name())"
    assert python(name, STEWARD_PODRACE_MODULE="plain") == "plain"
    assert python(name, STEWARD_PODRACE_MODULE="") == modules()[-1]


FLUSHING = """
#include <immintrin.h>
extern "C" unsigned flush() { _mm_setcsr(_mm_getcsr() | 0x8040 | 0x6000); return _mm_getcsr(); }
extern "C" unsigned state() { return _mm_getcsr(); }
"""


@pytest.mark.skipif(len(modules()) == 1, reason="the processor has no AVX2, so it may have no SSE control word")
@pytest.mark.skipif(shutil.which("g++") is None, reason="no g++")
def test_races_are_exact_after_a_library_that_flushes_and_rounds_otherwise(tmp_path):
    (tmp_path / "flush.cpp").write_text(FLUSHING)
    subprocess.run(["g++", "-shared", "-fPIC", "-o", tmp_path / "flush.so", tmp_path / "flush.cpp"], check=True)
    code = f"""
        import ctypes, hashlib, os, sys
        import numpy as np
        rng = np.random.default_rng(1)
        actions = rng.uniform(-1, 1, (120, 16, 6)).astype(np.float32)
        library = ctypes.CDLL({str(tmp_path / "flush.so")!r})
        before = library.flush() if os.environ["FLUSH"] == "1" else library.state()
        from steward_podrace.races import Races
        races = Races(16, seed=1, threads=2, observations="full")
        races.reset()
        seen = hashlib.sha256()
        for each in actions:
            seen.update(races.step(each)[0].tobytes())
        assert library.state() & 0xffc0 == before & 0xffc0, "the control word is not restored"
        print(seen.hexdigest(), races.hashes().tobytes().hex())
        """
    for module in modules():
        assert python(code, FLUSH="1", STEWARD_PODRACE_MODULE=module) == python(
            code, FLUSH="0", STEWARD_PODRACE_MODULE=module
        )


def test_a_thousand_steps_allocate_nothing_that_grows_with_the_races():
    for races in (16, 4096):  # the interpreter has caches of its own
        bench.memory(races)
    few, many = bench.memory(16)[1], bench.memory(4096)
    assert few <= 4096 and many[1] == few
    assert many[0] < 20e6


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork")
def test_a_forked_process_plays_on_without_threads():
    said = python(
        """
        import os, signal, numpy as np
        from steward_podrace.races import Races
        races, twin = (Races(64, threads=threads, seed=1) for threads in (3, 1))
        for each in (races, twin):
            each.reset()
            each.step(np.ones((64, 6)))
        if os.fork() == 0:
            signal.alarm(20)
            races.step(np.ones((64, 6)))
            twin.step(np.ones((64, 6)))
            equal = races.states().tobytes() == twin.states().tobytes()
            del races
            os._exit(0 if equal else 3)
        ended = os.wait()[1]
        races.step(np.ones((64, 6)))
        print(ended)
        """
    )
    assert said == "0"


@pytest.mark.skipif(sys.platform != "linux", reason="limits of Linux")
def test_threads_that_the_system_does_not_start_are_refused():
    said = python(
        """
        import resource
        from steward_podrace.races import Races
        resource.setrlimit(resource.RLIMIT_AS, (1 << 30, 1 << 30))
        try:
            Races(8, threads=256)
        except ValueError as problem:
            print(problem)
        """
    )
    assert said == "threads: found 256, expected no more than the system starts"


def test_an_old_gymnasium_leaves_the_races_and_says_what_the_environments_need():
    said = python(
        """
        import gymnasium.vector
        del gymnasium.vector.AutoresetMode
        import steward_podrace
        steward_podrace.Races(1).reset()
        try:
            from steward_podrace import RaceVectorEnv
        except ImportError as problem:
            print(problem)
        """
    )
    assert said.startswith("RaceVectorEnv: expected gymnasium 1.1 or newer")


def test_the_bench_prints_shares_of_the_header():
    said = subprocess.run(
        [sys.executable, "-m", "steward_podrace.bench", "--rounds", "1"], capture_output=True, text=True, check=True
    ).stdout
    rows = {line.split("  ")[0]: line.split() for line in said.splitlines()}
    for module in modules():
        steps = rows[f"4096 races, 1 thread, {module}, copy=False"]
        alone = rows[f"turns of the header alone, {module}, of such races"]
        if "untried:" not in alone:
            assert 0.05 < float(steps[-2]) < 1


def test_two_doubles_at_once_are_the_plain_form():
    assert load("plain").LANES in (1, 2)
