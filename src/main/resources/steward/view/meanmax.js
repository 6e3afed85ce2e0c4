// The look of Mean Max: the arena with its water; looters whose outline tells the team and
// whose sign tells the kind; tankers with their water.

import { circle, directionLine, fillWith, polygon, ramp, sprites, strokeWith, write } from './draw.js';
import { paintGlow, traceBadge } from './hulls.js';
import { addLook, ranksOf } from './looks.js';
import { castsOf, drawCast, drawEffect, LOOTERS_EACH, SKILL_OF } from './meanmaxskills.js';
import { plainNumber } from './text.js';
import { withAlpha } from './theme.js';

const LOOTER_RADIUS = 400;
const RADIUS_BY_SIZE = 50;
const LOOTER_NAMES = ['reaper', 'destroyer', 'doof'];
const TEXT_PIXELS = 9;          // things drawn smaller than this have no words

addLook('mean-max', {
  leadName: 'water',

  /** The arena: around it tankers only come and go. */
  focus(match) {
    const arena = match.header.drawing.zones?.find(zone => zone.label === 'arena');
    return arena && { left: arena.x - arena.radius, top: arena.y - arena.radius, right: arena.x + arena.radius,
      bottom: arena.y + arena.radius };
  },

  drawGround(scene) {
    (scene.match.header.drawing.zones ?? []).forEach(zone => paintPlace(scene, zone));
  },

  drawBelow(scene) {
    const { match, moment } = scene;
    const { wrecks, effects } = match.turn(moment.settled).state;
    (wrecks ?? []).forEach(wreck => drawWreck(scene, wreck));
    (effects ?? []).forEach(effect => drawEffect(scene, effect.skill, effect.x, effect.y, 1));
    if (moment.fraction < 1) castsOf(match, moment).forEach(cast => drawCast(scene, cast));
    for (const body of scene.bodies) {
      const order = orderOfLooter(body, match, moment.turn);
      if (order?.x !== undefined && (scene.show.targets || body.id === scene.selected)) {
        directionLine(scene, body, order.x, order.y);
      }
    }
  },

  drawBody(scene, body) {
    if (body.kind === 'tanker') drawTanker(scene, body);
    else drawLooter(scene, body);
  },

  standing(match, number) {
    const { scores, rages } = match.turn(number).state;
    const ranks = ranksOf(scores);
    return scores.map((score, player) => ({ rank: ranks[player], body: player * LOOTERS_EACH,
      big: `${score} water`, small: `${rages[player]} rage`, warning: '' }));
  },

  commandLines: command => command.map((order, k) => `${LOOTER_NAMES[k]}: ${looterWords(order, k)}`),
  commandOf: (body, match, turn) => {
    const order = orderOfLooter(body, match, turn);
    return order ? looterWords(order, LOOTER_NAMES.indexOf(body.kind)) : '';
  },
});

function orderOfLooter(body, match, turn) {
  const k = LOOTER_NAMES.indexOf(body.kind);
  return k < 0 || turn === 0 ? null : match.turn(turn)?.commands?.[body.owner]?.[k] ?? null;
}

function looterWords(order, k) {
  if (!order) return 'nothing';
  if (order.wait) return 'WAIT';
  const place = `(${plainNumber(order.x)}, ${plainNumber(order.y)})`;
  return order.skill ? `${SKILL_OF[k].toUpperCase()} ${place}` : `${place} power ${plainNumber(order.power)}`;
}

/** The arena and its middle, where tankers fill. */
function paintPlace({ ctx, view, paint, theme }, zone) {
  const [x, y, radius] = [view.x(zone.x), view.y(zone.y), zone.radius * view.scale];
  const isWater = zone.label === 'water';
  const tint = isWater ? paint.water : paint.lane;
  const sand = ramp(ctx.createRadialGradient(x, y, 0, x, y, Math.max(1, radius)),
    [0, withAlpha(tint, isWater ? 0.26 : 0.16)], [1, withAlpha(tint, isWater ? 0.08 : theme.isDark ? 0.03 : 0.06)]);
  circle(ctx, x, y, radius);
  fillWith(ctx, sand);
  ctx.strokeStyle = isWater ? withAlpha(paint.water, 0.6) : paint.wall;
  ctx.lineWidth = isWater ? 1.25 : 3;
  ctx.setLineDash(isWater ? [4, 7] : []);
  ctx.stroke();
  ctx.setLineDash([]);
}

