"""The environments: Gymnasium's and PettingZoo's checkers, equality with single ones, searches, both modules."""

import warnings

import gymnasium as gym
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from gymnasium.vector import AutoresetMode, SyncVectorEnv
from pettingzoo.test import parallel_api_test, parallel_seed_test

import steward_podrace
from steward_podrace import Pool, RaceEnv, RaceVectorEnv, Races
from steward_podrace import races as races_module
from steward_podrace._core import load

from test_engine import modules

MAP = [[(3000, 4500), (5500, 4600), (8000, 4700)]]
"""A short race, so that games end within a test."""


def forward(seen):
    """Straight on at full thrust, steering at the checkpoint: a policy that finishes."""
    out = np.zeros((len(seen), 6), np.float32)
    for k, at in ((0, 2), (3, 40)):
        out[:, k] = np.clip(np.arctan2(seen[:, at + 1], seen[:, at]) / np.radians(18), -1, 1)
        out[:, k + 1] = 1
    return out


def idle(seen):
    return np.zeros((len(seen), 6), np.float32)


def test_checkers_of_gymnasium_pass():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(RaceEnv(), skip_render_check=True)
        check_env(RaceEnv(actions="discrete", observations="full"), skip_render_check=True)


@pytest.mark.filterwarnings("ignore")
def test_checkers_of_pettingzoo_pass():
    parallel_api_test(steward_podrace.parallel_env(), 1000)
    parallel_seed_test(steward_podrace.parallel_env)


def test_it_is_made_by_name():
    many = gym.make_vec("steward_podrace:steward/PodRace-v0", num_envs=3, observations="full")
    assert isinstance(many.unwrapped, RaceVectorEnv) and many.observation_space.shape == (3, 90)
    assert gym.make("steward_podrace:steward/PodRace-v0").observation_space.shape == (78,)


def equal(found, expected):
    """Infos of two vector environments are equal, key by key."""
    assert found.keys() == expected.keys()
    for key, value in expected.items():
        if isinstance(value, dict):
            equal(found[key], value)
        elif value.dtype == object:
            assert [each is None for each in found[key]] == [each is None for each in value]
            for one, other in zip(found[key], value):
                np.testing.assert_array_equal(one, other)
        else:
            assert found[key].dtype == value.dtype
            np.testing.assert_array_equal(found[key], value)


@pytest.mark.parametrize("mode", list(AutoresetMode))
@pytest.mark.parametrize(
    "settings",
    [
        {},
        {"actions": "discrete", "reward": "lead", "rules": "contest"},
        {
            "opponent": Pool([("racer", 1), (idle, 2), (forward, 1)]),
            "observations": "full",
            "maps": MAP,
            "reward": "progress",
        },
        {"maps": MAP, "reward": lambda turn: turn.after["passed"].sum(1) - turn.before["passed"].sum(1)},
    ],
)
def test_many_are_the_same_as_single_ones(mode, settings):
    n, steps = 5, 260
    many = RaceVectorEnv(n, autoreset_mode=mode, seed=11, threads=2, **settings)
    single = SyncVectorEnv([lambda k=k: RaceEnv(seed=11 + k, **settings) for k in range(n)], autoreset_mode=mode)
    assert many.observation_space == single.observation_space and many.action_space == single.action_space
    assert many.metadata["autoreset_mode"] == single.metadata["autoreset_mode"]
    for seed in (None, 40, [1, None, 3, None, 5]):
        np.testing.assert_array_equal(many.reset(seed=seed)[0], single.reset(seed=seed)[0])
    rng, ends = np.random.default_rng(3), 0
    for step in range(steps):
        if settings.get("actions") == "discrete":
            actions = rng.integers(0, [7, 5, 7, 5], (n, 4))
        else:
            actions = (
                forward(many.races.observe())
                if step % 3 and settings.get("observations") != "full"
                else rng.uniform(-1, 1, (n, 6)).astype(np.float32)
            )
        found, expected = many.step(actions), single.step(actions)
        for one, other in zip(found[:4], expected[:4]):
            assert one.dtype == other.dtype
            np.testing.assert_array_equal(one, other, err_msg=f"step {step}")
        equal(found[4], expected[4])
        ends += found[2].sum()
        if mode == AutoresetMode.DISABLED and found[2].any():
            options = [{"reset_mask": found[2].copy()} for _ in range(2)]
            np.testing.assert_array_equal(many.reset(options=options[0])[0], single.reset(options=options[1])[0])
    assert ends > 0


