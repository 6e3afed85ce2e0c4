// The look of Mean Max: the arena with its water, wrecks and skill effects, looters by kind, tankers with their water.

const LOOTER_SIDES = { destroyer: 6, doof: 3 };       // a reaper is round
const SKILL_RADIUS = 1000;
const LOOTER_RADIUS = 400;
const RADIUS_BY_SIZE = 50;
const SKILL_OF = ['tar', 'grenade', 'oil'];
const LOOTER_NAMES = ['reaper', 'destroyer', 'doof'];
const NAME_PIXELS = 7;          // looters drawn smaller than this have no letters

const MEAN_MAX_LOOK = {
  drawGround(scene) {
    const { match, moment } = scene;
    scene.match.header.drawing.zones.forEach(zone => drawPlace(scene, zone));
    const { wrecks, effects } = match.turn(moment.settled).state;
    wrecks.forEach(wreck => drawWreck(scene, wreck));
    effects.forEach(effect => drawEffect(scene, effect.skill, effect.x, effect.y, 1));
    castsOf(match, moment).forEach(cast => drawEffect(scene, cast.skill, cast.x, cast.y, 1 - moment.fraction));
  },

  drawBelow(scene) {
    if (scene.show.targets) scene.bodies.forEach(body => drawLooterTarget(scene, body));
  },

  drawBody(scene, body) {
    if (body.kind === 'tanker') drawTanker(scene, body);
    else drawLooter(scene, body);
  },

  drawAbove(scene) {
    const { match, moment, view, theme } = scene;
    if (!scene.show.names) return;
    for (const body of scene.bodies) {
      if (body.kind !== 'tanker' && !match.isIn(body.owner, moment.turn)) {
        write(scene, 'OUT', view.x(body.x), view.y(body.y) + body.radius * view.scale + 9, captionSize(view),
          theme.team(body.owner), '700');
      }
    }
  },

  /** Per player: rank by water, the water harvested, the rage, and the reaper. */
  standing(match, number) {
    const { scores, rages } = match.turn(number).state;
    return scores.map((score, player) => ({
      rank: scores.filter(other => other > score).length,
      body: player * LOOTER_NAMES.length,
      big: `${score} water · ${rages[player]} rage`,
      small: '',
      warning: '',
    }));
  },

  commandLines: command => command.map((order, k) => `${LOOTER_NAMES[k]}: ${looterOrder(order, k)}`),

  field: (name, value) => PLAIN_LOOK.field(name, value),
};

LOOKS['mean-max'] = MEAN_MAX_LOOK;

function looterOrder(order, k) {
  if (!order) return 'nothing';
  if (order.wait) return 'WAIT';
  const place = `(${plainNumber(order.x)}, ${plainNumber(order.y)})`;
  return order.skill ? `${SKILL_OF[k].toUpperCase()} ${place}` : `${place} power ${plainNumber(order.power)}`;
}

/** The skills that were really cast in the turn shown: those that cost rage leave an effect, or are a grenade. */
function castsOf(match, moment) {
  const turn = match.turn(moment.turn);
  const casts = [];
  (turn.commands ?? []).forEach((command, player) => (command ?? []).forEach((order, k) => {
    if (!order?.skill) return;
    const caster = match.turn(moment.turn - 1).bodies.get(player * LOOTER_NAMES.length + k);
    const inRange = Math.hypot(order.x - caster.x, order.y - caster.y) <= 2 * SKILL_RADIUS;
    const cost = k === 1 ? 60 : 30;
    if (inRange && match.turn(moment.turn - 1).state.rages[player] >= cost) {
      casts.push({ skill: SKILL_OF[k], x: order.x, y: order.y });
    }
  }));
  return casts;
}

/** The arena and its water: a disc and a name at its upper rim, of a size that the view sets. */
function drawPlace(scene, zone) {
  const { ctx, view, paint } = scene;
  const isWater = zone.label === 'water';
  circle(ctx, view.x(zone.x), view.y(zone.y), zone.radius * view.scale);
  ctx.fillStyle = isWater ? withAlpha(paint.shield, 0.08) : withAlpha(paint.zone, 0.35);
  ctx.fill();
  ctx.strokeStyle = isWater ? withAlpha(paint.shield, 0.5) : paint.wall;
  ctx.lineWidth = isWater ? 1 : 3;
  ctx.setLineDash(isWater ? [4, 6] : []);
  ctx.stroke();
  ctx.setLineDash([]);
}

function drawWreck(scene, wreck) {
  const { ctx, view, paint } = scene;
  const [x, y, radius] = [view.x(wreck.x), view.y(wreck.y), wreck.radius * view.scale];
  circle(ctx, x, y, radius);
  ctx.fillStyle = withAlpha(paint.shield, 0.28);
  ctx.fill();
  ctx.strokeStyle = paint.shield;
  ctx.lineWidth = 1.5;
  ctx.stroke();
  write({ ctx, paint }, String(wreck.water ?? '?'), x, y, Math.max(11, Math.min(22, radius * 0.6)), paint.ink, '800');
}

