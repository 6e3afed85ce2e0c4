// The look of Fantastic Bits: the pitch with its goals, wizards, snaffles, bludgers, and spells as lines to targets.

const WIZARDS_EACH = 2;
const SPELL_STYLES = {
  obliviate: ['muted', [2, 4]],
  petrificus: ['ink', []],
  accio: ['shield', [8, 4]],
  flipendo: ['flame', [12, 4]],
};
const GOAL_TOP = 1750;
const GOAL_BOTTOM = 5750;
const PITCH_WIDTH = 16000;
const GOAL_DEPTH = 400;
const NUMBER_PIXELS = 7;        // wizards drawn smaller than this have no numbers

const FANTASTIC_BITS_LOOK = {
  /** A goal has the colour of the player who scores in it. */
  drawGround(scene) {
    drawGoal(scene, PITCH_WIDTH, 0);
    drawGoal(scene, -GOAL_DEPTH, 1);
  },

  drawBelow(scene) {
    wizardsOf(scene).forEach(wizard => drawSpells(scene, wizard));
    if (scene.show.targets) wizardsOf(scene).forEach(wizard => drawWizardTarget(scene, wizard));
  },

  drawBody(scene, body) {
    if (body.kind === 'wizard') drawWizard(scene, body);
    else if (body.kind === 'bludger') drawBludger(scene, body);
    else drawSnaffle(scene, body);
  },

  drawAbove(scene) {
    const { match, moment, view, theme } = scene;
    if (!scene.show.names) return;
    wizardsOf(scene).filter(wizard => !match.isIn(wizard.owner, moment.turn)).forEach(wizard => {
      write(scene, 'OUT', view.x(wizard.x), view.y(wizard.y) + wizard.radius * view.scale + 9, captionSize(view),
        theme.team(wizard.owner), '700');
    });
  },

  /** Per player: rank by goals, the goals, the magic, and its first wizard. */
  standing(match, number) {
    const { scores, magic } = match.turn(number).state;
    return scores.map((score, player) => ({
      rank: scores.filter(other => other > score).length,
      body: player * WIZARDS_EACH,
      big: `${score} ${score === 1 ? 'goal' : 'goals'} · ${magic[player]} magic`,
      small: '',
      warning: '',
    }));
  },

  commandLines: command => command.map(wizardOrder),

  field(name, value) {
    if (name === 'spells') return value.map(({ spell, target, turns }) => `${spell} ${target} (${turns})`).join(', ');
    if (name === 'cast') return `${value.spell} ${value.target}`;
    return PLAIN_LOOK.field(name, value);
  },
};

LOOKS['fantastic-bits'] = FANTASTIC_BITS_LOOK;

function wizardOrder(order) {
  if (!order) return 'nothing';
  if (order.spell) return `${order.spell.toUpperCase()} ${order.target}`;
  const place = `(${plainNumber(order.x)}, ${plainNumber(order.y)})`;
  return order.throw === undefined ? `${place} power ${plainNumber(order.power)}`
    : `THROW ${place} power ${plainNumber(order.throw)}`;
}

function wizardsOf(scene) {
  return scene.bodies.filter(body => body.kind === 'wizard');
}

function drawGoal({ ctx, view, theme }, left, player) {
  const size = view.scale;
  ctx.fillStyle = withAlpha(theme.team(player), 0.25);
  ctx.fillRect(view.x(left), view.y(GOAL_TOP), GOAL_DEPTH * size, (GOAL_BOTTOM - GOAL_TOP) * size);
}

/** A disc of its true size with its number; a ring tells that it holds a snaffle. */
function drawWizard(scene, body) {
  const { ctx, view, paint, theme, match, moment } = scene;
  const [x, y, radius] = [view.x(body.x), view.y(body.y), body.radius * view.scale];
  const colour = match.isIn(body.owner, moment.turn) ? theme.team(body.owner) : paint.muted;
  circle(ctx, x, y, radius);
  ctx.fillStyle = withAlpha(colour, 0.45);
  ctx.fill();
  ctx.strokeStyle = colour;
  ctx.lineWidth = Math.max(1.5, radius * 0.12);
  ctx.stroke();
  if (body.after.snaffle >= 0) {
    circle(ctx, x, y, radius + Math.max(3, radius * 0.2));
    ctx.lineWidth = 1.5;
    ctx.stroke();
  }
  if (radius >= NUMBER_PIXELS) {
    const size = Math.max(9, radius * 0.7);
    write({ ctx, paint }, body.label, x, y - radius * 0.5, size, paint.ink, '800');
  }
}

function drawSnaffle({ ctx, view, paint }, body) {
  circle(ctx, view.x(body.x), view.y(body.y), Math.max(2.5, body.radius * view.scale));
  ctx.fillStyle = paint.core;
  ctx.fill();
  ctx.strokeStyle = paint.ink;
  ctx.lineWidth = 1;
  ctx.stroke();
}

function drawBludger({ ctx, view, paint }, body) {
  const [x, y, radius] = [view.x(body.x), view.y(body.y), Math.max(3, body.radius * view.scale)];
  circle(ctx, x, y, radius);
  ctx.fillStyle = paint.ink;
  ctx.fill();
  circle(ctx, x, y, radius * 0.45);
  ctx.fillStyle = paint.bad;
  ctx.fill();
}

/** Spells at work are lines from the wizard to the target, with the spell's name at the middle. */
function drawSpells(scene, wizard) {
  const { ctx, view, paint } = scene;
  for (const { spell, target } of wizard.after.spells ?? []) {
    const at = scene.bodies.find(body => body.id === target);
    if (!at) continue;
    const [name, dash] = SPELL_STYLES[spell];
    ctx.strokeStyle = paint[name] ?? paint.ink;
    ctx.lineWidth = 2;
    ctx.setLineDash(dash);
    ctx.beginPath();
    moveTo(ctx, view, wizard.x, wizard.y);
    lineTo(ctx, view, at.x, at.y);
    ctx.stroke();
    ctx.setLineDash([]);
    circle(ctx, view.x(at.x), view.y(at.y), at.radius * view.scale + 4);
    ctx.stroke();
    if (scene.show.names) {
      write({ ctx, paint }, spell, view.x((wizard.x + at.x) / 2), view.y((wizard.y + at.y) / 2) - 8, captionSize(view),
        paint[name] ?? paint.ink, '700');
    }
  }
}

function drawWizardTarget(scene, wizard) {
  const { ctx, view, theme, match, moment } = scene;
  const order = match.turn(moment.turn)?.commands?.[wizard.owner]?.[wizard.id % WIZARDS_EACH];
  if (order?.x === undefined) return;
  const far = Math.hypot(order.x - wizard.x, order.y - wizard.y);
  const share = Math.min(1, 4 * wizard.radius / Math.max(1, far));      // only the direction counts
  ctx.strokeStyle = theme.team(wizard.owner);
  ctx.globalAlpha = 0.6;
  ctx.lineWidth = order.throw === undefined ? 1 : 2.5;
  ctx.setLineDash([5, 5]);
  ctx.beginPath();
  moveTo(ctx, view, wizard.x, wizard.y);
  lineTo(ctx, view, wizard.x + (order.x - wizard.x) * share, wizard.y + (order.y - wizard.y) * share);
  ctx.stroke();
  ctx.setLineDash([]);
  ctx.globalAlpha = 1;
}
