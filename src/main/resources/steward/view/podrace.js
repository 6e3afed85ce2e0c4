// The look of the pod race: pods with headings, flames and shields, checkpoints in their order, laps and who leads.

const BOOST_FLAME = 650;
const TURNING_TIME = 0.25;      // a pod turns at once when its turn begins; the eye is given a quarter of the turn
const SHIELD_TURNS = 4;
const DEGREES = 180 / Math.PI;
const WARNING_TURNS = 30;

const POD_RACE_LOOK = {
  drawGround(scene) {
    const zones = scene.match.header.drawing.zones;
    drawRoute(scene, zones);
    zones.forEach((zone, number) => drawCheckpoint(scene, zone, number));
  },

  drawBelow(scene) {
    if (scene.show.targets) scene.bodies.forEach(body => drawTarget(scene, body));
    scene.bodies.forEach(body => drawFlame(scene, body));
  },

  drawBody(scene, body) {
    drawPod(scene, body);
    drawShield(scene, body);
  },

  drawAbove(scene) {
    scene.bodies.forEach(body => drawPodLabels(scene, body));
  },

  /** Per player: rank, what to say, and the body that counts. */
  standing(match, number) {
    const zones = match.header.drawing.zones.length;
    const laps = match.header.scene.race.laps;
    const bests = match.players.map((_, player) => bestPod(match, match.turn(number), player));
    return bests.map((best, player) => ({
      rank: bests.filter(other => other.body && isAhead(other, best)).length,
      body: best.body?.id ?? null,
      big: `Lap ${Math.min(laps, Math.floor(best.passed / zones) + 1)}/${laps}`,
      small: `${best.passed} of ${laps * zones} checkpoints`,
      warning: warningOf(match.turn(number).state.turnsLeft?.[player]),
    }));
  },

  commandLines(command, player, match) {
    const pods = podsOf(match, player);
    return command.map((order, k) => `pod ${pods[k]}: (${plainNumber(order.x)}, ${plainNumber(order.y)}) `
      + (order.shield ? 'SHIELD' : order.boost ? 'BOOST' : `thrust ${order.thrust}`));
  },

  field(name, value) {
    if (name === 'heading') return value === null ? 'unset' : `${positiveDegrees(value).toFixed(1)}°`;
    if (name === 'boostLeft') return value ? 'yes' : 'used';
    return PLAIN_LOOK.field(name, value);
  },
};

LOOKS['pod-race'] = POD_RACE_LOOK;

function warningOf(turnsLeft) {
  return turnsLeft < WARNING_TURNS ? `${Math.max(0, turnsLeft)} turns left to a checkpoint` : '';
}

function positiveDegrees(radians) {
  return (radians * DEGREES % 360 + 360) % 360;
}

function podsOf(match, player) {
  return [...match.start.bodies.values()].filter(pod => pod.player === player).map(pod => pod.id);
}

/** The pod that has passed more checkpoints, then the one nearer to the next. */
function bestPod(match, turn, player) {
  const zones = match.header.drawing.zones;
  let best = { body: null, passed: 0, toNext: Infinity };
  for (const pod of turn.bodies.values()) {
    const next = zones[(pod.passed + 1) % zones.length];
    const candidate = { body: pod, passed: pod.passed, toNext: Math.hypot(next.x - pod.x, next.y - pod.y) };
    if (pod.player === player && (!best.body || isAhead(candidate, best))) best = candidate;
  }
  return best;
}

function isAhead(one, other) {
  return one.passed !== other.passed ? one.passed > other.passed : one.toNext < other.toNext;
}

/** What a pod was told for the turn shown, or null. */
function orderOf({ match, moment }, body) {
  const command = match.turn(moment.turn)?.commands?.[body.owner];
  return command ? command[podsOf(match, body.owner).indexOf(body.id)] ?? null : null;
}

/** The thrust that a pod really had in the turn shown. */
function thrustOf(scene, body) {
  const order = orderOf(scene, body);
  if (!order || order.shield || body.after.shieldTimer > 0) return 0;
  const most = scene.match.header.scene.pods.maximumThrust ?? 200;
  return order.boost ? (body.before.boostLeft ? BOOST_FLAME : most) : order.thrust;
}

/** Where a pod points to. */
function headingOf({ theme, moment }, body) {
  const to = body.after.heading;
  const from = body.before.heading ?? to;
  if (to === null) return null;
  const share = theme.isCalm ? 1 : Math.min(1, moment.fraction / TURNING_TIME);
  const turn = Math.atan2(Math.sin(to - from), Math.cos(to - from));
  return to - turn * (1 - share) ** 2;
}