@pytest.mark.parametrize("settings", [{}, {"observations": "full", "reward": "lead"}, {"actions": "discrete"}])
def test_both_modules_give_the_same_bits_on_any_number_of_threads(settings, monkeypatch):
    results = []
    for module in modules():
        for threads in (1, 3):
            monkeypatch.setattr(races_module, "core", load(module))
            many, rng, seen = RaceVectorEnv(64, seed=5, threads=threads, **settings), np.random.default_rng(1), []
            many.reset()
            for _ in range(300):
                actions = rng.integers(0, [7, 5, 7, 5], (64, 4)) if many.races.discrete else rng.uniform(-1, 1, (64, 6))
                seen += [array.tobytes() for array in many.step(actions)[:3]]
            results.append((seen, many.states().tobytes()))
    assert all(result == results[0] for result in results)


def test_a_copy_goes_on_as_its_original_and_a_state_can_be_restored():
    many = RaceVectorEnv(6, seed=1, observations="full", maps=MAP, opponent=Pool([("racer", 1), (forward, 1)]))
    many.reset()
    rng = np.random.default_rng(2)
    for _ in range(30):
        many.step(rng.uniform(-1, 1, (6, 6)))
    kept, other, plan = many.states(), many.clone(), rng.uniform(-1, 1, (200, 6, 6))
    first = [many.step(actions)[0] for actions in plan]
    np.testing.assert_array_equal(first, [other.step(actions)[0] for actions in plan])
    many.set_states(kept)
    np.testing.assert_array_equal(first, [many.step(actions)[0] for actions in plan])


def test_a_pool_is_drawn_by_its_weights():
    races = Races(20000, opponent=Pool([("racer", 1), (idle, 3)]), seed=1)
    races.reset()
    drawn = races.states()["opponent"].mean()  # standard deviation sqrt(0.75 0.25 / 20000) = 0.0031
    assert abs(drawn - 0.75) < 4 * 0.0031


def test_a_policy_plays_the_other_seat_as_its_own():
    both = Races(200, opponent=forward, seed=3, autoreset=False)
    seen, results = both.reset(), np.full(200, np.nan)
    for _ in range(500):
        over = both.states()["over"] == 1
        if over.all():
            break
        seen, _, ended, _ = both.step(forward(seen)) if not over.any() else (seen, None, over, None)
        results[ended] = both.results[ended]
        both.reset(ended) if ended.any() else None
        if not np.isnan(results).any():
            break
    assert abs(results.mean() - 0.5) < 0.2  # seats are alike: 200 games, 5 standard deviations


def test_seeds_draw_the_maps_of_a_match():
    # the zones in the header of a replay of `steward match --seed 7`
    np.testing.assert_array_equal(
        steward_podrace.official_map(7), [(13314, 5515), (9570, 1412), (3669, 4395), (8018, 7871)]
    )


def test_what_a_policy_is_shown_stays_as_it_was():
    shown = []
    many = RaceVectorEnv(3, seed=1, opponent=lambda seen: shown.append((seen, seen.copy())) or forward(seen))
    many.reset()
    for _ in range(3):
        many.step(np.ones((3, 6)))
    for seen, before in shown:
        np.testing.assert_array_equal(seen, before)


def test_a_masked_reset_takes_any_whole_number_as_a_seed():
    mask = np.array([True, False, True])
    one, other = (RaceVectorEnv(3, seed=1) for _ in range(2))
    one.reset(), other.reset()
    np.testing.assert_array_equal(
        one.reset(seed=np.int64(9), options={"reset_mask": mask})[0],
        other.reset(seed=[9, None, 11], options={"reset_mask": mask})[0],
    )
    np.testing.assert_array_equal(RaceEnv().reset(seed=np.int64(9))[0], RaceEnv().reset(seed=9)[0])


def test_without_copies_arrays_are_the_same_ones():
    many = RaceVectorEnv(3, copy=False, seed=1)
    first, _ = many.reset()
    second = many.step(np.zeros((3, 6)))[0]
    assert first is second
    copies = RaceVectorEnv(3, seed=1)
    kept, _ = copies.reset()
    before = kept.copy()
    copies.step(np.ones((3, 6)))
    np.testing.assert_array_equal(kept, before)
