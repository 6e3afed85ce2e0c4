// Things that last for a moment: impacts, marks of the game, trails and exhaust. All follow from the time alone, so
// that scrubbing back shows the same again.

import { captionSize, circle, hash01, moveTo, sprites, TAU, write } from './draw.js';
import { paintGlow } from './hulls.js';
import { within } from './match.js';
import { MOST_WORDS } from './notes.js';
import { grouped, shorten, withNames } from './text.js';

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
  const radius = match.describeIn(impact.a, turn).radius;
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
  sprites.put(scene, 'flash', x, y, full * 0.8, 0, 1, (to, r) => paintGlow(to, r, paint.flash, 1));
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

const TRAIL_TURNS = 22;
const TRAIL_TURNS_OF_CROWD = 3;
const CROWD = 24;
const BIG_CROWD = 120;          // beyond, trails are short lines, one stroke for each team

/** Ways of the last turns: wide and bright where a body was fast. */
export function drawTrails(scene) {
  const { bodies, selected } = scene;
  const isCrowd = bodies.length > CROWD;
  if (bodies.length > BIG_CROWD) {
    drawShortTrails(scene);
    return;
  }
  for (const body of bodies) {
    const turns = isCrowd && body.id !== selected ? TRAIL_TURNS_OF_CROWD : TRAIL_TURNS;
    drawTrail(scene, body, turns, isCrowd ? 2 : 22);
  }
  scene.ctx.globalAlpha = 1;
}

/** One line for each body from where it was two turns ago, all of a team in one stroke. */
function drawShortTrails({ ctx, view, theme, match, moment, bodies }) {
  const before = match.turn(Math.max(0, moment.turn - 2)).bodies;
  const teams = new Map();
  for (const body of bodies) {
    const from = before.get(body.id);
    if (!from) continue;
    let path = teams.get(body.owner);
    if (!path) teams.set(body.owner, path = new Path2D());
    path.moveTo(view.x(from.x), view.y(from.y));
    path.lineTo(view.x(body.x), view.y(body.y));
  }
  ctx.globalAlpha = 0.4;
  ctx.lineWidth = 1.5;
  for (const [owner, path] of teams) {
    ctx.strokeStyle = theme.team(owner);
    ctx.stroke(path);
  }
  ctx.globalAlpha = 1;
}

/** Quads that share their edges, so that no seams are seen; a thin line along the middle. */
function drawTrail({ ctx, view, theme, match, moment }, body, turns, pieces) {
  const trail = trailOf(match, body, moment, turns, pieces);
  if (trail.length < 2) return;
  const most = match.topSpeed || 1;
  const isOwned = body.owner !== null && body.owner !== undefined;
  const wide = body.radius * view.scale * (isOwned ? 1 : 0.4);
  ctx.strokeStyle = ctx.fillStyle = theme.team(body.owner);
  ctx.lineWidth = 1.25;
  const points = trail.map(([time, x, y]) => [time, view.x(x), view.y(y)]);
  let edge = null;
  for (let k = 0; k < points.length; k++) {
    const [time, x, y] = points[k];
    const [, fromX, fromY] = points[Math.max(0, k - 1)];
    const [, toX, toY] = points[Math.min(points.length - 1, k + 1)];
    const far = Math.hypot(toX - fromX, toY - fromY) || 1;
    const young = Math.max(0, 1 - (moment.time - time) / turns);
    const half = Math.max(0.5, wide * (0.03 + 0.3 * young * young));
    const [nx, ny] = [-(toY - fromY) / far * half, (toX - fromX) / far * half];
    const next = [x + nx, y + ny, x - nx, y - ny];
    if (edge) {
      const before = points[k - 1];
      const speed = Math.hypot(x - before[1], y - before[2]) / view.scale / Math.max(1e-3, time - before[0]) / most;
      ctx.globalAlpha = young * young * (0.16 + 0.5 * Math.min(1, speed)) * (isOwned ? 1 : 0.5);
      ctx.beginPath();
      ctx.moveTo(edge[0], edge[1]);
      ctx.lineTo(next[0], next[1]);
      ctx.lineTo(next[2], next[3]);
      ctx.lineTo(edge[2], edge[3]);
      ctx.fill();
      if (isOwned) {
        ctx.globalAlpha = young * young * (0.3 + 0.5 * Math.min(1, speed));
        ctx.beginPath();
        ctx.moveTo(before[1], before[2]);
        ctx.lineTo(x, y);
        ctx.stroke();
      }
    }
    edge = next;
  }
}

