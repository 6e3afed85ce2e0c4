"""Bad input: a ValueError that says what was found and expected, races as they were, and never a crash."""

import os
import threading

import numpy as np
import pytest

from steward_podrace import (
    Network,
    Pool,
    RaceEnv,
    RaceVectorEnv,
    Races,
    export,
    official_map,
    parallel_env,
    read_replay,
    show,
)

GOOD = np.zeros((2, 6))


def changed(at, value):
    actions = GOOD.copy()
    actions[at] = value
    return actions


@pytest.mark.parametrize(
    "settings, words",
    [
        ({"num_envs": 0}, "num_envs: found 0"),
        ({"num_envs": 2.5}, "num_envs"),
        ({"num_envs": True}, "num_envs"),
        ({"maps": "unknown"}, "maps: found 'unknown'"),
        ({"maps": []}, "maps"),
        ({"maps": [[(0, 0)]]}, "found 1 checkpoints"),
        ({"maps": [[(0, 0), (0, 0)]]}, "one place"),
        ({"maps": [[(0, 0), (np.nan, 1)]]}, "maps"),
        ({"maps": 3}, "maps: found 3"),
        ({"maps": [[("1", "2"), ("3", "4")]]}, "coordinate '1'"),
        ({"maps": [[(10**400, 1), (2, 3)]]}, "coordinate 1000"),
        ({"maps": [[(True, 1), (2, 3)]]}, "coordinate True"),
        ({"copy": "no"}, "copy: found 'no'"),
        ({"opponent": np.zeros(3)}, "opponent: found array"),
        ({"rules": "gold"}, "rules: found 'gold'"),
        ({"observations": "all"}, "observations"),
        ({"actions": None}, "actions"),
        ({"reward": "score"}, "reward"),
        ({"opponent": "veteran"}, "opponent: found 'veteran'"),
        ({"threads": 0}, "threads"),
        ({"opponent": Pool.__new__, "reward": 3}, "reward"),
        ({"seed": -1}, "seed: found -1"),
        ({"seed": "a"}, "seed"),
        ({"autoreset_mode": "never"}, "autoreset_mode"),
        ({"render_mode": "human"}, "render_mode"),
    ],
)
def test_settings(settings, words):
    with pytest.raises(ValueError, match=words) as refused:
        RaceVectorEnv(**{"num_envs": 2, **settings})
    assert "expected" in str(refused.value)


@pytest.mark.parametrize(
    "actions, words",
    [
        (np.zeros((3, 6)), r"shape \(3, 6\)"),
        (np.zeros(12), "shape"),
        (None, "object"),
        ("left", "actions"),
        ([[0] * 6, [0]], "several lengths"),
        (np.zeros((2, 6), complex), "complex"),
        (changed((1, 2), np.nan), "NaN in race 1"),
        (changed((0, 1), np.inf), "infinite number in race 0"),
        (changed((1, 1), 1e300), "infinite"),
    ],
)
def test_actions_are_refused_before_any_race_moves(actions, words):
    many = RaceVectorEnv(2, seed=1)
    many.reset()
    before = many.states()
    with pytest.raises(ValueError, match=words):
        many.step(actions)
    assert many.states().tobytes() == before.tobytes()


def test_choices_are_whole_numbers_of_their_range():
    many = RaceVectorEnv(2, seed=1, actions="discrete")
    many.reset()
    for actions in (np.zeros((2, 4)), np.full((2, 4), 7), -np.ones((2, 4), int)):
        with pytest.raises(ValueError, match="expected"):
            many.step(actions)


def test_what_is_over_or_closed_is_refused():
    single = RaceEnv(seed=1, maps=[[(0, 0), (1100, 0)]])
    single.reset()
    while not single.step([0, 1, 0, 0, 1, 0])[2]:
        pass
    with pytest.raises(ValueError, match="race 0 is over"):
        single.step(np.zeros(6))
    many = RaceVectorEnv(2, seed=1)
    many.reset()
    for env in (single, many):
        env.close()
        for call in (env.reset, env.states, env.clone, lambda env=env: env.step(GOOD if env is many else GOOD[0])):
            with pytest.raises(ValueError, match="closed"):
                call()


