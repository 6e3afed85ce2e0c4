// A course of checkpoints: the lane through them, gates with their numbers, and who is due at each.

import { circle, fillWith, FONT, ramp, strokeWith, TAU, write } from './draw.js';
import { paintFrame } from './ground.js';
import { withAlpha } from './theme.js';

const TENSION = 1 / 7;          // of the curve through the checkpoints
const LANES = [[2.36, 0.05], [2.2, 0.07], [1.5, 0.09]];        // widths in radii of a checkpoint, and strengths

export function paintCourse(scene) {
  const { ctx, view, paint, match } = scene;
  const zones = match.header.drawing.zones;
  paintFrame(scene);
  ctx.lineJoin = 'round';
  if (zones.length > 1) {
    for (const [width, strength] of LANES) {
      traceLane(scene, zones);
      strokeWith(ctx, withAlpha(paint.lane, strength), width * zones[0].radius * view.scale);
    }
    traceLane(scene, zones);
    ctx.strokeStyle = withAlpha(paint.lane, 0.4);
    ctx.lineWidth = 1.25;
    ctx.setLineDash([10, 12]);
    ctx.stroke();
    ctx.setLineDash([]);
    zones.forEach((zone, k) => paintArrow(scene, zones, k));
  }
  zones.forEach((zone, number) => paintGate(scene, zone, number));
}

/** Control points of the curve from checkpoint k to the next (Catmull-Rom as Bezier). */
function bend(zones, k) {
  const at = index => zones[(index + zones.length) % zones.length];
  const [before, from, to, after] = [at(k - 1), at(k), at(k + 1), at(k + 2)];
  return { from, to,
    a: { x: from.x + (to.x - before.x) * TENSION, y: from.y + (to.y - before.y) * TENSION },
    b: { x: to.x - (after.x - from.x) * TENSION, y: to.y - (after.y - from.y) * TENSION } };
}

function traceLane({ ctx, view }, zones) {
  ctx.beginPath();
  ctx.moveTo(view.x(zones[0].x), view.y(zones[0].y));
  zones.forEach((_, k) => {
    const { a, b, to } = bend(zones, k);
    ctx.bezierCurveTo(view.x(a.x), view.y(a.y), view.x(b.x), view.y(b.y), view.x(to.x), view.y(to.y));
  });
  ctx.closePath();
}

/** A chevron half-way to the next checkpoint. */
function paintArrow({ ctx, view, paint }, zones, k) {
  const { from, to, a, b } = bend(zones, k);
  const x = (from.x + 3 * a.x + 3 * b.x + to.x) / 8;
  const y = (from.y + 3 * a.y + 3 * b.y + to.y) / 8;
  const angle = Math.atan2(to.y + b.y - a.y - from.y, to.x + b.x - a.x - from.x);
  ctx.save();
  ctx.translate(view.x(x), view.y(y));
  ctx.rotate(angle);
  ctx.strokeStyle = withAlpha(paint.lane, 0.9);
  ctx.lineWidth = 2.5;
  ctx.lineCap = 'round';
  ctx.beginPath();
  ctx.moveTo(-4, -6);
  ctx.lineTo(4, 0);
  ctx.lineTo(-4, 6);
  ctx.stroke();
  ctx.restore();
}

function paintGate({ ctx, view, paint }, zone, number) {
  const [x, y, radius] = [view.x(zone.x), view.y(zone.y), zone.radius * view.scale];
  circle(ctx, x, y, radius);
  const disc = ramp(ctx.createRadialGradient(x, y, radius * 0.2, x, y, Math.max(1, radius)),
    [0, withAlpha(paint.abyss, 0.55)], [1, withAlpha(paint.abyss, 0.2)]);
  fillWith(ctx, disc);
  strokeWith(ctx, paint.rim, 1.75);
  if (number === 0) {
    ctx.lineWidth = Math.max(3, radius * 0.12);
    ctx.setLineDash([TAU * radius / 44, TAU * radius / 44]);
    ctx.stroke();
    ctx.setLineDash([]);
  }
  const words = number === 0 ? 'START' : zone.label;
  write({ ctx, paint }, words, x, y, Math.max(10, radius * (number === 0 ? 0.32 : 0.68)), paint.rim, '800');
}

/** Arcs outside the rims of gates: one for each racer that is due there, with its number. */
export function drawDue(scene, racers) {
  const { ctx, view, theme, match } = scene;
  const zones = match.header.drawing.zones;
  zones.forEach((zone, number) => {
    const due = racers.filter(racer => (racer.passed + 1) % zones.length === number);
    const radius = zone.radius * view.scale + 5;
    const apart = Math.min(0.62, 5 / Math.max(1, due.length));
    due.forEach((racer, k) => {
      const angle = -Math.PI / 2 + (k - (due.length - 1) / 2) * apart;
      ctx.beginPath();
      ctx.arc(view.x(zone.x), view.y(zone.y), radius, angle - apart * 0.4, angle + apart * 0.4);
      ctx.strokeStyle = theme.team(racer.owner);
      ctx.lineWidth = 3.5;
      ctx.lineCap = 'round';
      ctx.stroke();
      if (!racer.label) return;
      ctx.font = `700 11px ${FONT}`;
      ctx.textAlign = 'center';
      ctx.textBaseline = 'middle';
      ctx.fillStyle = theme.team(racer.owner);
      ctx.fillText(racer.label, view.x(zone.x) + (radius + 11) * Math.cos(angle), view.y(zone.y) + (radius + 11) * Math.sin(angle));
    });
  });
}

/** Checkpoints passed, and the share of the way to the next. */
export function progressOf(zones, racer) {
  if (!zones.length) return 0;
  const from = zones[racer.passed % zones.length];
  const to = zones[(racer.passed + 1) % zones.length];
  const whole = Math.hypot(to.x - from.x, to.y - from.y) || 1;
  const left = Math.hypot(to.x - racer.x, to.y - racer.y);
  return racer.passed + Math.max(0, Math.min(0.999, 1 - left / whole));
}
