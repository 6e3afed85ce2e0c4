// The look of Fantastic Bits: the pitch with its goals, wizards, snaffles, bludgers, and spells as lines to targets.

import { captionSize, circle, directionLine, fillWith, polygon, ramp, regular, sprites, strokeLine, strokeWith,
  write } from './draw.js';
import { paintGlow, putDisc } from './hulls.js';
import { addLook, PLAIN_LOOK, ranksOf } from './looks.js';
import { plainNumber } from './text.js';
import { withAlpha } from './theme.js';

const WIZARDS_EACH = 2;
const SPELL_DASHES = { obliviate: [2, 4], petrificus: [], accio: [8, 4], flipendo: [14, 4] };
const GOAL_TOP = 1750;
const GOAL_BOTTOM = 5750;
const PITCH = { width: 16000, height: 7500 };
const GOAL_DEPTH = 400;
const GOAL_TURNS = 6;           // how long a goal is celebrated

addLook('fantastic-bits', {
  leadName: 'goals',
  focus: () => ({ left: -GOAL_DEPTH, top: 0, right: PITCH.width + GOAL_DEPTH, bottom: PITCH.height }),

  /** A goal has the colour of the player who scores in it. */
  drawGround(scene) {
    paintPitch(scene);
    paintGoal(scene, PITCH.width, 0, 1);
    paintGoal(scene, 0, 1, -1);
  },

  drawBelow(scene) {
    const { match, moment, show, selected } = scene;
    wizardsOf(scene).forEach(wizard => {
      drawSpells(scene, wizard);
      const order = orderOfWizard(wizard, match, moment.turn);
      if (order?.x !== undefined && (show.targets || wizard.id === selected)) {
        directionLine(scene, wizard, order.x, order.y);
      }
    });
    drawGoals(scene);
  },

  drawBody(scene, body) {
    if (body.kind === 'wizard') drawWizard(scene, body);
    else if (body.kind === 'bludger') drawBludger(scene, body);
    else drawSnaffle(scene, body);
  },

  standing(match, number) {
    const { scores, magic } = match.turn(number).state;
    const ranks = ranksOf(scores);
    return scores.map((score, player) => ({ rank: ranks[player], body: player * WIZARDS_EACH,
      big: `${score} ${score === 1 ? 'goal' : 'goals'}`, small: `${magic[player]} magic`, warning: '' }));
  },

  commandLines: command => command.map(wizardWords),
  commandOf: (body, match, turn) => {
    const order = orderOfWizard(body, match, turn);
    return order ? wizardWords(order) : '';
  },

  field(name, value) {
    if (name === 'spells') return value.map(({ spell, target, turns }) => `${spell} ${target} (${turns})`).join(', ');
    if (name === 'cast') return `${value.spell} ${value.target}`;
    return PLAIN_LOOK.field(name, value);
  },
});

function orderOfWizard(body, match, turn) {
  if (body.kind !== 'wizard' || turn === 0) return null;
  return match.turn(turn)?.commands?.[body.owner]?.[body.id % WIZARDS_EACH] ?? null;
}

function wizardWords(order) {
  if (!order) return 'nothing';
  if (order.spell) return `${order.spell.toUpperCase()} ${order.target}`;
  const place = `(${plainNumber(order.x)}, ${plainNumber(order.y)})`;
  return order.throw === undefined ? `${place} power ${plainNumber(order.power)}`
    : `THROW ${place} power ${plainNumber(order.throw)}`;
}

function wizardsOf(scene) {
  return scene.bodies.filter(body => body.kind === 'wizard');
}

/** Mown stripes, the middle line and its circle. */
function paintPitch({ ctx, view, paint }) {
  const stripes = 10;
  for (let k = 0; k < stripes; k += 2) {
    ctx.fillStyle = withAlpha(paint.lane, 0.07);
    ctx.fillRect(view.x(k * PITCH.width / stripes), view.y(0), PITCH.width / stripes * view.scale, PITCH.height * view.scale);
  }
  ctx.strokeStyle = withAlpha(paint.rim, 0.55);
  ctx.lineWidth = 1.5;
  strokeLine(ctx, view.x(PITCH.width / 2), view.y(0), view.x(PITCH.width / 2), view.y(PITCH.height));
  circle(ctx, view.x(PITCH.width / 2), view.y(PITCH.height / 2), 1300 * view.scale);
  ctx.stroke();
}

/** A net behind the line between two posts. */
function paintGoal({ ctx, view, paint, theme }, x, player, outward) {
  const colour = theme.team(player);
  const [line, back] = [view.x(x), view.x(x + outward * GOAL_DEPTH)];
  const [top, bottom] = [view.y(GOAL_TOP), view.y(GOAL_BOTTOM)];
  const light = ramp(ctx.createLinearGradient(line, 0, view.x(x - outward * 1800), 0),
    [0, withAlpha(colour, 0.3)], [1, withAlpha(colour, 0)]);
  ctx.fillStyle = light;
  ctx.fillRect(Math.min(line, view.x(x - outward * 1800)), top, 1800 * view.scale, bottom - top);
  ctx.fillStyle = withAlpha(colour, 0.18);
  ctx.fillRect(Math.min(line, back), top, Math.abs(back - line), bottom - top);
  ctx.strokeStyle = withAlpha(colour, 0.55);
  ctx.lineWidth = 1;
  ctx.beginPath();
  for (let y = top; y <= bottom + 0.1; y += (bottom - top) / 16) {
    ctx.moveTo(line, y);
    ctx.lineTo(back, y);
  }
  ctx.stroke();
  ctx.strokeStyle = colour;
  ctx.lineWidth = 2.5;
  strokeLine(ctx, line, top, line, bottom);
  for (const y of [top, bottom]) {
    circle(ctx, line, y, Math.max(4, 300 * view.scale));
    fillWith(ctx, paint.abyss);
    ctx.lineWidth = 2.5;
    ctx.stroke();
  }
}

