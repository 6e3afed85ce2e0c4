// How single things are drawn: flashes, marks, bodies, zones, walls, bots' shapes and words. A scene is what a
// drawing function needs to know: context, view, theme, match, moment and bodies (see Stage).

const FONT = 'ui-sans-serif, system-ui, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif';

/** Where two bodies, or a body and a wall, touched in a turn. */
function contactOf(match, { impact, turn }) {
  if (impact.wall !== undefined) return { x: impact.bx ?? impact.ax, y: impact.by ?? impact.ay };
  const a = match.describeIn(impact.a, turn).radius;
  const b = match.describeIn(impact.b, turn).radius;
  const share = a + b > 0 ? a / (a + b) : 0.5;
  return { x: impact.ax + (impact.bx - impact.ax) * share, y: impact.ay + (impact.by - impact.ay) * share };
}

/** A flash in units of the field: the stronger the impulse, the larger, against the strongest of the match. */
function flashRadius(match, { impact, turn }) {
  const radius = match.describeIn(impact.a, turn).radius;
  const strength = match.largestImpulse > 0 ? Math.abs(impact.impulse ?? 0) / match.largestImpulse : 0;
  return radius * (0.5 + 1.5 * Math.sqrt(strength));
}

function drawFlash({ ctx, view, paint, match, theme, turnsPerSecond }, met, age) {
  const { x, y } = contactOf(match, met);
  const full = Math.max(8, flashRadius(match, met) * view.scale);
  const radius = theme.isCalm ? full : full * (0.55 + 0.45 * Math.sqrt(age));
  ctx.save();
  ctx.translate(view.x(x), view.y(y));
  ctx.globalAlpha = (1 - age) ** 1.5;
  const glow = ctx.createRadialGradient(0, 0, 0, 0, 0, radius);
  glow.addColorStop(0, paint.flash);
  glow.addColorStop(0.35, withAlpha(paint.flash, 0.55));
  glow.addColorStop(1, withAlpha(paint.flash, 0));
  ctx.fillStyle = glow;
  circle(ctx, 0, 0, radius);
  ctx.fill();
  ctx.strokeStyle = paint.flash;
  ctx.lineWidth = 1.5;
  circle(ctx, 0, 0, radius);
  ctx.stroke();
  traceRays(ctx, radius);
  ctx.stroke();
  if (turnsPerSecond <= TURNS_PER_SECOND && age < 0.6 && met.impact.impulse !== undefined) {
    write({ ctx, paint }, Math.round(Math.abs(met.impact.impulse)).toString(), 0, -radius - 8, 11, paint.ink, '600');
  }
  ctx.restore();
}

function traceRays(ctx, radius) {
  ctx.beginPath();
  for (let ray = 0; ray < 8; ray++) {
    const angle = (ray + 0.5) * Math.PI / 4;
    ctx.moveTo(0.75 * radius * Math.cos(angle), 0.75 * radius * Math.sin(angle));
    ctx.lineTo(1.2 * radius * Math.cos(angle), 1.2 * radius * Math.sin(angle));
  }
}

function drawMark({ ctx, view, paint, match, theme, show }, { event, turn }, age, row) {
  const body = event.body === undefined ? null : match.describeIn(event.body, turn);
  const x = view.x(event.x);
  const y = view.y(event.y);
  const colour = theme.team(body?.owner ?? null);
  const size = view.scale * Math.max(body?.radius ?? 0, 1) * (theme.isCalm ? 1.4 : 1.1 + age);
  ctx.globalAlpha = (1 - age) ** 2;
  ctx.strokeStyle = colour;
  ctx.lineWidth = 2;
  circle(ctx, x, y, Math.max(6, size));
  ctx.stroke();
  if (event.text && show.names) {
    write({ ctx, paint, view }, shorten(event.text, MOST_WORDS), x, y - Math.max(18, size + 10) - 15 * row,
      captionSize(view), colour, '600');
  }
  ctx.globalAlpha = 1;
}

/** A body of no special look: a disc with its label. */
function drawDisc({ ctx, view, paint, theme }, body) {
  const x = view.x(body.x);
  const y = view.y(body.y);
  const radius = Math.max(2, body.radius * view.scale);
  const colour = theme.team(body.owner);
  circle(ctx, x, y, radius);
  ctx.fillStyle = withAlpha(colour, 0.75);
  ctx.fill();
  ctx.strokeStyle = colour;
  ctx.lineWidth = 1.5;
  ctx.stroke();
  if (radius >= 6) write({ ctx, paint }, body.label, x, y, Math.max(9, radius * 0.8), paint.ink, '700');
}

/** Something in the way that never moves. */
function drawFixed({ ctx, view, paint }, body) {
  const x = view.x(body.x);
  const y = view.y(body.y);
  const radius = body.radius * view.scale;
  circle(ctx, x, y, radius);
  ctx.fillStyle = paint.ground;
  ctx.fill();
  ctx.strokeStyle = paint.wall;
  ctx.lineWidth = 4;
  ctx.stroke();
  ctx.lineWidth = 1.5;
  circle(ctx, x, y, radius * 0.6);
  ctx.stroke();
  if (body.label) write({ ctx, paint }, body.label, x, y, Math.max(9, radius * 0.5), paint.muted, '600');
}

