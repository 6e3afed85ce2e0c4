// What bodies leave behind and where they go: trails, exhaust, velocities. All follows from the time alone.

import { circle, hash01, moveTo, sprites, strokeLine } from './draw.js';
import { paintGlow } from './hulls.js';

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
  const wide = Math.min(body.radius, match.usualRadius) * view.scale * (isOwned ? 1 : 0.4);
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
        strokeLine(ctx, before[1], before[2], x, y);
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
    const { vx, vy } = body;
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
