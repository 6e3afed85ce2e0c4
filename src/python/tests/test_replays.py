"""Replays as tables, and pages in notebooks."""

import json
import time
import tracemalloc

import numpy as np
import pytest

from steward_podrace import read_replay, show


def write(path, turns, cut=0):
    """A replay with all that the tables know: rows of differing fields, texts, paths, a guest's commands."""
    lines = [
        {
            "type": "steward-replay",
            "format": 3,
            "start": {
                "state": {
                    "bodies": [{"id": 0, "x": 1, "heading": None}, {"id": 1, "x": 2.5, "heading": 0.5}],
                    "turnsLeft": [100, 99],
                },
                "hash": "00",
            },
        }
    ]
    for turn in range(1, turns + 1):
        lines.append(
            {
                "type": "turn",
                "turn": turn,
                "commands": [[{"x": turn, "y": 0.5, "thrust": 200}, None], {"lines": ["a", "b"], "ms": 3}, None],
                "faults": [None, "late"],
                "outcome": {
                    "impacts": [{"time": 0.25, "a": 0, "b": 1}] if turn % 2 else [],
                    "paths": [{"id": 1, "knots": [[0.25, 7, 8]]}],
                    "events": [{"kind": "mark", "body": 1, "x": 5, "text": "hello"}],
                    "state": {
                        "bodies": [{"id": 0, "x": turn, "heading": 1, "live": True}],
                        "turnsLeft": [turn, 99],
                        "said": [{"block": "VIEW", "lines": ["x"]}],
                    },
                    "hash": "ff",
                },
            }
        )
    lines.append({"type": "result", "turns": turns})
    text = "".join(json.dumps(line) + "\n" for line in lines)
    path.write_text(text[: len(text) - cut])
    return path


def test_tables_have_each_field_as_a_column(tmp_path):
    replay = read_replay(write(tmp_path / "game.jsonl", 3))
    assert replay.result["turns"] == 3
    states, commands = replay["states"], replay["commands"]
    np.testing.assert_array_equal(states["turn"], [0, 0, 1, 2, 3])
    np.testing.assert_array_equal(states["x"], [1, 2.5, 1, 2, 3])
    np.testing.assert_array_equal(states["heading"], [np.nan, 0.5, 1, 1, 1])
    np.testing.assert_array_equal(states["live"], [np.nan, np.nan, 1, 1, 1])
    assert states["id"].dtype == np.int64 and states["x"].dtype == np.float64
    np.testing.assert_array_equal(commands["player"], [0, 1] * 3)
    assert commands["lines"].tolist() == [None, "a\nb"] * 3 and commands["thrust"][0] == 200
    np.testing.assert_array_equal(replay["impacts"]["turn"], [1, 3])
    assert replay["events"]["text"].tolist() == ["hello"] * 3 and replay["said"]["block"].tolist() == ["VIEW"] * 3
    np.testing.assert_array_equal(replay["paths"]["y"], [8, 8, 8])
    np.testing.assert_array_equal(replay["turns"]["turnsLeft_0"], [100, 1, 2, 3])
    assert replay["turns"]["faults_1"].tolist() == [None, "late", "late", "late"]
    with pytest.raises(ValueError, match="expected one of turns"):
        replay["pods"]


def test_a_field_may_have_the_name_of_a_column_or_numbers_past_all_doubles(tmp_path):
    path = write(tmp_path / "game.jsonl", 2)
    text = path.read_text().replace('"thrust": 200', '"turn": -18, "player": 5').replace('"y": 8', '"y": 1e400')
    path.write_text(text.replace('"x": 5,', f'"x": {10**400},'))
    replay = read_replay(path)  # "turn" is the rotation that a bot of Search Race commands
    np.testing.assert_array_equal(replay["commands"]["turn"], [1, 1, 2, 2])
    np.testing.assert_array_equal(replay["commands"]["turn_"], [-18, np.nan, -18, np.nan])
    assert replay["commands"]["player"].tolist() == [0, 1, 0, 1] and replay["events"]["x"][0] == str(10**400)


def test_a_game_without_impacts_has_a_table_of_none(tmp_path):
    path = write(tmp_path / "game.jsonl", 0)
    assert read_replay(path)["impacts"] == {}


def test_a_frame_of_pandas_has_the_same_columns(tmp_path):
    pandas = pytest.importorskip("pandas")
    replay = read_replay(write(tmp_path / "game.jsonl", 4))
    assert isinstance(replay.frame("states"), pandas.DataFrame)
    assert replay.frame("states").groupby("turn")["x"].count().tolist() == [2, 1, 1, 1, 1]


def test_a_cut_replay_is_read_as_far_as_it_goes_by_who_asks(tmp_path):
    path = write(tmp_path / "game.jsonl", 5, cut=100)
    with pytest.raises(ValueError, match=r"game.jsonl:6: found a line that is cut off"):
        read_replay(path)
    replay = read_replay(path, partial=True)
    assert replay.result is None and replay["turns"]["turn"].max() == 4


def test_memory_is_a_few_times_the_arrays(tmp_path):
    path = write(tmp_path / "game.jsonl", 30_000)
    tracemalloc.start()
    begin = time.process_time()
    replay = read_replay(path)
    seconds, peak = time.process_time() - begin, tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    arrays = sum(column.nbytes for table in replay.tables.values() for column in table.values())
    print(
        f"{path.stat().st_size / 1e6:.0f} MB, {seconds:.1f} s under tracemalloc, peak {peak / arrays:.1f} of the arrays"
    )
    assert peak < 4 * arrays


def test_pages_and_pictures_are_frames_of_a_notebook(tmp_path):
    (tmp_path / "page.html").write_text('<!DOCTYPE html><p id="x">"quoted" & all</p>')
    (tmp_path / "race.svg").write_text("<svg xmlns='http://www.w3.org/2000/svg'/>")
    assert "&lt;p id=&quot;x&quot;&gt;" in show(tmp_path / "page.html")._repr_html_()
    assert "srcdoc=" in show(tmp_path / "race.svg", height=300).data