/** Thin lines from checkpoint to checkpoint, with an arrow each. */
function drawRoute({ ctx, view, paint }, zones) {
  ctx.strokeStyle = paint.rim;
  ctx.fillStyle = paint.rim;
  ctx.lineWidth = 1.5;
  zones.forEach((zone, k) => {
    const next = zones[(k + 1) % zones.length];
    const angle = Math.atan2(next.y - zone.y, next.x - zone.x);
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    ctx.setLineDash([1.5, 7]);
    ctx.beginPath();
    moveTo(ctx, view, zone.x + cos * zone.radius, zone.y + sin * zone.radius);
    lineTo(ctx, view, next.x - cos * next.radius, next.y - sin * next.radius);
    ctx.stroke();
    ctx.setLineDash([]);
    drawArrow(ctx, view.x((zone.x + next.x) / 2), view.y((zone.y + next.y) / 2), angle);
  });
}

function drawArrow(ctx, x, y, angle) {
  ctx.save();
  ctx.translate(x, y);
  ctx.rotate(angle);
  ctx.beginPath();
  ctx.moveTo(7, 0);
  ctx.lineTo(-5, 5);
  ctx.lineTo(-2, 0);
  ctx.lineTo(-5, -5);
  ctx.closePath();
  ctx.fill();
  ctx.restore();
}

function drawCheckpoint(scene, zone, number) {
  const { ctx, view, paint } = scene;
  const [x, y, radius] = [view.x(zone.x), view.y(zone.y), zone.radius * view.scale];
  drawZone(scene, { ...zone, label: '' });
  if (number === 0) drawChequers(ctx, x, y, radius, paint);
  write({ ctx, paint }, zone.label, x, y, Math.max(11, radius * 0.75), paint.muted, '800');
  drawExpected(scene, zone, number);
}

/** The checkpoint where laps begin and end. */
function drawChequers(ctx, x, y, radius, paint) {
  const squares = 28;
  const thick = Math.max(2, radius * 0.09);
  ctx.strokeStyle = paint.muted;
  ctx.lineWidth = thick;
  for (const row of [0, 1]) {
    for (let k = row; k < squares; k += 2) {
      ctx.beginPath();
      ctx.arc(x, y, radius - thick * (row + 0.5), k * 2 * Math.PI / squares, (k + 1) * 2 * Math.PI / squares);
      ctx.lineCap = 'butt';
      ctx.stroke();
    }
  }
}

/** On the rim of a checkpoint: the pods that must pass it next, each in its own place. */
function drawExpected(scene, zone, number) {
  const { ctx, view, theme, match, moment } = scene;
  const zones = match.header.drawing.zones.length;
  const pods = [...match.turn(moment.settled).bodies.values()];
  pods.forEach((pod, k) => {
    const { owner, label } = match.describe(pod.id, pod);
    if ((pod.passed + 1) % zones !== number || !match.isIn(owner, moment.settled)) return;
    const size = Math.max(6, Math.min(9, view.scale * zone.radius * 0.3));
    const apart = (2 * size + 2) / (zone.radius * view.scale);
    const angle = -Math.PI / 2 + (k - (pods.length - 1) / 2) * apart;
    const x = view.x(zone.x + zone.radius * Math.cos(angle));
    const y = view.y(zone.y + zone.radius * Math.sin(angle));
    circle(ctx, x, y, size);
    ctx.fillStyle = theme.team(owner);
    ctx.fill();
    ctx.font = `700 ${Math.round(size * 1.4)}px ${FONT}`;
    ctx.textAlign = 'center';
    ctx.textBaseline = 'middle';
    ctx.fillStyle = scene.paint.field;
    ctx.fillText(label, x, y + 0.5);
  });
}

function drawTarget(scene, body) {
  const { ctx, view, theme } = scene;
  const order = orderOf(scene, body);
  if (!order) return;
  ctx.strokeStyle = theme.team(body.owner);
  ctx.globalAlpha = 0.5;
  ctx.lineWidth = 1;
  ctx.setLineDash([5, 5]);
  ctx.beginPath();
  moveTo(ctx, view, body.x, body.y);
  lineTo(ctx, view, order.x, order.y);
  ctx.stroke();
  ctx.setLineDash([]);
  ctx.beginPath();
  const [x, y] = [view.x(order.x), view.y(order.y)];
  ctx.moveTo(x - 5, y - 5);
  ctx.lineTo(x + 5, y + 5);
  ctx.moveTo(x - 5, y + 5);
  ctx.lineTo(x + 5, y - 5);
  ctx.stroke();
  ctx.globalAlpha = 1;
}

/** As long as the thrust is strong. */
function drawFlame(scene, body) {
  const { ctx, paint, theme, moment, turnsPerSecond } = scene;
  const thrust = thrustOf(scene, body);
  const heading = headingOf(scene, body);
  if (thrust <= 0 || heading === null) return;
  const flicker = theme.isCalm || !turnsPerSecond ? 1 : 1 + 0.08 * Math.sin(moment.time * 37 + body.id);
  const isBoost = thrust === BOOST_FLAME;
  const length = (0.5 + Math.min(2.6, thrust / 200 * (isBoost ? 0.8 : 1.1))) * flicker;
  withPod(scene, body, heading, radius => {
    ctx.globalCompositeOperation = theme.isDark ? 'lighter' : 'source-over';
    fillFlame(ctx, radius, 0.42, length, withAlpha(paint.flame, 0.8));
    fillFlame(ctx, radius, 0.22, 0.6 * length, paint.core);
  });
}

