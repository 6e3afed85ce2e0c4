// The look of the search race: a course like that of the pod race, and one car with its heading and exhaust.

import { drawDue, paintCourse, progressOf } from './course.js';
import { targetLine } from './draw.js';
import { putShip } from './hulls.js';
import { addLook, PLAIN_LOOK } from './looks.js';
import { headingOf, positiveDegrees } from './podrace.js';
import { plainNumber } from './text.js';
import { drawExhaust } from './trails.js';

const RUNNING_OUT = 30;
const CAR_SIZE = 1.9;           // the car is a point and has no true size

addLook('search-race', {
  leadName: 'checkpoints',
  drawGround: paintCourse,

  drawBelow(scene) {
    const { match, moment, show, selected } = scene;
    drawDue(scene, [...match.turn(moment.settled).bodies.values()].map(car => ({ ...car, owner: car.player })));
    for (const car of scene.bodies) {
      const order = match.turn(moment.turn)?.commands?.[car.owner];
      if (order?.x !== undefined && (show.targets || car.id === selected)) targetLine(scene, car, order.x, order.y);
      drawExhaust(scene, { ...car, radius: car.radius * CAR_SIZE }, headingOf(scene, car) ?? 0, (order?.thrust ?? 0) / 200);
    }
  },

  drawBody(scene, car) {
    putShip(scene, car, headingOf(scene, car) ?? 0, scene.match.isIn(car.owner, scene.moment.turn), CAR_SIZE);
  },

  drawAbove() {},

  progress: (match, number) => match.players.map(() =>
    progressOf(match.header.drawing.zones, match.turn(number).state.bodies[0])),

  /** The laps and checkpoints, and the time: of full turns while it goes on, the result at the end. */
  standing(match, number) {
    const { state } = match.turn(number);
    const zones = match.header.drawing.zones;
    const laps = match.header.scene.race.laps;
    const all = laps * zones.length;
    const car = state.bodies[0];
    const timer = state.timer + (car.passed >= all ? state.passTime : 0);
    return [{
      rank: 0,
      body: car.id,
      big: car.passed >= all ? `${timer.toFixed(2)} turns`
        : `Lap ${Math.min(laps, Math.floor(car.passed * laps / all) + 1)}/${laps}`,
      small: `${car.passed} of ${all} checkpoints`,
      pips: { groups: laps, each: zones.length, done: progressOf(zones, car) },
      warning: warningOfTurns(match.header.scene.race.maximumTurns - state.timer),
    }];
  },

  commandLines: command => [orderOfCar(command)],
  commandOf: (body, match, turn) => orderOfCar(match.turn(turn)?.commands?.[body.owner]),

  field(name, value) {
    if (name === 'heading') return `${positiveDegrees(value).toFixed(0)}°`;
    return PLAIN_LOOK.field(name, value);
  },
});

function orderOfCar(command) {
  if (!command) return '';
  return (command.turn === undefined ? `(${plainNumber(command.x)}, ${plainNumber(command.y)})`
    : `turn ${command.turn}°`) + ` thrust ${command.thrust}`;
}

function warningOfTurns(left) {
  return left > 0 && left < RUNNING_OUT ? `${left} turns left` : '';
}
