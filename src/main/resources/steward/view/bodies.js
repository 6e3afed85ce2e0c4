// The look of bodies: balls in their own colours or in that of their speed; energy, momenta, pressure and impacts.

import { FONT, write } from './draw.js';
import { putBall, putDisc } from './hulls.js';
import { addLook, LABEL_PIXELS, PLAIN_LOOK } from './looks.js';
import { grouped } from './text.js';

// Colours of speeds, from rest to the fastest of the match. Beside teams, whose colours are their own, they are not used.
const ON_DARK = ['#5675b8', '#3d9fc4', '#46c08f', '#b5d84f', '#ffd54a', '#fff6d8'];
const ON_LIGHT = ['#6b82b5', '#2b84ad', '#1f8a5c', '#8a8a00', '#c76a00', '#b0123a'];
const SHADES = 4;               // between two of them
const FEW = 24;                 // bodies up to which each has its id, unless it has a label
const LEGEND = { x: 14, y: 18, width: 80, height: 6 };

addLook('bodies', {
  drawBody(scene, body) {
    if (body.owner !== null) putDisc(scene, body, scene.match.isIn(body.owner, scene.moment.turn));
    else putBall(scene, body, body.colour ?? colourOfSpeed(scene, Math.hypot(body.vx, body.vy)));
    const radius = body.radius * scene.view.scale;
    const words = body.label || (scene.bodies.length <= FEW ? String(body.id) : '');
    if (words && radius >= LABEL_PIXELS) {
      write(scene, words, scene.view.x(body.x), scene.view.y(body.y), Math.max(9, Math.min(15, radius * 0.7)),
        scene.paint.ink, '800');
    }
  },

  drawAbove(scene) {
    PLAIN_LOOK.drawAbove(scene);
    const isColoured = !scene.match.players.length && scene.bodies.some(body => !body.colour);
    if (scene.show.names && isColoured) drawLegend(scene);
  },

  strip(match, series) {
    const [energy, , x, y] = sumsOfTurns(match, series);
    return [{ name: 'kinetic energy', list: energy },
      { name: 'momentum', list: x.map((value, turn) => (value === null ? null : Math.hypot(value, y[turn]))) }];
  },

  charts(match, series) {
    const sums = () => sumsOfTurns(match, series);
    const act = forcesOf(match).some(part => part !== 0);
    const limited = match.turns.filter(turn => turn.impactLimit).length;
    return [
      { title: 'Kinetic energy', unit: 'm·(u/turn)²', names: act ? ['energy', 'potential'] : ['energy'],
        lists: () => sums().slice(0, act ? 2 : 1) },
      { title: 'Momentum', unit: 'm·u/turn', names: ['x', 'y'], lists: () => sums().slice(2, 4) },
      { title: 'Angular momentum', unit: 'm·u²/turn', names: ['angular'], lists: () => sums().slice(4, 5) },
      { title: 'Temperature', unit: 'm·(u/turn)²', names: ['temperature'], lists: () => sums().slice(5, 6) },
      ...pressures(match, act, sums),
      { title: limited ? `Impacts (${limited} turns at the bound)` : 'Impacts', unit: 'in a turn', names: ['impacts'],
        isWithin: true, lists: () => series.ofTurns('impacts', 1, turn => [turn.impactsInAll ?? 0]) },
    ];
  },
});

function sumsOfTurns(match, series) {
  const forces = forcesOf(match);
  const room = roomOf(match);
  return series.ofTurns('sums', 8, turn => (turn.isKept === false ? [] : sumsOf(match, turn, forces, room)));
}

/** The chart of what presses on walls, and of what follows from the virial where no force acts. */
function pressures(match, act, sums) {
  const { length, area } = roomOf(match);
  const names = [...(length ? ['on walls'] : []), ...(area && !act ? ['virial'] : [])];
  return names.length ? [{ title: 'Pressure', unit: 'm/turn²', names, isWithin: true,
    lists: () => [...(length ? [sums()[6]] : []), ...(area && !act ? [sums()[7]] : [])] }] : [];
}

/** Length of all that holds bodies, and area of the field between four walls or of the smallest arena; 0 if unknown. */
function roomOf(match) {
  const { field, walls = [], bodies = [] } = match.header.drawing;
  let [length, area] = [0, Infinity];
  const sides = new Set();
  for (const wall of walls) {
    if (wall.type === 'arena') {
      length += 2 * Math.PI * wall.radius;
      area = Math.min(area, Math.PI * wall.radius ** 2);
    } else if (wall.type === 'segment') {
      length += 2 * Math.hypot(wall.bx - wall.ax, wall.by - wall.ay);
    } else {
      const side = sideOf(wall, field);
      length += side ? (side < 3 ? field.height : field.width) : NaN;
      sides.add(side);
    }
  }
  if (area === Infinity) area = [1, 2, 3, 4].every(side => sides.has(side)) ? field.width * field.height : NaN;
  for (const { kind, radius } of bodies) {
    if (kind === 'bumper') {
      length += 2 * Math.PI * radius;
      area -= Math.PI * radius ** 2;
    }
  }
  return { length: length || 0, area: area || 0 };
}

