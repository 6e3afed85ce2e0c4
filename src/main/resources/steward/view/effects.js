// Impacts and marks of the game, which stay in view for a moment. All follows from the time alone.

import { captionSize, circle, FONT, hash01, sprites, TAU, write } from './draw.js';
import { paintGlow } from './hulls.js';
import { MOST_WORDS } from './notes.js';
import { impulseWords, shorten, withNames } from './text.js';
import { within } from './times.js';

const FLASH_TURNS = 1.6;        // how long an impact stays in view
const FLASH_SECONDS = 0.15;     // and at least this long when turns fly by
const MARK_TURNS = 4;
const MOST_FLASHES = 60;        // at once; of more, the strongest are drawn
const NUMBERED_SPEED = 5;       // turns a second up to which impulses are written
const MOST_NUMBERS = 8;         // of the strongest
const NUMBER_SIZE = 12;         // pixels
const BESIDE = [1, 1.8, 2.6].flatMap(far => [[0, -1], [0, 1], [1, 0], [-1, 0], [0.7, -0.7], [-0.7, -0.7], [0.7, 0.7],
  [-0.7, 0.7]].map(([dx, dy]) => [far * dx, far * dy]));         // where a number may stand beside its flash

/** The place where two bodies, or a body and a wall, touched in a turn. */
export function contactOf(match, { impact, turn }) {
  if (impact.wall !== undefined) return { x: impact.bx ?? impact.ax, y: impact.by ?? impact.ay };
  const a = match.describeIn(impact.a, turn).radius;
  const b = match.describeIn(impact.b, turn).radius;
  const share = a + b > 0 ? a / (a + b) : 0.5;
  return { x: impact.ax + (impact.bx - impact.ax) * share, y: impact.ay + (impact.by - impact.ay) * share };
}

/** A flash in units of the field: the stronger the impulse, the larger, against the strongest of the match. */
export function flashRadius(match, { impact, turn }) {
  const radius = Math.min(match.describeIn(impact.a, turn).radius, match.usualRadius);
  return radius * (0.65 + 2.25 * Math.sqrt(strengthOf(match, impact)));
}

export function strengthOf(match, impact) {
  return match.largestImpulse > 0 ? Math.abs(impact.impulse ?? 0) / match.largestImpulse : 0;
}

/** Draws what is in view of impacts; returns the numbers beside them, with their places. */
export function drawImpacts(scene) {
  const { match, moment, turnsPerSecond } = scene;
  const life = Math.max(FLASH_TURNS, FLASH_SECONDS * turnsPerSecond);
  let impacts = within(match.impacts, moment.time - life, moment.time);
  if (impacts.length > MOST_FLASHES) {
    impacts = impacts.sort((one, other) => strengthOf(match, other.impact) - strengthOf(match, one.impact))
      .slice(0, MOST_FLASHES);
  }
  for (const met of impacts) drawFlash(scene, met, (moment.time - met.time) / life);
  return turnsPerSecond <= NUMBERED_SPEED ? drawNumbers(scene, impacts, life) : [];
}

/** Impulses that rise from the strongest impacts in view, beside all bodies: none covers one, or another number. */
function drawNumbers(scene, impacts, life) {
  const { ctx, view, paint, match, moment } = scene;
  const taken = scene.bodies.map(body => ({ x: view.x(body.x), y: view.y(body.y), reach: body.radius * view.scale + 2 }));
  const strongest = impacts.filter(met => met.size * view.scale > NUMBER_SIZE && met.impact.impulse !== undefined)
    .sort((one, other) => strengthOf(match, other.impact) - strengthOf(match, one.impact)).slice(0, MOST_NUMBERS);
  ctx.font = `700 ${NUMBER_SIZE}px ${FONT}`;
  const numbers = strongest.flatMap(met => {
    const age = (moment.time - met.time) / life;
    const words = impulseWords(met.impact);
    const box = { words, age, half: ctx.measureText(words).width / 2 + 2, high: NUMBER_SIZE / 2 + 1 };
    const [x, y, far] = [view.x(met.contact.x), view.y(met.contact.y), met.size * view.scale * 0.55 + 6 + 16 * age];
    for (const side of met.side ? [met.side, ...BESIDE] : BESIDE) {
      const at = { ...box, x: x + side[0] * far + Math.sign(side[0]) * box.half,
        y: y + side[1] * far + Math.sign(side[1]) * box.high };
      if (taken.every(other => isApart(at, other)) && isWithin(at, view)) {
        met.side = side;                                    // it stays there while there is room
        taken.push(at);
        return [at];
      }
    }
    return [];
  });
  for (const { words, x, y, age } of numbers) {
    ctx.globalAlpha = Math.min(1, 2 * (1 - age) ** 1.5);
    write({ ctx, paint }, words, x, y, NUMBER_SIZE, paint.flash, '700');
  }
  ctx.globalAlpha = 1;
  return numbers;
}

