"""Replays as tables: states, commands, impacts, events and all else that a replay of any game has, column by column."""

import json
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

ROWS = 4096
"""Rows of one sort that are kept as Python's objects before they become arrays."""
FORMAT = 3


@dataclass(frozen=True)
class Replay:
    """A replay. ``tables[name][column]`` is an array; each table has a row's ``turn``, 0 for the start.

    ``turns``: one row a turn, its hash, and what there is one of, or one for each player (``turnsLeft_0``);
    ``states``: one row a turn and body; ``commands``: by ``player`` and his ``index``; ``impacts``; ``events``;
    ``paths``: ``id``, ``time``, ``x``, ``y`` of each knot; other lists of a game, such as ``wrecks``, by their names.
    A field whose name is taken has an underscore behind it: ``turn_`` of Search Race's commands.
    Numbers are int64, or float64 with NaN where there is none; texts are objects, lines joined by line feeds.
    """

    header: dict[str, Any]
    result: dict[str, Any] | None
    """The last line; None of a replay that is cut off."""
    tables: dict[str, dict[str, np.ndarray]]

    def __getitem__(self, name: str) -> dict[str, np.ndarray]:
        if name not in self.tables:
            raise ValueError(f"table: found {name!r}, expected one of {', '.join(self.tables)}")
        return self.tables[name]

    def frame(self, name: str) -> Any:
        """A table as a DataFrame of pandas."""
        try:
            import pandas
        except ImportError:
            raise ValueError("frame: found no pandas, expected it to be installed") from None
        return pandas.DataFrame(self[name], copy=False)


class _Table:
    """Rows with any fields, kept in groups of the same fields and turned into arrays from time to time."""

    def __init__(self) -> None:
        self.count = 0
        self.groups: dict[tuple[str, ...], list[tuple]] = {}
        self.parts: dict[str, list[tuple[np.ndarray, np.ndarray]]] = {}
        self.texts: dict[str, str] = {}

    def add(self, turn: int, row: dict[str, Any], **more: int) -> None:
        names = ("turn", *more, *(f"{name}_" if name == "turn" or name in more else name for name in row))
        group = self.groups.get(names)
        if group is None:
            group = self.groups[names] = []
        group.append((self.count, turn, *more.values(), *row.values()))
        self.count += 1
        if len(group) == ROWS:
            self._flush(names, group)

    def _flush(self, names: tuple[str, ...], group: list[tuple]) -> None:
        if group:
            rows, *columns = zip(*group)
            where = np.array(rows)
            for name, values in zip(names, columns):
                self.parts.setdefault(name, []).append((where, self._column(values)))
            group.clear()

    def _column(self, values: tuple) -> np.ndarray:
        types = set(map(type, values))
        if types == {bool}:
            return np.array(values, np.bool_)
        if types == {int}:
            try:
                return np.array(values, np.int64)
            except OverflowError:
                pass
        if types <= {int, float, bool, type(None)}:
            try:
                return np.array(values, np.float64)
            except OverflowError:
                pass  # a number past all doubles becomes a text
        out = np.empty(len(values), object)
        out[:] = [None if value is None else self._text(value) for value in values]
        return out

    def _text(self, value: Any) -> str:
        if isinstance(value, list) and all(isinstance(each, str) for each in value):
            value = "\n".join(value)
        text = value if isinstance(value, str) else json.dumps(value, separators=(",", ":"))
        return self.texts.setdefault(text, text)

    def columns(self) -> dict[str, np.ndarray]:
        for names, group in self.groups.items():
            self._flush(names, group)
        made = {}
        for name in list(self.parts):
            parts = self.parts.pop(name)
            types = {values.dtype for _, values in parts}
            whole = sum(len(values) for _, values in parts) == self.count
            if np.dtype(object) in types:
                column = np.full(self.count, None, object)
            elif len(types) == 1 and whole:
                column = np.empty(self.count, types.pop())
            else:
                column = np.full(self.count, np.nan)
            for where, values in parts:
                column[where] = values
            made[name] = column
        return made