/** A drop with its round end at the pod's tail. */
function fillFlame(ctx, radius, width, length, colour) {
  const tail = -0.4 * radius;
  const tip = tail - length * radius;
  const glow = ctx.createLinearGradient(tail, 0, tip, 0);
  glow.addColorStop(0.25, colour);
  glow.addColorStop(1, withAlpha(colour, 0));
  ctx.fillStyle = glow;
  ctx.beginPath();
  ctx.moveTo(tail, -width * radius);
  const [near, middle] = [tail - 0.5 * length * radius, tail - 0.7 * length * radius];
  ctx.bezierCurveTo(near, -width * radius, middle, 0, tip, 0);
  ctx.bezierCurveTo(middle, 0, near, width * radius, tail, width * radius);
  ctx.fill();
}

/** Calls draw with the origin in the pod's centre and its heading to the right. */
function withPod({ ctx, view }, body, heading, draw) {
  ctx.save();
  ctx.translate(view.x(body.x), view.y(body.y));
  ctx.rotate(heading ?? 0);
  draw(body.radius * view.scale);
  ctx.restore();
}

/** The circle is the pod's true size; the hull inside differs between players also in form. */
function drawPod(scene, body) {
  const { ctx, theme, match, moment, paint } = scene;
  const isIn = match.isIn(body.owner, moment.turn);
  const colour = isIn ? theme.team(body.owner) : paint.muted;
  const heading = headingOf(scene, body);
  withPod(scene, body, heading, radius => {
    circle(ctx, 0, 0, radius);
    ctx.fillStyle = withAlpha(colour, 0.3);
    ctx.fill();
    ctx.strokeStyle = colour;
    ctx.lineWidth = Math.max(1, radius * 0.07);
    ctx.stroke();
    if (heading === null) circle(ctx, 0, 0, 0.55 * radius);
    else traceHull(ctx, radius, body.owner);
    ctx.fillStyle = colour;
    ctx.fill();
  });
}

function traceHull(ctx, radius, owner) {
  const arrow = [[0.94, 0], [0.1, 0.42], [-0.6, 0.66], [-0.42, 0], [-0.6, -0.66], [0.1, -0.42]];
  const fork = [[0.9, 0.2], [0.9, -0.2], [0.2, -0.3], [0.1, -0.72], [-0.65, -0.6], [-0.45, 0], [-0.65, 0.6],
    [0.1, 0.72], [0.2, 0.3]];
  ctx.beginPath();
  for (const [x, y] of owner % 2 === 0 ? arrow : fork) ctx.lineTo(x * radius, y * radius);
  ctx.closePath();
}

/** Around the pod while it is up; afterwards an arc counts down the turns without thrust. */
function drawShield(scene, body) {
  const { ctx, view, paint } = scene;
  const timer = body.after.shieldTimer;
  if (!timer) return;
  const radius = body.radius * view.scale;
  const isUp = Boolean(orderOf(scene, body)?.shield);
  ctx.strokeStyle = paint.shield;
  ctx.lineWidth = isUp ? Math.max(2.5, radius * 0.16) : Math.max(1.5, radius * 0.08);
  ctx.lineCap = 'butt';
  ctx.beginPath();
  const share = isUp ? 1 : timer / SHIELD_TURNS;
  ctx.arc(view.x(body.x), view.y(body.y), radius, -Math.PI / 2, -Math.PI / 2 + share * 2 * Math.PI);
  ctx.stroke();
  if (!isUp) return;
  circle(ctx, view.x(body.x), view.y(body.y), radius * 0.97);
  ctx.fillStyle = withAlpha(paint.shield, 0.25);
  ctx.fill();
}

function drawPodLabels(scene, body) {
  const { view, paint, theme, match, moment, show, standing } = scene;
  const radius = body.radius * view.scale;
  const [x, y] = [view.x(body.x), view.y(body.y)];
  write({ ctx: scene.ctx, paint }, body.label, x, y, Math.max(9, radius * 0.72), paint.ink, '800');
  if (!show.names) return;
  const words = [];
  const order = orderOf(scene, body);
  if (moment.settled > 0 && standing.some(each => each.rank === 0 && each.body === body.id)) words.push('1st');
  if (thrustOf(scene, body) === BOOST_FLAME) words.push('BOOST');
  if (order?.shield) words.push('SHIELD');
  if (!match.isIn(body.owner, moment.turn)) words.push('OUT');
  if (words.length) {
    write(scene, words.join(' · '), x, y + radius + 9, captionSize(view), theme.team(body.owner), '700');
  }
}