/** The side of the field that a straight wall is: 1 left, 2 right, 3 top, 4 bottom, 0 none. */
function sideOf({ x, y, insideX, insideY }, field) {
  if (insideX) return insideX === 1 && x === field.x ? 1 : insideX === -1 && x === field.x + field.width ? 2 : 0;
  return insideY === 1 && y === field.y ? 3 : insideY === -1 && y === field.y + field.height ? 4 : 0;
}

/** Impulses on what does not move, and half of the sum of impulses times distances of centres, or radii at walls. */
function pushesOf(match, turn) {
  let [push, virial] = [0, 0];
  const massOf = id => match.descriptions.get(id)?.mass;
  for (const { a, b, ax, ay, bx, by, impulse } of turn.impacts) {
    const isHeld = b === undefined || massOf(a) === undefined || massOf(b) === undefined;
    if (isHeld) push += impulse;
    virial += impulse / 2 * (!isHeld ? Math.hypot(bx - ax, by - ay)
      : match.descriptions.get(massOf(a) === undefined ? b : a)?.radius);
  }
  return [push, virial];
}

/** Force and gravity of the scene: x and y of each. */
function forcesOf(match) {
  const play = match.header.scene.play ?? {};
  return [play.force?.x ?? 0, play.force?.y ?? 0, play.gravity?.x ?? 0, play.gravity?.y ?? 0];
}

/** The speed at the end of a turn is v + a/2: v is that of the middle of a parabola. */
function sumsOf(match, turn, forces, { length, area }) {
  const [forceX, forceY, gravityX, gravityY] = forces;
  let [energy, potential, x, y, angular, count] = [0, 0, 0, 0, 0, 0];
  for (const body of turn.bodies.values()) {
    const mass = match.descriptions.get(body.id)?.mass;
    if (mass === undefined) continue;                                   // infinite
    const [ax, ay] = [forceX / mass + gravityX, forceY / mass + gravityY];
    const start = match.start.bodies.get(body.id);
    energy += mass * ((body.vx + ax / 2) ** 2 + (body.vy + ay / 2) ** 2) / 2;
    potential -= mass * (ax * (body.x - start.x) + ay * (body.y - start.y));
    x += mass * body.vx;
    y += mass * body.vy;
    angular += mass * (body.x * body.vy - body.y * body.vx);
    count++;
  }
  const isWhole = turn.number > 0 && turn.impacts.length === turn.impactsInAll;
  const [push, virial] = isWhole ? pushesOf(match, turn) : [NaN, NaN];
  return [energy, potential, x, y, angular, ...[energy / count, push / length, (energy + virial) / area]
    .map(value => (Number.isFinite(value) ? value : null))];
}

/** The colour of a speed, as a share of the fastest of the match. */
function colourOfSpeed({ match, theme, paint }, speed) {
  if (match.players.length) return paint.muted;
  const colours = theme.isDark ? ON_DARK : ON_LIGHT;
  const at = Math.round(SHADES * (colours.length - 1) * Math.min(1, speed / (match.topSpeed || 1)));
  const [k, more] = [Math.floor(at / SHADES), at % SHADES];
  return more ? `color-mix(in srgb, ${colours[k]}, ${colours[k + 1]} ${100 * more / SHADES}%)` : colours[k];
}

/** The colours of speeds, in the corner, where the field leaves room. */
function drawLegend(scene) {
  const { ctx, view, paint, match, field } = scene;
  const { x, width, height } = LEGEND;
  const y = view.height - LEGEND.y;
  const words = `0 to ${grouped(match.topSpeed)} u a turn`;
  ctx.font = `11px ${FONT}`;
  const right = x + width + 8 + ctx.measureText(words).width;
  if (right > view.x(field.left) && y - height < view.y(field.bottom)) return;
  for (let k = 0; k < width; k++) {
    ctx.fillStyle = colourOfSpeed(scene, match.topSpeed * k / width);
    ctx.fillRect(x + k, y, 1.5, height);
  }
  ctx.textAlign = 'left';
  ctx.textBaseline = 'middle';
  ctx.fillStyle = paint.muted;
  ctx.fillText(words, x + width + 8, y + height / 2);
}