/** True if a box of words covers neither a disc nor another box. */
function isApart(box, other) {
  const [dx, dy] = [Math.abs(box.x - other.x), Math.abs(box.y - other.y)];
  if (other.reach === undefined) return dx > box.half + other.half || dy > box.high + other.high;
  return Math.hypot(Math.max(0, dx - box.half), Math.max(0, dy - box.high)) > other.reach;
}

function isWithin({ x, y, half, high }, view) {
  return x >= half && x <= view.width - half && y >= view.covered + high && y <= view.height - high;
}

/** A core of light, a shock ring, sparks, and the impulse that rises from it. */
function drawFlash(scene, met, age) {
  const { ctx, view, paint, match, theme } = scene;
  const at = met.contact ??= contactOf(match, met);
  const [x, y] = [view.x(at.x), view.y(at.y)];
  const full = Math.max(8, (met.size ??= flashRadius(match, met)) * view.scale);
  if (x < -full || y < -full || x > view.width + full || y > view.height + full) return;
  const fade = (1 - age) ** 1.5;
  const spread = theme.isCalm ? 1 : 0.35 + 0.65 * Math.sqrt(age);
  ctx.globalAlpha = fade;
  sprites.put(scene, 'flash', x, y, full * 0.8, 0, 1, (to, r) => paintGlow(to, r, theme.isDark ? paint.flash : paint.core, 1));
  ctx.strokeStyle = paint.flash;
  ctx.lineWidth = Math.max(1, 3 * (1 - age));
  circle(ctx, x, y, full * spread);
  ctx.stroke();
  const strength = strengthOf(match, met.impact);
  drawSparks(ctx, x, y, full, 8 + Math.round(18 * Math.sqrt(strength)), age, met);
  ctx.globalAlpha = 1;
}

function drawSparks(ctx, x, y, full, sparks, age, met) {
  const seed = Math.round(met.time * 1000);
  ctx.lineWidth = 1.5;
  ctx.beginPath();
  for (let k = 0; k < sparks; k++) {
    const angle = TAU * (k + 0.8 * hash01(seed, k)) / sparks;
    const far = full * (0.25 + (0.5 + 0.9 * hash01(k, seed)) * Math.sqrt(age));
    const long = full * 0.22 * (1 - age);
    ctx.moveTo(x + far * Math.cos(angle), y + far * Math.sin(angle));
    ctx.lineTo(x + (far + long) * Math.cos(angle), y + (far + long) * Math.sin(angle));
  }
  ctx.stroke();
}

export function drawMarks(scene) {
  const { match, moment } = scene;
  const marks = within(match.events, moment.time - MARK_TURNS, moment.time);
  marks.forEach((mark, k) => {
    if (!mark.event.text) return;
    const age = (moment.time - mark.time) / MARK_TURNS;
    const { x, y } = mark.event;
    drawMark(scene, mark, age, marks.slice(0, k).filter(({ event }) => event.x === x && event.y === y).length);
  });
}

function drawMark({ ctx, view, paint, match, theme, show }, { event, turn }, age, row) {
  const body = event.body === undefined ? null : match.describeIn(event.body, turn);
  const [x, y] = [view.x(event.x), view.y(event.y)];
  const colour = theme.team(body?.owner ?? null);
  const size = view.scale * Math.max(body?.radius ?? 0, 1) * (theme.isCalm ? 1.4 : 1.1 + age);
  ctx.globalAlpha = (1 - age) ** 2;
  ctx.strokeStyle = colour;
  ctx.lineWidth = 2;
  circle(ctx, x, y, Math.max(6, size));
  ctx.stroke();
  if (event.text && show.names) {
    write({ ctx, paint, view }, shorten(withNames(match, event.text), MOST_WORDS), x,
      y - Math.max(18, size + 10) - 15 * row, captionSize(view), (body?.owner ?? null) === null ? paint.ink : colour, '600');
  }
  ctx.globalAlpha = 1;
}