/** The last goals: a ring of the scorer's colour where the snaffle crossed the line. */
function drawGoals({ ctx, view, theme, match, moment }) {
  for (const { time, event } of match.events) {
    const age = (moment.time - time) / GOAL_TURNS;
    const scorer = /^goal for player (\d+)/.exec(event.text ?? '')?.[1];
    if (scorer === undefined || age < 0 || age > 1) continue;
    ctx.strokeStyle = theme.team(Number(scorer));
    ctx.lineWidth = 4 * (1 - age) + 0.5;
    ctx.globalAlpha = 1 - age;
    for (const reach of [500, 1100]) {
      circle(ctx, view.x(event.x), view.y(event.y), reach * view.scale * (theme.isCalm ? 0.8 : 0.3 + age));
      ctx.stroke();
    }
  }
  ctx.globalAlpha = 1;
}

/** A disc of its true size with its team's badge and its number; a second ring tells that it holds a snaffle. */
function drawWizard(scene, body) {
  const { ctx, view, paint, theme, match, moment } = scene;
  putDisc(scene, body, match.isIn(body.owner, moment.turn), 'wizard');
  const [x, y, radius] = [view.x(body.x), view.y(body.y), body.radius * view.scale];
  if (body.now.snaffle >= 0) {
    circle(ctx, x, y, radius + Math.max(3, radius * 0.22));
    strokeWith(ctx, theme.team(body.owner), 2);
  }
  write({ ctx, paint }, body.label, x, y, Math.max(10, radius * 0.7), paint.ink, '800');
}

/** A golden ball with a seam. */
function drawSnaffle(scene, body) {
  const { view, paint } = scene;
  sprites.put(scene, 'snaffle', view.x(body.x), view.y(body.y), Math.max(3.5, body.radius * view.scale), 0, 2.2, (ctx, r) => {
    paintGlow(ctx, r * 2.1, paint.core, 0.45);
    circle(ctx, 0, 0, r);
    const ball = ramp(ctx.createRadialGradient(-r * 0.35, -r * 0.4, 0, 0, 0, r),
      [0, 'white'], [0.5, paint.core], [1, withAlpha(paint.core, 0.75)]);
    fillWith(ctx, ball);
    strokeWith(ctx, paint.ink, 1);
  });
}

/** An iron ball with spikes. */
function drawBludger(scene, body) {
  const { view, paint } = scene;
  sprites.put(scene, 'bludger', view.x(body.x), view.y(body.y), Math.max(4, body.radius * view.scale), 0, 1.5, (ctx, r) => {
    ctx.fillStyle = paint.muted;
    for (let k = 0; k < 8; k++) {
      ctx.rotate(Math.PI / 4);
      polygon(ctx, [[0.8, -0.2], [1.35, 0], [0.8, 0.2]], r);
      ctx.fill();
    }
    const iron = ramp(ctx.createRadialGradient(-r * 0.35, -r * 0.4, 0, 0, 0, r),
      [0, paint.ink], [0.35, paint.muted], [1, paint.hull]);
    circle(ctx, 0, 0, r);
    fillWith(ctx, iron);
    strokeWith(ctx, paint.bad, Math.max(1.5, r * 0.16));
    regular(ctx, 0, 0, r * 0.4, 3);
    fillWith(ctx, paint.bad);
  });
}

/** Spells at work are lines from the wizard to the target; the dashes and the name tell which. */
function drawSpells(scene, wizard) {
  const { ctx, view, paint } = scene;
  for (const { spell, target } of wizard.after.spells ?? []) {
    const at = scene.bodies.find(body => body.id === target);
    if (!at) continue;
    ctx.strokeStyle = paint.shield;
    for (const [width, alpha] of [[7, 0.18], [2, 1]]) {
      ctx.globalAlpha = alpha;
      ctx.lineWidth = width;
      ctx.setLineDash(width === 2 ? SPELL_DASHES[spell] ?? [] : []);
      strokeLine(ctx, view.x(wizard.x), view.y(wizard.y), view.x(at.x), view.y(at.y));
    }
    ctx.setLineDash([]);
    circle(ctx, view.x(at.x), view.y(at.y), at.radius * view.scale + 5);
    ctx.stroke();
    if (scene.show.names) {
      write({ ctx, paint }, spell, view.x((wizard.x + at.x) / 2), view.y((wizard.y + at.y) / 2) - 9, captionSize(view),
        paint.shield, '700');
    }
  }
}
