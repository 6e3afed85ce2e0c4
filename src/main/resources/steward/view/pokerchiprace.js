// The look of the Poker Chip Race: chips with a notched rim in the colour of their owner, grey where they are neutral.

import { circle, directionLine, fillWith, ramp, sprites, strokeWith, TAU, write } from './draw.js';
import { paintBadge, paintGlow } from './hulls.js';
import { addLook, ranksOf } from './looks.js';
import { paintFrame } from './ground.js';
import { grouped, plainNumber } from './text.js';
import { withAlpha } from './theme.js';

const RIM = 0.78;               // of the radius: where the rim begins
const NOTCHES = 8;
const SMALL_CHIP = 5;           // up to this radius a chip cannot push itself
const CHIP_NAME_PIXELS = 11;    // chips drawn smaller than this have no number

addLook('poker-chip-race', {
  leadName: 'area',
  drawGround: scene => paintFrame(scene, true),

  drawBelow(scene) {
    const { match, moment, show, selected } = scene;
    if (moment.turn === 0) return;
    match.players.forEach((_, player) => chipsOf(match, moment.turn - 1, player).forEach(chip => {
      const order = orderOfChip(chip, match, moment.turn);
      const isAsked = show.targets || chip.id === selected;
      if (isAsked && order?.x !== undefined && chip.radius > SMALL_CHIP) {
        directionLine(scene, { ...chip, owner: player }, order.x, order.y);
      }
    }));
  },

  drawBody: drawChip,
  drawAbove() {},

  progress: (match, number) => match.players.map((_, player) => areaOf(chipsOf(match, number, player))),

  /** Per player: rank by the area of its chips, their number, and the biggest of them. */
  standing(match, number) {
    const chips = match.players.map((_, player) => chipsOf(match, number, player));
    const areas = chips.map(areaOf);
    const ranks = ranksOf(areas);
    return areas.map((area, player) => ({ rank: ranks[player], body: biggest(chips[player])?.id ?? null,
      big: `${grouped(Math.round(area))} u²`, small: chips[player].length === 1 ? '1 chip' : `${chips[player].length} chips`,
      warning: '' }));
  },

  commandLines: command => command.map((order, k) => `chip ${k + 1}: ${pushWords(order)}`),
  commandOf: (body, match, turn) => {
    const order = turn === 0 ? undefined : orderOfChip(body, match, turn);
    return order === undefined ? '' : pushWords(order);
  },
});

function pushWords(order) {
  if (!order) return 'nothing';
  return order.wait ? 'WAIT' : `push toward (${plainNumber(order.x)}, ${plainNumber(order.y)})`;
}

/** The chips of a player at the end of a turn, in the order of its commands. */
function chipsOf(match, number, player) {
  return [...match.turn(number).bodies.values()].filter(chip => chip.player === player);
}

/** The command of a chip; undefined where it has none. */
function orderOfChip(chip, match, turn) {
  const player = match.turn(turn - 1)?.bodies.get(chip.id)?.player;
  if (player === undefined) return undefined;
  const k = chipsOf(match, turn - 1, player).findIndex(each => each.id === chip.id);
  return match.turn(turn)?.commands?.[player]?.[k];
}

function areaOf(chips) {
  return chips.reduce((sum, chip) => sum + Math.PI * chip.radius ** 2, 0);
}

function biggest(chips) {
  return chips.reduce((best, chip) => (best && best.radius >= chip.radius ? best : chip), null);
}

function drawChip(scene, body) {
  const { ctx, view, paint, show } = scene;
  const [x, y, radius] = [view.x(body.x), view.y(body.y), Math.max(1.5, body.radius * view.scale)];
  const owner = body.after.player ?? null;                // the drawing knows who owned it at the start
  sprites.put(scene, `chip ${owner}`, x, y, radius, 0, 1.6, (to, r) => paintChip(to, r, owner, scene));
  if (show.names && owner !== null && radius >= CHIP_NAME_PIXELS) {
    write({ ctx, paint }, String(body.id), x, y, Math.max(9, Math.min(16, radius * 0.5)), paint.ink, '800');
  }
}

/** Glow, disc, the notches by which one knows a poker chip, and the owner's badge. */
function paintChip(ctx, r, owner, { theme, paint }) {
  const colour = owner === null ? paint.wall : theme.team(owner);
  if (owner !== null) paintGlow(ctx, r * 1.5, colour, theme.isDark ? 0.4 : 0.2);
  const face = ramp(ctx.createRadialGradient(-r * 0.3, -r * 0.4, 0, 0, 0, r),
    [0, withAlpha(colour, owner === null ? 0.5 : 0.95)], [1, withAlpha(colour, owner === null ? 0.22 : 0.65)]);
  circle(ctx, 0, 0, r);
  fillWith(ctx, theme.isDark ? paint.abyss : paint.field);
  fillWith(ctx, face);
  if (r >= 5) {
    ctx.lineWidth = r * (1 - RIM);
    ctx.strokeStyle = theme.isDark ? withAlpha('white', owner === null ? 0.35 : 0.85) : withAlpha('white', 0.8);
    for (let k = 0; k < NOTCHES; k++) {
      const angle = (k + 0.25) * TAU / NOTCHES;
      ctx.beginPath();
      ctx.arc(0, 0, r * (1 + RIM) / 2, angle, angle + TAU / NOTCHES / 2.4);
      ctx.stroke();
    }
    circle(ctx, 0, 0, r * RIM);
    strokeWith(ctx, withAlpha(paint.hull, 0.5), Math.max(0.75, r * 0.03));
  }
  if (owner !== null && r >= 4) {
    circle(ctx, 0, 0, r * 0.66);
    fillWith(ctx, withAlpha(paint.hull, 0.55));
    paintBadge(ctx, r * 0.5, owner, colour, paint, theme.isDark);
  }
  circle(ctx, 0, 0, r);
  strokeWith(ctx, colour, Math.max(0.75, r * 0.04));
}