class _Tables:
    """The tables of one replay while it is read."""

    def __init__(self) -> None:
        self.tables: dict[str, _Table] = {
            name: _Table() for name in ("turns", "states", "commands", "impacts", "events")
        }

    def table(self, name: str) -> _Table:
        return self.tables.setdefault(name, _Table())

    def fields(self, turn: int, found: dict[str, Any], row: dict[str, Any]) -> None:
        """Puts single values into a row of the turn, and lists of objects into tables of their own."""
        for name, value in found.items():
            if name == "state":
                self.fields(turn, value, row)
            elif name == "paths":
                paths = self.table("paths")
                for path in value:
                    for time, x, y, *_ in path["knots"]:
                        paths.add(turn, {"id": path["id"], "time": time, "x": x, "y": y})
            elif isinstance(value, list) and value and isinstance(value[0], dict):
                table = self.table("states" if name == "bodies" else name)
                for index, each in enumerate(value):
                    if name in ("bodies", "impacts", "events"):
                        table.add(turn, each)
                    else:
                        table.add(turn, each, index=index)
            elif isinstance(value, list):
                row.update({f"{name}_{k}": each for k, each in enumerate(value)})
            elif not isinstance(value, dict):
                row[name] = value

    def turn(self, line: dict[str, Any]) -> None:
        turn, row = line["turn"], {}
        for player, commands in enumerate(line["commands"]):
            for index, command in enumerate(commands if isinstance(commands, list) else [commands]):
                if command is not None:
                    self.tables["commands"].add(turn, command, player=player, index=index)
        self.fields(turn, line["outcome"], row)
        for name in ("faults", "messages", "stderr"):
            row.update({f"{name}_{k}": each for k, each in enumerate(line.get(name, ()))})
        row.update({f"answerNanos_{k}": each for k, each in enumerate(line.get("times", {}).get("answerNanos", ()))})
        self.tables["turns"].add(turn, row)


def read_replay(path: str | Path, partial: bool = False) -> Replay:
    """Reads a replay of any game.

    :param partial: whether one that is cut off is read as far as it goes; otherwise it is refused
    """
    with open(path, "rb") as lines:
        return _read(str(path), lines, partial)


def _read(path: str, lines: Iterable[bytes], partial: bool) -> Replay:
    header: dict[str, Any] | None = None
    result, tables, number = None, _Tables(), 0
    for number, text in enumerate(lines, 1):
        try:
            if not text.endswith(b"\n"):
                if partial:
                    break
                raise ValueError("found a line that is cut off, expected its end; partial=True reads as far as it goes")
            line = json.loads(text)
            kind = line.get("type") if isinstance(line, dict) else None
            if header is None:
                if kind != "steward-replay" or line.get("format") != FORMAT:
                    raise ValueError(f"found {text[:60]!r}, expected the header of a replay of format {FORMAT}")
                header, row = line, {}
                tables.fields(0, line["start"], row)
                tables.tables["turns"].add(0, row)
            elif kind == "turn":
                tables.turn(line)
            elif kind == "result":
                result = line
            elif kind != "signature":
                raise ValueError(f"found the type {kind!r}, expected a turn, the result or a signature")
        except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as problem:
            said = f"found no {problem}, expected it" if isinstance(problem, KeyError) else problem
            raise ValueError(f"{path}:{number}: {said}") from None
    if header is None:
        raise ValueError(f"{path}: found {'an empty file' if number == 0 else 'no whole line'}, expected a replay")
    if result is None and not partial:
        raise ValueError(
            f"{path}:{number}: found the end of the file, expected turns up to a result; partial=True "
            "reads as far as it goes"
        )
    return Replay(header, result, {name: table.columns() for name, table in tables.tables.items()})
