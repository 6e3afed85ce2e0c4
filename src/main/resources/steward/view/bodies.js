// The look of bodies: plain discs, and charts of energy, momentum and impacts.

import { addLook } from './looks.js';

addLook('bodies', {
  charts(match, series) {
    const sums = () => series.ofTurns('sums', 3, turn => (turn.isKept === false ? [] : sumsOf(match, turn)));
    return [
      { title: 'Kinetic energy', unit: 'mass × (u a turn)²', names: ['energy'], lists: () => sums().slice(0, 1) },
      { title: 'Momentum', unit: 'mass × u a turn', names: ['x', 'y'], lists: () => sums().slice(1) },
      { title: 'Impacts', unit: 'in a turn', names: ['impacts'],
        isWithin: true, lists: () => series.ofTurns('impacts', 1, turn => [turn.impactsInAll ?? 0]) },
    ];
  },
});

function sumsOf(match, turn) {
  let [energy, x, y] = [0, 0, 0];
  for (const body of turn.bodies.values()) {
    const mass = match.descriptions.get(body.id)?.mass;
    if (mass === undefined) continue;                                   // infinite
    energy += mass * (body.vx * body.vx + body.vy * body.vy) / 2;
    x += mass * body.vx;
    y += mass * body.vy;
  }
  return [energy, x, y];
}