function effectColour(paint, skill) {
  return skill === 'tar' ? paint.ink : skill === 'oil' ? paint.bad : paint.flame;
}

function drawEffect(scene, skill, x, y, strength) {
  const { ctx, view, paint } = scene;
  const colour = effectColour(paint, skill);
  ctx.globalAlpha = strength;
  circle(ctx, view.x(x), view.y(y), SKILL_RADIUS * view.scale);
  ctx.fillStyle = withAlpha(colour, 0.22);
  ctx.fill();
  ctx.strokeStyle = colour;
  ctx.lineWidth = 1.5;
  ctx.setLineDash(skill === 'oil' ? [2, 4] : skill === 'tar' ? [8, 4] : []);
  ctx.stroke();
  ctx.setLineDash([]);
  write({ ctx, paint }, skill, view.x(x), view.y(y) - SKILL_RADIUS * view.scale + 9, captionSize(view), colour, '700');
  ctx.globalAlpha = 1;
}

/** The circle is the looter's true size; the form inside tells its kind, the letters too. */
function drawLooter(scene, body) {
  const { ctx, view, paint, theme, match, moment } = scene;
  const [x, y, radius] = [view.x(body.x), view.y(body.y), body.radius * view.scale];
  const colour = match.isIn(body.owner, moment.turn) ? theme.team(body.owner) : paint.muted;
  circle(ctx, x, y, radius);
  ctx.fillStyle = withAlpha(colour, 0.3);
  ctx.fill();
  ctx.strokeStyle = colour;
  ctx.lineWidth = body.after.mass >= 10 ? Math.max(3, radius * 0.25) : Math.max(1, radius * 0.08);
  ctx.stroke();
  traceForm(ctx, x, y, 0.72 * radius, LOOTER_SIDES[body.kind]);
  ctx.fillStyle = colour;
  ctx.fill();
  if (radius >= NAME_PIXELS) write({ ctx, paint }, body.label, x, y, Math.max(9, radius * 0.7), paint.ink, '800');
}

/** A regular form with a corner at the top; a circle if it has no sides. */
function traceForm(ctx, x, y, radius, sides) {
  if (!sides) {
    circle(ctx, x, y, radius);
    return;
  }
  ctx.beginPath();
  for (let k = 0; k < sides; k++) {
    const angle = -Math.PI / 2 + k * 2 * Math.PI / sides;
    ctx.lineTo(x + radius * Math.cos(angle), y + radius * Math.sin(angle));
  }
  ctx.closePath();
}

/** A grey disc with the share of its water as an arc, and how much of how much. */
function drawTanker(scene, body) {
  const { ctx, view, paint } = scene;
  const [x, y, radius] = [view.x(body.x), view.y(body.y), body.radius * view.scale];
  const { water, mass } = body.after;
  const size = body.after.size ?? (body.radius - LOOTER_RADIUS) / RADIUS_BY_SIZE;      // a server shows no sizes
  circle(ctx, x, y, radius);
  ctx.fillStyle = withAlpha(paint.muted, 0.3);
  ctx.fill();
  ctx.strokeStyle = paint.muted;
  ctx.lineWidth = mass >= 10 ? 4 : 1.5;
  ctx.stroke();
  ctx.beginPath();
  ctx.arc(x, y, radius * 0.84, -Math.PI / 2, -Math.PI / 2 + Math.min(1, water / size) * 2 * Math.PI);
  ctx.strokeStyle = paint.shield;
  ctx.lineWidth = Math.max(2, radius * 0.16);
  ctx.lineCap = 'butt';
  ctx.stroke();
  if (radius >= NAME_PIXELS) {
    write({ ctx, paint }, `${water}/${size}`, x, y, Math.max(9, Math.min(14, radius * 0.5)), paint.ink, '600');
  }
}

function drawLooterTarget(scene, body) {
  const { ctx, view, theme, match, moment } = scene;
  if (body.kind === 'tanker') return;
  const order = match.turn(moment.turn)?.commands?.[body.owner]?.[LOOTER_NAMES.indexOf(body.kind)];
  if (order?.x === undefined) return;
  const far = Math.hypot(order.x - body.x, order.y - body.y);
  const share = Math.min(1, 4 * body.radius / Math.max(1, far));      // only the direction counts
  ctx.strokeStyle = theme.team(body.owner);
  ctx.globalAlpha = 0.5;
  ctx.lineWidth = 1;
  ctx.setLineDash([5, 5]);
  ctx.beginPath();
  moveTo(ctx, view, body.x, body.y);
  lineTo(ctx, view, body.x + (order.x - body.x) * share, body.y + (order.y - body.y) * share);
  ctx.stroke();
  ctx.setLineDash([]);
  ctx.globalAlpha = 1;
}