/** A pool of water with ripples, and how much is left. */
function drawWreck(scene, wreck) {
  const { ctx, view, paint } = scene;
  const [x, y, radius] = [view.x(wreck.x), view.y(wreck.y), wreck.radius * view.scale];
  sprites.put(scene, 'wreck', x, y, radius, 0, 1.1, (to, r) => {
    const pool = ramp(to.createRadialGradient(0, 0, 0, 0, 0, r),
      [0, withAlpha(paint.water, 0.75)], [0.7, withAlpha(paint.water, 0.38)], [1, withAlpha(paint.water, 0.12)]);
    circle(to, 0, 0, r);
    fillWith(to, pool);
    to.strokeStyle = withAlpha(paint.water, 0.9);
    for (const [share, width] of [[1, 1.75], [0.76, 0.9], [0.52, 0.7]]) {
      circle(to, 0, 0, r * share);
      to.lineWidth = width;
      to.stroke();
    }
  });
  write({ ctx, paint }, `${wreck.water ?? '?'}`, x, y, Math.max(11, Math.min(22, radius * 0.6)), paint.ink, '800');
}

// Unit outlines of the signs of the kinds.
const SIGNS = {
  reaper: [[0, -0.62], [0.22, -0.28], [0.4, 0.05], [0.36, 0.34], [0.16, 0.52], [-0.16, 0.52], [-0.36, 0.34], [-0.4, 0.05],
    [-0.22, -0.28]],
  destroyer: [[-0.14, -0.58], [0.14, -0.58], [0.14, -0.14], [0.58, -0.14], [0.58, 0.14], [0.14, 0.14], [0.14, 0.58],
    [-0.14, 0.58], [-0.14, 0.14], [-0.58, 0.14], [-0.58, -0.14], [-0.14, -0.14]],
  doof: [[0.12, -0.62], [-0.38, 0.1], [-0.06, 0.1], [-0.16, 0.62], [0.38, -0.12], [0.06, -0.12]],
};

/** The thin ring is the looter's true size; inside the team's badge stands the sign of its kind. */
function drawLooter(scene, body) {
  const { view, paint, theme, match, moment } = scene;
  const isIn = match.isIn(body.owner, moment.turn);
  const colour = isIn ? theme.team(body.owner) : paint.muted;
  const isHeavy = body.after.mass >= 10;
  const radius = Math.max(4, body.radius * view.scale);
  sprites.put(scene, `${body.kind} ${body.owner} ${isIn} ${isHeavy}`, view.x(body.x), view.y(body.y), radius, 0, 1.7,
    (ctx, r) => {
      paintGlow(ctx, r * 1.65, colour, theme.isDark ? 0.4 : 0.2);
      circle(ctx, 0, 0, r);
      fillWith(ctx, theme.isDark ? paint.abyss : paint.field);
      strokeWith(ctx, colour, isHeavy ? Math.max(3, r * 0.24) : Math.max(1, r * 0.07));
      traceBadge(ctx, 0, r * ((body.owner ?? 0) % 8 === 2 ? 0.1 : 0), r * 0.8, body.owner);
      const metal = ramp(ctx.createLinearGradient(0, -r, 0, r), [0, colour], [1, withAlpha(colour, 0.6)]);
      fillWith(ctx, metal);
      polygon(ctx, SIGNS[body.kind] ?? SIGNS.reaper, r * 0.72);
      ctx.lineJoin = 'round';
      strokeWith(ctx, paint.hull, Math.max(1, r * 0.14));
      fillWith(ctx, 'white');
    });
}

/** A steel tank with the water it has as a level, and how much of how much. */
function drawTanker(scene, body) {
  const { ctx, view, paint } = scene;
  const [x, y, radius] = [view.x(body.x), view.y(body.y), body.radius * view.scale];
  const { water, mass } = body.now;
  const size = body.now.size ?? (body.radius - LOOTER_RADIUS) / RADIUS_BY_SIZE;      // a server shows no sizes
  const level = Math.min(1, water / size);
  sprites.put(scene, `tanker ${Math.round(level * 20)} ${mass >= 10}`, x, y, radius, 0, 1.1, (to, r) => {
    circle(to, 0, 0, r);
    fillWith(to, paint.abyss);
    to.save();
    to.clip();
    to.fillStyle = withAlpha(paint.wall, 0.24);
    to.fillRect(-r, -r, 2 * r, 2 * r);
    to.fillStyle = withAlpha(paint.water, 0.65);
    to.fillRect(-r, r * (1 - 2 * level), 2 * r, 2 * r);
    to.restore();
    circle(to, 0, 0, r * 0.94);
    strokeWith(to, paint.wall, mass >= 10 ? 5 : Math.max(1.5, r * 0.1));
  });
  if (radius >= TEXT_PIXELS) {
    write({ ctx, paint }, `${water}/${size}`, x, y, Math.max(9, Math.min(14, radius * 0.5)), paint.ink, '700');
  }
}
