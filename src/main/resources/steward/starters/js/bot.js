// A starter bot for the pod race: copy it and make it better. It needs nothing but Node.js.
//
// It speaks CodinGame's lines. At the start: laps, the number of checkpoints, and one line "x y" for each.
// Every turn: four lines "x y vx vy angle nextCheckpoint", your two pods first, then the other player's.
// Answer every turn with one line for each of your pods: "x y thrust", a place to steer at and 0 to 200;
// in place of the thrust you can say SHIELD or BOOST (the boost works once). Use stderr for notes:
//     console.error('hello')
'use strict';

const PODS = 4;
const OWN = 2;
const DRIFT_TURNS = 4;      // how many turns of its own speed a pod takes into account when it aims
const FULL_THRUST = 200;

const checkpoints = [];

function command(pod) {
  const [x, y, vx, vy, angle, next] = pod;
  // A pod keeps most of its speed from turn to turn. Aim beside the checkpoint, against that drift.
  const targetX = checkpoints[next][0] - DRIFT_TURNS * vx;
  const targetY = checkpoints[next][1] - DRIFT_TURNS * vy;
  // A pod can turn by only 18 degrees a turn, so give no thrust while it looks elsewhere (-1: looks nowhere yet).
  const wanted = Math.atan2(targetY - y, targetX - x) * 180 / Math.PI;
  const off = ((wanted - angle + 540) % 360 + 360) % 360 - 180;     // -180..180, 0 is straight ahead
  return `${targetX} ${targetY} ${angle >= 0 && Math.abs(off) > 80 ? 0 : FULL_THRUST}`;
}

let expected = 2;           // lines until there is something to do
let started = false;
let lines = [];
require('readline').createInterface({ input: process.stdin }).on('line', line => {
  lines.push(line.trim().split(/\s+/).map(Number));
  if (!started && lines.length === 2) {
    expected = 2 + lines[1][0];
  }
  if (lines.length < expected) {
    return;
  }
  if (started) {
    console.log(lines.slice(0, OWN).map(command).join('\n'));
  } else {
    checkpoints.push(...lines.slice(2));
    started = true;
    expected = PODS;
  }
  lines = [];
});