/** Where a body was in the last turns, corners included: [time, x, y]. */
function trailOf(match, body, moment, turns, pieces) {
  const from = Math.max(0, moment.time - turns);
  const trail = [];
  for (let number = Math.floor(from) + 1; number <= moment.turn; number++) {
    for (const [t, x, y] of match.path(body.id, number)) {
      const time = number - 1 + t;
      const isNew = !trail.length || time - trail[trail.length - 1][0] > turns / pieces / 8;
      if (isNew && time >= from && time < moment.time) trail.push([time, x, y]);
    }
  }
  trail.push([moment.time, body.x, body.y]);
  return trail;
}

const PUFFS = 12;               // a turn
const PUFF_TURNS = 1.1;

/** Exhaust behind a body: puffs that are born along its way, as large as its thrust was strong (0 to 1 and more). */
export function drawExhaust(scene, body, heading, thrust) {
  const { ctx, view, paint, theme, match, moment } = scene;
  const radius = body.radius * view.scale;
  if (thrust <= 0) return;
  ctx.globalCompositeOperation = theme.isDark ? 'lighter' : 'source-over';
  const first = Math.max(Math.ceil((moment.turn - 1) * PUFFS), Math.ceil((moment.time - PUFF_TURNS) * PUFFS));
  for (let k = first; k <= moment.time * PUFFS; k++) {
    const age = (moment.time - k / PUFFS) / PUFF_TURNS;
    const at = theme.isCalm ? body : match.placeAt(body.id, { turn: moment.turn, fraction: k / PUFFS - moment.turn + 1 });
    if (!at || age < 0) continue;
    const back = radius * (0.62 + thrust * 1.5 * age);
    const side = radius * 0.5 * (hash01(k, body.id) - 0.5) * (0.3 + 1.6 * age);
    ctx.globalAlpha = (1 - age) ** 2 * 0.6;
    const x = view.x(at.x) - Math.cos(heading) * back - Math.sin(heading) * side;
    const y = view.y(at.y) - Math.sin(heading) * back + Math.cos(heading) * side;
    sprites.put(scene, age < 0.3 ? 'puff hot' : 'puff', x, y, radius * (0.28 + 0.3 * thrust) * (1 - 0.4 * age), 0, 1,
      (to, r) => paintGlow(to, r, age < 0.3 ? paint.core : paint.flame, 0.9));
  }
  ctx.globalAlpha = 0.95;
  const [x, y] = [view.x(body.x) - Math.cos(heading) * radius * 0.72, view.y(body.y) - Math.sin(heading) * radius * 0.72];
  sprites.put(scene, 'flame', x, y, radius * (0.4 + 0.5 * Math.min(2.4, thrust)), heading, 1.2, (to, r) => {
    to.scale(1, 0.42);
    to.translate(-0.35 * r, 0);
    paintGlow(to, r * 0.85, paint.flame, 0.95);
    to.translate(0.2 * r, 0);
    paintGlow(to, r * 0.5, paint.core, 1);
  });
  ctx.globalAlpha = 1;
  ctx.globalCompositeOperation = 'source-over';
}

/** A line from each body to where it will be in two turns if nothing meets it. */
export function drawVelocities({ ctx, view, theme, bodies, selected }) {
  ctx.lineWidth = 1.75;
  for (const body of bodies) {
    if (bodies.length > BIG_CROWD && body.id !== selected) continue;
    const { vx, vy } = body.after;
    const isOwned = body.owner !== null && body.owner !== undefined;
    if (!vx && !vy || !isOwned && body.id !== selected) continue;
    const [x, y] = [view.x(body.x + 2 * vx), view.y(body.y + 2 * vy)];
    ctx.strokeStyle = ctx.fillStyle = theme.team(body.owner);
    ctx.globalAlpha = 0.85;
    ctx.beginPath();
    moveTo(ctx, view, body.x, body.y);
    ctx.lineTo(x, y);
    ctx.stroke();
    circle(ctx, x, y, 2.4);
    ctx.fill();
  }
  ctx.globalAlpha = 1;
}
