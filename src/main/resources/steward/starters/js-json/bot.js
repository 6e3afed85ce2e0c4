// A starter bot for the pod race: copy it and make it better. It needs nothing but Node.js.
//
// The referee starts this program once per match and sends one JSON object a line: one "setup", then one "turn" per
// turn, and one "end". Answer every "turn" with exactly one line. Use stderr for notes: console.error('hello')
'use strict';

const DRIFT_TURNS = 4;      // how many turns of its own speed a pod takes into account when it aims

let setup = {};

function command(pod) {
  const goal = setup.checkpoints[pod.nextCheckpoint];
  // A pod keeps most of its speed from turn to turn. Aim beside the goal, against that drift.
  const x = goal.x - DRIFT_TURNS * pod.vx;
  const y = goal.y - DRIFT_TURNS * pod.vy;
  // The heading is in degrees, and null before the first command (then any direction is possible).
  // A pod can turn by only 18 degrees a turn, so give no thrust while it looks elsewhere.
  const wanted = Math.atan2(y - pod.y, x - pod.x) * 180 / Math.PI;
  const off = ((wanted - pod.heading + 540) % 360 + 360) % 360 - 180;   // -180..180, 0 is straight ahead
  // Instead of "thrust" a command can say shield: true or boost: true (the boost works once).
  return { x, y, thrust: pod.heading !== null && Math.abs(off) > 80 ? 0 : setup.maximumThrust };
}

require('readline').createInterface({ input: process.stdin }).on('line', line => {
  const frame = JSON.parse(line);
  if (frame.type === 'setup') {
    setup = frame;                        // checkpoints, laps, radii, our player number, ...
  } else if (frame.type === 'turn') {
    const mine = frame.pods.filter(pod => pod.player === setup.player);
    console.log(JSON.stringify({ pods: mine.map(command) }));
  } else if (frame.type === 'end') {
    process.exit(0);
  }
});
