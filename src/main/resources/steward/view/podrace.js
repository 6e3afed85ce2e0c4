// The look of the pod race: pods with headings, exhaust and shields on their course, laps and who leads.

import { drawDue, paintCourse, progressOf } from './course.js';
import { captionSize, circle, fillWith, targetLine, write } from './draw.js';
import { putShip } from './hulls.js';
import { addLook, PLAIN_LOOK } from './looks.js';
import { plainNumber } from './text.js';
import { withAlpha } from './theme.js';
import { drawExhaust } from './trails.js';

const BOOST = 650;
const TURNING_TIME = 0.25;      // a pod turns at once when its turn begins; the eye is given a quarter of the turn
const SHIELD_TURNS = 4;
const WARNING_TURNS = 30;

addLook('pod-race', {
  leadName: 'checkpoints',
  drawGround: paintCourse,

  drawBelow(scene) {
    const { match, moment, bodies, show, selected } = scene;
    drawDue(scene, [...match.turn(moment.settled).bodies.values()].map(pod => ({ ...match.describe(pod.id, pod), ...pod }))
      .filter(pod => match.isIn(pod.owner, moment.settled)));
    for (const body of bodies) {
      const order = orderOf(match, moment.turn, body);
      if (order && (show.targets || body.id === selected)) targetLine(scene, body, order.x, order.y);
      const heading = headingOf(scene, body);
      if (heading !== null) drawExhaust(scene, body, heading, thrustOf(scene, body) / 200);
    }
  },

  drawBody(scene, body) {
    putShip(scene, body, headingOf(scene, body) ?? 0, scene.match.isIn(body.owner, scene.moment.turn));
    drawShield(scene, body);
  },

  drawAbove(scene) {
    scene.bodies.forEach(body => drawPodLabel(scene, body));
  },

  progress: (match, number) => match.players.map((_, player) => {
    const best = bestPod(match, number, player);
    return best ? progressOf(match.header.drawing.zones, best) : 0;
  }),

  standing(match, number) {
    const zones = match.header.drawing.zones;
    const laps = match.header.scene.race.laps;
    const bests = match.players.map((_, player) => bestPod(match, number, player));
    const turnsLeft = match.turn(number).state.turnsLeft ?? [];
    return bests.map((best, player) => ({
      rank: bests.filter(other => other && best && isAhead(zones, other, best)).length,
      body: best?.id ?? null,
      big: `Lap ${Math.min(laps, Math.floor((best?.passed ?? 0) / zones.length) + 1)}/${laps}`,
      small: `${best?.passed ?? 0} of ${laps * zones.length} checkpoints`,
      pips: { groups: laps, each: zones.length, done: best ? progressOf(zones, best) : 0 },
      warning: warningOf(turnsLeft[player]),
    }));
  },

  commandLines(command, player, match) {
    const pods = podsOf(match, player);
    return command.map((order, k) => `pod ${pods[k]}: ${orderWords(order)}`);
  },

  commandOf(body, match, turn) {
    const order = orderOf(match, turn, body);
    return order ? orderWords(order) : '';
  },

  field(name, value) {
    if (name === 'heading') return value === null ? 'unset' : `${positiveDegrees(value).toFixed(1)}°`;
    if (name === 'boostLeft') return value ? 'yes' : 'used';
    return PLAIN_LOOK.field(name, value);
  },
});

function orderWords(order) {
  if (!order) return 'nothing';
  return `(${plainNumber(order.x)}, ${plainNumber(order.y)}) `
    + (order.shield ? 'SHIELD' : order.boost ? 'BOOST' : `thrust ${order.thrust}`);
}

function warningOf(turnsLeft) {
  return turnsLeft < WARNING_TURNS ? `${Math.max(0, turnsLeft)} turns left to a checkpoint` : '';
}

export function positiveDegrees(radians) {
  return (radians * 180 / Math.PI % 360 + 360) % 360;
}