def test_an_opponents_mistakes_name_it():
    for answer, words in ((None, "opponent's actions"), (np.zeros((1, 6)), "shape"), (changed((1, 1), np.nan), "NaN")):
        many = RaceVectorEnv(2, seed=1, opponent=lambda seen, answer=answer: answer)
        many.reset()
        with pytest.raises(ValueError, match=words):
            many.step(GOOD)
    wrong = (
        [("racer", 0)],
        [("racer", np.nan)],
        [("racer", "3")],
        [("racer", 1e308)],
        [("racer", 10**400)],
        [("best", 1)],
    )
    for members in ([], [("racer",)], 5, [(np.zeros(3), 1)], *wrong):
        with pytest.raises(ValueError, match="expected"):
            Pool(members)


def test_states_are_checked_before_any_changes():
    races = Races(2, seed=1)
    races.reset()
    good = races.states()
    for field, value in (
        ("x", np.nan),
        ("vy", np.inf),
        ("heading", 1e9),
        ("shield_timer", 5),
        ("boost_left", 2),
        ("passed", -1),
        ("turns_left", 101),
        ("turn", 501),
        ("ending", 9),
        ("opponent", 1),
        ("checkpoints", 17),
        ("over", 2),
        ("checkpoint_x", np.inf),
    ):
        bad = good.copy()
        bad[field][1] = value
        with pytest.raises(ValueError, match=f"race 1.*{field}"):
            races.set_states(bad)
        assert races.states().tobytes() == good.tobytes()
    for bad in (good[:1], good["x"], None):
        with pytest.raises(ValueError, match="expected the type STATE"):
            races.set_states(bad)


def test_commands_faults_masks_and_seats():
    races = Races(2, seed=1)
    races.reset()
    for call in (
        lambda: races.play(np.zeros((2, 4, 2))),
        lambda: races.play(np.full((2, 4, 3), 0.5)),
        lambda: races.play(np.full((2, 4, 3), np.nan)),
        lambda: races.play(np.zeros((2, 4, 3)), [1, 0]),
        lambda: races.observe(2),
        lambda: races.reset([True]),
        lambda: races.seed([1]),
        lambda: official_map(-1),
        lambda: RaceVectorEnv(2).reset(options={"reset_mask": np.zeros(2, bool)}),
        lambda: RaceVectorEnv(2).reset(options=5),
        lambda: RaceVectorEnv(2).reset(seed=1.5, options={"reset_mask": np.ones(2, bool)}),
        lambda: RaceEnv().reset(seed=-1),
        lambda: RaceEnv().reset(seed="x"),
        lambda: RaceEnv().step([[1], [1, 2]]),
        lambda: parallel_env().reset(seed=[1]),
        lambda: races.play([[1], [1, 2]]),
        lambda: races.reset([[True], [True, False]]),
    ):
        with pytest.raises(ValueError, match="expected"):
            call()


def test_agents_networks_and_pages(tmp_path):
    both = parallel_env(seed=1)
    both.reset()
    for actions in ({"player_0": np.zeros(6)}, None, [np.zeros(6)] * 2, {1: 1, "a": 2}):
        with pytest.raises(ValueError, match="expected those of"):
            both.step(actions)
    layers = [(np.zeros((38, 2)), np.zeros(2))]
    for call in (
        lambda: Network([]),
        lambda: Network([(np.zeros((3, 2)), np.zeros(2))]),
        lambda: Network([(np.full((38, 2), np.nan), np.zeros(2))]),
        lambda: Network(5),
        lambda: Network([1]),
        lambda: Network([("a", "b")]),
        lambda: Network([(np.zeros((38, 2), complex), np.zeros(2))]),
        lambda: Network(layers, [50]),
        lambda: Network(layers, [2.7]),
        lambda: Network(layers, 5),
        lambda: Network(layers)(np.full((1, 78), "a")),
        lambda: Network(layers)(np.zeros((1, 5))),
        lambda: export(None, tmp_path / "bot.py"),
        lambda: export(Network([(np.zeros((44, 2)), np.zeros(2))], observations="full"), tmp_path / "bot.py"),
        lambda: export(
            Network([(np.random.rand(38, 200), np.zeros(200)), (np.zeros((200, 2)), np.zeros(2))]), tmp_path / "bot.py"
        ),
    ):
        with pytest.raises(ValueError, match="expected"):
            call()
    assert not (tmp_path / "bot.py").exists()
    (tmp_path / "page").write_bytes(b"\xff\xfe\x00")
    (tmp_path / "text").write_text("hello")
    for name in ("page", "text"):
        with pytest.raises(ValueError, match="expected a page"):
            show(tmp_path / name)


START = '{"type":"steward-replay","format":3,"start":{"state":{"bodies":[]},"hash":"0"}}\n'


