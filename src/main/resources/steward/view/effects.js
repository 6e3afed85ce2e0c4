// Impacts and marks of the game, which stay in view for a moment. All follows from the time alone.

import { captionSize, circle, hash01, sprites, TAU, write } from './draw.js';
import { paintGlow } from './hulls.js';
import { MOST_WORDS } from './notes.js';
import { grouped, shorten, withNames } from './text.js';
import { within } from './times.js';

const FLASH_TURNS = 1.6;        // how long an impact stays in view
const FLASH_SECONDS = 0.15;     // and at least this long when turns fly by
const MARK_TURNS = 4;
const MOST_FLASHES = 60;        // at once; of more, the strongest are drawn
const NUMBERED_SPEED = 5;       // turns a second up to which impulses are written

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

export function drawImpacts(scene) {
  const { match, moment, turnsPerSecond } = scene;
  const life = Math.max(FLASH_TURNS, FLASH_SECONDS * turnsPerSecond);
  let impacts = within(match.impacts, moment.time - life, moment.time);
  if (impacts.length > MOST_FLASHES) {
    impacts = impacts.sort((one, other) => strengthOf(match, other.impact) - strengthOf(match, one.impact))
      .slice(0, MOST_FLASHES);
  }
  for (const met of impacts) drawFlash(scene, met, (moment.time - met.time) / life);
}

/** A core of light, a shock ring, sparks, and the impulse that rises from it. */
function drawFlash(scene, met, age) {
  const { ctx, view, paint, match, theme, turnsPerSecond } = scene;
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
  if (turnsPerSecond <= NUMBERED_SPEED && age < 0.7 && met.impact.impulse !== undefined && full > 12) {
    ctx.globalAlpha = Math.min(1, 2 * fade);
    write({ ctx, paint }, grouped(Math.round(Math.abs(met.impact.impulse))), x, y - full * 0.55 - 6 - 16 * age, 12, paint.flash, '700');
    ctx.globalAlpha = 1;
  }
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
