// Skills of Mean Max, told apart by pattern and name: tar, oil, grenade.

import { captionSize, circle, fillWith, hash01, sprites, strokeLine, TAU, write } from './draw.js';
import { paintGlow } from './hulls.js';
import { withAlpha } from './theme.js';

const SKILL_RADIUS = 1000;
export const SKILL_OF = ['tar', 'grenade', 'oil'];       // by the kind of looter
export const LOOTERS_EACH = 3;

/** The skills that were really cast in the turn shown: those that cost rage leave an effect, or are a grenade. */
export function castsOf(match, moment) {
  const turn = match.turn(moment.turn);
  const casts = [];
  (turn.commands ?? []).forEach((command, player) => (command ?? []).forEach((order, k) => {
    if (!order?.skill) return;
    const before = match.turn(moment.turn - 1);
    const caster = before.bodies.get(player * LOOTERS_EACH + k);
    const inRange = caster && Math.hypot(order.x - caster.x, order.y - caster.y) <= 2 * SKILL_RADIUS;
    if (inRange && before.state.rages[player] >= (k === 1 ? 60 : 30)) {
      casts.push({ skill: SKILL_OF[k], x: order.x, y: order.y, from: caster, player });
    }
  }));
  return casts;
}

/** A skill that is thrown: what stays is there from the throw on, a grenade fades; a line says from whom it comes. */
export function drawCast(scene, cast) {
  const { ctx, view, theme, moment } = scene;
  drawEffect(scene, cast.skill, cast.x, cast.y, cast.skill === 'grenade' ? 1 - moment.fraction : 1);
  ctx.strokeStyle = theme.team(cast.player);
  ctx.globalAlpha = 1 - moment.fraction;
  ctx.lineWidth = 3;
  ctx.setLineDash([2, 7]);
  strokeLine(ctx, view.x(cast.from.x), view.y(cast.from.y), view.x(cast.x), view.y(cast.y));
  ctx.setLineDash([]);
  ctx.globalAlpha = 1;
}

/** Tar is a dark pool, oil has slanting bands, a grenade is a burst; each has its name. */
export function drawEffect(scene, skill, x, y, strength) {
  const { ctx, view, paint } = scene;
  const [atX, atY, radius] = [view.x(x), view.y(y), SKILL_RADIUS * view.scale];
  ctx.globalAlpha = strength;
  sprites.put(scene, `skill ${skill}`, atX, atY, radius, 0, 1.1, (to, r) => paintSkill(to, r, skill, paint));
  write({ ctx, paint }, skill.toUpperCase(), atX, atY - radius + 10, captionSize(view), paint.ink, '800');
  ctx.globalAlpha = 1;
}

function paintSkill(ctx, r, skill, paint) {
  circle(ctx, 0, 0, r);
  ctx.save();
  ctx.clip();
  if (skill === 'tar') {
    fillWith(ctx, withAlpha(paint.hull, 0.55));
    ctx.fillStyle = withAlpha(paint.muted, 0.5);
    for (let k = 0; k < 40; k++) {
      const [angle, far] = [TAU * hash01(k, 11), r * Math.sqrt(hash01(k, 12))];
      circle(ctx, far * Math.cos(angle), far * Math.sin(angle), r * (0.02 + 0.05 * hash01(k, 13)));
      ctx.fill();
    }
  } else if (skill === 'oil') {
    ctx.strokeStyle = withAlpha(paint.shield, 0.4);
    ctx.lineWidth = r * 0.07;
    for (let k = -2; k <= 2; k += 0.25) {
      strokeLine(ctx, (k - 1) * r, -r, (k + 1) * r, r);
    }
  } else {
    paintGlow(ctx, r, paint.flash, 0.75);
    ctx.strokeStyle = withAlpha(paint.flash, 0.7);
    ctx.lineWidth = 2;
    for (let k = 0; k < 16; k++) {
      const angle = k * TAU / 16;
      const [x, y] = [r * Math.cos(angle), r * Math.sin(angle)];
      strokeLine(ctx, 0.35 * x, 0.35 * y, 0.92 * x, 0.92 * y);
    }
  }
  ctx.restore();
  circle(ctx, 0, 0, r);
  ctx.strokeStyle = skill === 'oil' ? paint.shield : skill === 'tar' ? paint.muted : paint.flash;
  ctx.lineWidth = 2;
  ctx.setLineDash(skill === 'oil' ? [2, 4] : skill === 'tar' ? [9, 5] : []);
  ctx.stroke();
  ctx.setLineDash([]);
}