function drawZone({ ctx, view, paint }, zone) {
  circle(ctx, view.x(zone.x), view.y(zone.y), zone.radius * view.scale);
  ctx.fillStyle = paint.zone;
  ctx.fill();
  ctx.strokeStyle = paint.rim;
  ctx.lineWidth = 1.5;
  ctx.stroke();
  if (zone.label) {
    write({ ctx, paint }, zone.label, view.x(zone.x), view.y(zone.y),
      Math.max(10, zone.radius * view.scale * 0.7), paint.muted, '700');
  }
}

/** A small arrow at the edge for a body that is out of view. */
function pointAtHidden({ ctx, view, paint, theme }, body) {
  const x = view.x(body.x);
  const y = view.y(body.y);
  if (x >= 0 && x <= view.width && y >= 0 && y <= view.height) return;
  const atX = Math.min(view.width - 14, Math.max(14, x));
  const atY = Math.min(view.height - 14, Math.max(14, y));
  ctx.save();
  ctx.translate(atX, atY);
  ctx.rotate(Math.atan2(y - atY, x - atX));
  ctx.beginPath();
  ctx.moveTo(12, 0);
  ctx.lineTo(-6, 8);
  ctx.lineTo(-6, -8);
  ctx.fillStyle = theme.team(body.owner);
  ctx.fill();
  ctx.restore();
  write({ ctx, paint }, body.label, atX, atY, 10, paint.ink, '700');
}

function drawShape({ ctx, view, paint, theme }, shape, player) {
  const colour = shape.colour ?? theme.team(player);
  ctx.strokeStyle = colour;
  ctx.lineWidth = 1.5;
  if (shape.kind === 'text') {
    write({ ctx, paint, view }, shape.words, view.x(shape.x), view.y(shape.y), captionSize(view),
      theme.team(player), '500');
    return;
  }
  if (shape.kind === 'line') {
    ctx.beginPath();
    moveTo(ctx, view, shape.x1, shape.y1);
    lineTo(ctx, view, shape.x2, shape.y2);
  } else {
    circle(ctx, view.x(shape.x), view.y(shape.y), shape.radius * view.scale);
  }
  ctx.stroke();
}

/** Walls as a scene writes them: a box, segments, half-planes, arenas. */
function traceWall(ctx, view, wall, field) {
  if (wall === 'box' || wall.type === 'box') {
    ctx.rect(view.x(field.left), view.y(field.top), field.width * view.scale, field.height * view.scale);
  } else if (wall.radius !== undefined) {
    circle(ctx, view.x(wall.x), view.y(wall.y), wall.radius * view.scale);
  } else if (wall.insideX !== undefined) {
    const [from, to] = partWithin(field, wall.x, wall.y, -wall.insideY, wall.insideX);
    if (from > to) return;
    moveTo(ctx, view, wall.x - wall.insideY * from, wall.y + wall.insideX * from);
    lineTo(ctx, view, wall.x - wall.insideY * to, wall.y + wall.insideX * to);
  } else if (wall.ax !== undefined) {
    moveTo(ctx, view, wall.ax, wall.ay);
    lineTo(ctx, view, wall.bx, wall.by);
  }
}

/** The part of a straight line that is in the field, edges included: from and to, in steps (dx, dy) from (x, y). */
function partWithin(field, x, y, dx, dy) {
  let [from, to] = [-Infinity, Infinity];
  for (const [at, step, low, high] of [[x, dx, field.left, field.right], [y, dy, field.top, field.bottom]]) {
    if (step === 0) {
      if (at < low || at > high) return [1, 0];
    } else {
      const [one, other] = [(low - at) / step, (high - at) / step];
      from = Math.max(from, Math.min(one, other));
      to = Math.min(to, Math.max(one, other));
    }
  }
  return [from, to];
}

/** Words around a point, readable on any ground; given a view, they are moved into it. */
function write({ ctx, paint, view }, words, x, y, size, colour, weight = '400') {
  ctx.font = `${weight} ${size}px ${FONT}`;
  if (view) {
    const half = ctx.measureText(words).width / 2 + 4;
    x = Math.max(half, Math.min(view.width - half, x));
    y = Math.max(size, Math.min(view.height - size, y));
  }
  ctx.textAlign = 'center';
  ctx.textBaseline = 'middle';
  ctx.lineJoin = 'round';
  ctx.lineWidth = Math.max(2, size / 5);
  ctx.strokeStyle = paint.halo;
  ctx.strokeText(words, x, y);
  ctx.fillStyle = colour;
  ctx.fillText(words, x, y);
}

function captionSize(view) {
  return Math.max(9, Math.min(12, view.width / 60));
}

function circle(ctx, x, y, radius) {
  ctx.beginPath();
  ctx.arc(x, y, Math.max(0, radius), 0, 2 * Math.PI);
}

function moveTo(ctx, view, x, y) {
  ctx.moveTo(view.x(x), view.y(y));
}

function lineTo(ctx, view, x, y) {
  ctx.lineTo(view.x(x), view.y(y));
}

/** 1, 2 or 5 times a power of ten, at least as large as asked for. */
function niceStep(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].find(factor => factor * power >= least) * power;
}

/** A computed colour, "rgb(...)" or "#rrggbb", made see-through. */
function withAlpha(colour, alpha) {
  return `color-mix(in srgb, ${colour} ${Math.round(100 * alpha)}%, transparent)`;
}