/** The ids of a player's pods, in the order of its commands. */
function podsOf(match, player) {
  let pods = PODS.get(match);
  if (!pods) {
    pods = match.players.map((_, each) =>
      [...match.start.bodies.values()].filter(pod => pod.player === each).map(pod => pod.id));
    PODS.set(match, pods);
  }
  return pods[player];
}
const PODS = new WeakMap();

/** The pod that has passed more checkpoints, then the one nearer to the next. */
function bestPod(match, number, player) {
  const zones = match.header.drawing.zones;
  let best = null;
  for (const pod of match.turn(number).bodies.values()) {
    if (pod.player === player && (!best || isAhead(zones, pod, best))) best = pod;
  }
  return best;
}

function isAhead(zones, one, other) {
  if (one.passed !== other.passed) return one.passed > other.passed;
  const next = zones[(one.passed + 1) % zones.length];
  return Math.hypot(next.x - one.x, next.y - one.y) < Math.hypot(next.x - other.x, next.y - other.y);
}

/** The command of a pod in a turn, or null. */
function orderOf(match, number, body) {
  const command = number === 0 ? null : match.turn(number)?.commands?.[body.owner];
  return command?.[podsOf(match, body.owner).indexOf(body.id)] ?? null;
}

/** The thrust that a pod really had in the turn shown. */
function thrustOf({ match, moment }, body) {
  const order = orderOf(match, moment.turn, body);
  if (!order || order.shield || body.after.shieldTimer > 0) return 0;
  const most = match.header.scene.pods?.maximumThrust ?? 200;
  return order.boost ? (body.before.boostLeft ? BOOST : most) : order.thrust;
}

/** The heading of a pod for the eye: it turns in the first quarter of a turn, ever slower. */
export function headingOf({ theme, moment }, body) {
  const to = body.after.heading;
  const from = body.before.heading ?? to;
  if (to === null || to === undefined) return null;
  const share = theme.isCalm ? 1 : Math.min(1, moment.fraction / TURNING_TIME);
  const turn = Math.atan2(Math.sin(to - from), Math.cos(to - from));
  return to - turn * (1 - share) ** 2;
}

/** A shield around the pod while it is up; afterwards an arc counts down the turns without thrust. */
function drawShield(scene, body) {
  const { ctx, view, paint, match, moment } = scene;
  const timer = body.after.shieldTimer;
  if (!timer) return;
  const radius = body.radius * view.scale * 1.12;
  const [x, y] = [view.x(body.x), view.y(body.y)];
  const isUp = Boolean(orderOf(match, moment.turn, body)?.shield);
  ctx.strokeStyle = paint.shield;
  ctx.lineWidth = isUp ? Math.max(2.5, radius * 0.13) : Math.max(1.5, radius * 0.08);
  ctx.lineCap = 'butt';
  ctx.beginPath();
  ctx.arc(x, y, radius, -Math.PI / 2, -Math.PI / 2 + (isUp ? 1 : timer / SHIELD_TURNS) * 2 * Math.PI);
  ctx.stroke();
  if (!isUp) return;
  circle(ctx, x, y, radius);
  fillWith(ctx, withAlpha(paint.shield, 0.22));
}

function drawPodLabel(scene, body) {
  const { view, theme, match, moment, show, standing } = scene;
  const radius = body.radius * view.scale;
  const words = [body.label];
  if (show.names) {
    if (moment.settled > 0 && standing.some(each => each.rank === 0 && each.body === body.id)) words.push('♛');
    if (thrustOf(scene, body) === BOOST) words.push('BOOST');
    if (orderOf(match, moment.turn, body)?.shield) words.push('SHIELD');
    if (!match.isIn(body.owner, moment.turn)) words.push('OUT');
  }
  write(scene, words.join(' '), view.x(body.x), view.y(body.y) + radius + 11, captionSize(view) + 1,
    theme.team(body.owner), '700');
}