@pytest.mark.parametrize(
    "text, words",
    [
        ("", "empty"),
        ("x\n", ":1: "),
        ("[]\n", "header"),
        (START.replace("3", "2"), "format 3"),
        (START, "result"),
        (START + '{"type":"tu', ":2: found a line that is cut off"),
        (START + '{"type":"other"}\n', "'other'"),
        (START + '{"type":"turn"}\n', "'turn'"),
        (START + '{"type":"turn","turn":1,"commands":5,"outcome":{}}\n', ":2: "),
        (START + "[" * 100_000 + "\n", ":2: "),
        (b"\xff\xfe\n", ":1: "),
    ],
)
def test_replays_say_the_line(text, words, tmp_path):
    path = tmp_path / "game.jsonl"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(ValueError, match=words):
        read_replay(path)


def test_a_pool_of_tiny_or_large_weights_draws_its_own_members():
    for weight in (5e-324, 1e300):  # the product of a sum and a fraction below 1 rounds up to the sum
        races = Races(2000, opponent=Pool([("racer", weight), (lambda seen: None, weight)]), seed=1)
        races.reset()
        assert set(races.states()["opponent"]) == {0, 1}


def test_two_threads_in_one_environment_are_refused_and_do_no_harm():
    many, refused = RaceVectorEnv(2000, seed=1, threads=2), []
    many.reset()

    def play():
        for _ in range(50):
            try:
                many.step(np.ones((2000, 6)))
            except ValueError as problem:
                refused.append(str(problem))

    callers = [threading.Thread(target=play) for _ in range(4)]
    for each in callers:
        each.start()
    for each in callers:
        each.join()
    assert refused and all("expected one thread at a time" in each for each in refused)
    assert np.isfinite(many.step(np.ones((2000, 6)))[0]).all()


def test_a_closed_environment_has_no_threads():
    before = len(os.listdir("/proc/self/task")) if os.path.exists("/proc/self/task") else pytest.skip("no /proc")
    many = RaceVectorEnv(8, threads=4)
    assert len(os.listdir("/proc/self/task")) == before + 3
    many.close()
    assert len(os.listdir("/proc/self/task")) == before


def test_broken_calls_end_in_a_ValueError_and_leave_sound_races():
    rng, calls = np.random.default_rng(4), int(os.environ.get("STEWARD_CALLS", 3000))
    shapes = [(4, 6), (4, 4), (4,), (6,), (3, 6), (4, 6, 1), (0, 6), ()]
    fills = [0, 1, -1, 0.3, np.nan, np.inf, -np.inf, 1e308, 5e-324, 2**40]
    refused = 0
    environments = [
        RaceVectorEnv(4, seed=1, threads=2),
        RaceVectorEnv(4, seed=2, actions="discrete", observations="full"),
        RaceVectorEnv(4, seed=3, opponent=lambda seen: rng.choice(fills) * np.ones((4, 6)), autoreset_mode="SameStep"),
    ]
    for env in environments:
        env.reset()
    for _ in range(calls):
        env = environments[rng.integers(3)]
        with np.errstate(all="ignore"):
            array = np.full(shapes[rng.choice(8, p=[0.6, 0.2] + [0.2 / 6] * 6)], rng.choice(fills)) * rng.integers(0, 3)
            array = array.astype(rng.choice(["f8", "f4", "i8", "u1", "?", "c16", "O"])) if rng.random() < 0.4 else array
        states = env.states()
        field = rng.choice(states.dtype.names)
        try:
            with np.errstate(all="ignore"):
                kind = rng.integers(8)
                if kind < 4:
                    env.step(array)
                elif kind == 4:
                    states[field][rng.integers(4)] = (
                        int(rng.integers(-3, 600)) if rng.random() < 0.5 else rng.choice(fills)
                    )
                    env.set_states(states)
                elif kind == 5:
                    env.races.play(rng.choice(fills) * np.ones((4, 4, 3)), rng.random((4, 2)) < 0.1)
                elif kind == 6:
                    env.reset(
                        seed=rng.choice([None, 5, -1, "x"]), options={"reset_mask": rng.random(rng.integers(3, 5)) < 1}
                    )
                else:
                    env.races.observe(int(rng.integers(-1, 3)))
        except (ValueError, OverflowError):
            refused += 1
        except RuntimeError as problem:  # of states that no race reaches
            assert "14000 impacts" in str(problem)
    assert calls > refused > calls / 10
    for env in environments:
        env.reset(seed=7)
        env.step(np.zeros((4, 4), int) if env.races.discrete else np.zeros((4, 6))) if env is not environments[
            2
        ] else None
        assert np.isfinite(env.races.observe()).all()
