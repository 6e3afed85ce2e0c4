#!/bin/sh
# A moving picture of a scene of your own, as an SVG for a README or a page: a heap of discs falls into a corner.
set -e
cat > corner.json << 'END'
{ "name": "corner", "game": "bodies", "players": 0,
  "field": { "width": 400, "height": 300, "walls": "box" },
  "bodies": { "fill": { "count": 12, "radius": [10, 20], "restitution": 0.6, "speed": 10,
    "in": { "x": 20, "y": 20, "width": 200, "height": 150 } } },
  "play": { "maximumTurns": 80, "gravity": { "x": 1, "y": 2 } },
  "accuracy": { "advance": "event", "arithmetic": "double" } }
END
steward run corner.json --seed 7 --out corner.jsonl --overwrite
steward replay corner.jsonl --picture corner.svg --overwrite
