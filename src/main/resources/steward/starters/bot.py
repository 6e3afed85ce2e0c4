#!/usr/bin/env python3
"""A starter bot for {{game}}: copy it and make it better. It needs nothing but Python 3.

{{#codingame}}
It speaks CodinGame's lines: words and numbers. The referee sends some before the first turn and some every turn, and
every turn it waits for an answer. Use stderr for your own notes: print("hello", file=sys.stderr)
{{/codingame}}
{{#json}}
The referee sends one JSON object a line: a "setup", a "turn" for every turn, and an "end". Every "turn" is answered by
one line. Use stderr for your own notes: print("hello", file=sys.stderr)
{{/json}}
"""
{{#json}}
import json
{{/json}}
{{#math}}
import math
{{/math}}
import sys
from typing import NamedTuple
{{#records}}


class {{type}}(NamedTuple):
{{#fields}}
    {{name}}: {{#int}}int{{/int}}{{#real}}float{{/real}}{{#word}}str{{/word}}
{{/fields}}
{{/records}}


def main():
{{#json}}
    frame = read_frame()                # before the first turn
{{/json}}
{{#codingame}}
    # Before the first turn.
{{/codingame}}
{{#readings}}
{{#every}}
    while True:
{{#json}}
        frame = read_frame()            # every turn
{{/json}}
{{#codingame}}
        # Every turn. All of it has to be read, whether you use it or not.
{{/codingame}}
{{/every}}
{{#inputs}}
{{#variables}}
    {{step}}{{name}} = {{kind}}({{#json}}frame, "{{key}}"{{/json}})
{{/variables}}
{{#record}}
{{#json}}
    {{step}}each = frame.get("{{key}}", {})
{{/json}}
    {{step}}{{name}} = {{type}}({{#fields}}{{#wrap}}
    {{step}}    {{/wrap}}{{kind}}({{#json}}each, "{{key}}"{{/json}}){{^last}}, {{/last}}{{/fields}})
{{/record}}
{{#list}}
    {{step}}{{name}} = [{{type}}({{#fields}}{{#wrap}}
    {{step}}    {{/wrap}}{{kind}}({{#json}}each, "{{key}}"{{/json}}){{^last}}, {{/last}}{{/fields}})
    {{step}}    for {{#json}}each in frame.get("{{key}}", []){{/json}}{{#codingame}}_ in range({{count}}){{/codingame}}]
{{/list}}
{{/inputs}}
{{/readings}}

        # Change this: it decides what you answer.
{{#notes}}
        # {{note}}
{{/notes}}
{{#json}}
        answers = []
{{/json}}
{{#commands}}
{{#list}}
        for {{#indexed}}index, {{/indexed}}{{name}} in {{#indexed}}enumerate({{list}}){{/indexed}}{{^indexed}}{{list}}{{/indexed}}:
{{/list}}
{{#where}}
            if not ({{where}}):
                continue
{{/where}}
{{#locals}}
        {{indent}}{{name}} = {{value}}
{{/locals}}
{{#nearest}}
        {{indent}}# The nearest {{name}}, or None.
        {{indent}}{{name}} = min([each for each in {{list}}{{#where}} if {{where}}{{/where}}], default=None,
        {{indent}}    key=lambda each: distance({{from}}.x, {{from}}.y, each.x, each.y))
{{/nearest}}
{{#choices}}
{{#if}}
        {{indent}}if {{when}}:
{{/if}}
{{#elseif}}
        {{indent}}elif {{when}}:
{{/elseif}}
{{#else}}
        {{indent}}else:
{{/else}}
        {{inner}}{{#codingame}}print({{#parts}}{{#wrap}}
        {{inner}}    {{/wrap}}{{value}}{{^last}}, {{/last}}{{/parts}}){{/codingame}}{{#json}}answers.append({{{#parts}}{{#wrap}}
        {{inner}}    {{/wrap}}"{{key}}": {{value}}{{^last}}, {{/last}}{{/parts}}}){{/json}}
{{/choices}}
{{/commands}}
{{#codingame}}
        sys.stdout.flush()              # without it the referee would wait in vain
{{/codingame}}
{{#json}}
        # Without flush the referee would wait in vain.
        print(json.dumps({{#answer}}{"{{answer}}": answers}{{/answer}}{{^answer}}answers[0]{{/answer}}), flush=True)
{{/json}}
{{#distance}}


def distance(x, y, other_x, other_y):
    return math.hypot(other_x - x, other_y - y)
{{/distance}}
{{#degrees}}


def degreesOff(x, y, heading, other_x, other_y):
    """How many degrees, 0..180, a heading is off the direction from a place to another."""
    wanted = math.degrees(math.atan2(other_y - y, other_x - x))
    return abs((wanted - heading + 180) % 360 - 180)
{{/degrees}}


# Reading. There is nothing to change from here on.
{{#codingame}}
words = (each for line in sys.stdin for each in line.split())


def word():
    """The next word; the program ends when the referee closes our input."""
    found = next(words, None)
    if found is None:
        sys.exit(0)
    return found


def integer():
    return int(word())


def number():
    return float(word())
{{/codingame}}
{{#json}}
def read_frame():
    """The next frame; the program ends with the last one."""
    line = sys.stdin.readline()
    frame = json.loads(line) if line else {"type": "end"}
    if frame["type"] == "end":
        sys.exit(0)
    return frame


def number(values, key):
    """A number of an object, -1 if there is none."""
    value = values.get(key)
    return -1 if value is None else value


def integer(values, key):
    return int(number(values, key))


def word(values, key):
    return str(values.get(key, ""))
{{/json}}


if __name__ == "__main__":
    main()
