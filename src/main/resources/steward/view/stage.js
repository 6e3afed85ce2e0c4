// The field on its canvas. Everything here follows from what the game described; a look adds what is special to one.

const TRAIL_TURNS = 12;
const TRAIL_TURNS_OF_CROWD = 2;
const CROWD = 40;
const FLASH_TURNS = 1.2;        // how long an impact stays in view
const FLASH_SECONDS = 0.15;     // and at least this long when turns fly by
const MARK_TURNS = 4;
const MARGIN_PIXELS = 10;
const GROWTH = 0.05;            // how far beyond the field the view may reach, as a share of it
const FONT = 'ui-sans-serif, system-ui, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif';

/** Where things of the field stand on the canvas, in CSS pixels. */
class View {
  scale = 1;
  offsetX = 0;
  offsetY = 0;

  /** Shows a box of the field as large as the canvas allows. */
  fit(box, width, height) {
    const wide = box.right - box.left;
    const high = box.bottom - box.top;
    this.scale = Math.max(1e-9, Math.min((width - 2 * MARGIN_PIXELS) / wide, (height - 2 * MARGIN_PIXELS) / high));
    this.offsetX = (width - this.scale * (box.left + box.right)) / 2;
    this.offsetY = (height - this.scale * (box.top + box.bottom)) / 2;
    this.width = width;
    this.height = height;
  }

  x(units) {
    return this.offsetX + units * this.scale;
  }

  y(units) {
    return this.offsetY + units * this.scale;
  }
}

class Stage {
  view = new View();
  show = { trails: true, targets: false, notes: true, names: true };

  constructor(canvas, match, theme, look) {
    this.canvas = canvas;
    this.ctx = canvas.getContext('2d');
    this.match = match;
    this.theme = theme;
    this.look = look;
  }

  /** Makes the canvas as sharp as the screen, and the field as large as fits. */
  resize() {
    const { width, height } = this.canvas.getBoundingClientRect();
    this.pixelRatio = devicePixelRatio || 1;
    this.canvas.width = Math.round(width * this.pixelRatio);
    this.canvas.height = Math.round(height * this.pixelRatio);
    if (this.match.header) this.view.fit(this.#box(), width, height);
  }

  get field() {
    const { x, y, width, height } = this.match.header.drawing.field;
    return { left: x, top: y, right: x + width, bottom: y + height, width, height };
  }

  /** The field, grown where bodies leave it, within bounds; who goes farther is pointed at from the edge. */
  #box() {
    const field = this.field;
    const seen = this.match.extent();
    const most = GROWTH * Math.min(field.width, field.height);
    return {
      left: Math.max(field.left - most, Math.min(field.left, seen.left)),
      top: Math.max(field.top - most, Math.min(field.top, seen.top)),
      right: Math.min(field.right + most, Math.max(field.right, seen.right)),
      bottom: Math.min(field.bottom + most, Math.max(field.bottom, seen.bottom)),
    };
  }

  /** Draws the match at a moment; turnsPerSecond is 0 while it stands still. */
  draw(moment, turnsPerSecond) {
    const ctx = this.ctx;
    ctx.setTransform(this.pixelRatio, 0, 0, this.pixelRatio, 0, 0);
    ctx.clearRect(0, 0, this.canvas.width, this.canvas.height);
    if (!this.match.header) return;
    const scene = this.#scene(moment, turnsPerSecond);
    this.#drawField(scene);
    this.look.drawGround(scene);
    this.#drawWalls(scene);
    if (this.show.trails) this.#drawTrails(scene);
    scene.fixed.forEach(body => drawFixed(scene, body));
    this.look.drawBelow?.(scene);
    scene.bodies.forEach(body => this.look.drawBody(scene, body));
    this.#drawImpacts(scene);
    this.look.drawAbove?.(scene);
    this.#drawMarks(scene);
    if (this.show.notes) this.#drawNotes(scene);
    scene.bodies.forEach(body => pointAtHidden(scene, body));
  }

  /** What a drawing function needs to know. */
  #scene(moment, turnsPerSecond) {
    return { ctx: this.ctx, view: this.view, match: this.match, theme: this.theme, paint: this.theme.paint,
      show: this.show, moment, turnsPerSecond, bodies: this.match.bodiesAt(moment),
      fixed: this.match.fixedBodies(), standing: this.look.standing(this.match, moment.settled) };
  }

  #drawField({ ctx, view, paint }) {
    const field = this.field;
    const size = view.scale;
    ctx.fillStyle = paint.field;
    ctx.fillRect(view.x(field.left), view.y(field.top), field.width * size, field.height * size);
    ctx.beginPath();
    const step = niceStep(field.width / 12);
    for (let x = Math.ceil(field.left / step) * step; x < field.right; x += step) {
      moveTo(ctx, view, x, field.top);
      lineTo(ctx, view, x, field.bottom);
    }
    for (let y = Math.ceil(field.top / step) * step; y < field.bottom; y += step) {
      moveTo(ctx, view, field.left, y);
      lineTo(ctx, view, field.right, y);
    }
    ctx.strokeStyle = paint.faint;
    ctx.lineWidth = 1;
    ctx.stroke();
    ctx.strokeStyle = paint.line;
    ctx.strokeRect(view.x(field.left), view.y(field.top), field.width * size, field.height * size);
  }

  #drawWalls({ ctx, view, paint, match }) {
    const walls = match.header.drawing.walls ?? match.header.scene.field?.walls ?? [];
    ctx.strokeStyle = paint.wall;
    ctx.lineWidth = 4;
    ctx.lineCap = 'round';
    for (const wall of Array.isArray(walls) ? walls : [walls]) {
      ctx.beginPath();
      traceWall(ctx, view, wall, this.field);
      ctx.stroke();
    }
  }

  #drawTrails({ ctx, view, theme, match, moment, bodies }) {
    const turns = bodies.length > CROWD ? TRAIL_TURNS_OF_CROWD : TRAIL_TURNS;
    ctx.lineCap = 'butt';
    for (const body of bodies) {
      const trail = trailOf(match, body.id, moment, turns);
      ctx.strokeStyle = theme.team(body.owner);
      for (let k = 1; k < trail.length; k++) {
        const age = (moment.time - trail[k][0]) / turns;
        ctx.globalAlpha = 0.6 * (1 - age) ** 2;
        ctx.lineWidth = Math.max(1, body.radius * view.scale * 0.3 * (1 - age));
        ctx.beginPath();
        moveTo(ctx, view, trail[k - 1][1], trail[k - 1][2]);
        lineTo(ctx, view, trail[k][1], trail[k][2]);
        ctx.stroke();
      }
    }
    ctx.globalAlpha = 1;
  }

  #drawImpacts(scene) {
    const { match, moment, turnsPerSecond } = scene;
    const life = Math.max(FLASH_TURNS, FLASH_SECONDS * turnsPerSecond);
    for (const { time, impact } of within(match.impacts, moment.time - life, moment.time)) {
      drawFlash(scene, impact, (moment.time - time) / life);
    }
  }

  #drawMarks(scene) {
    const { match, moment } = scene;
    const marks = within(match.events, moment.time - MARK_TURNS, moment.time);
    marks.forEach(({ time, event }, k) => {
      const age = (moment.time - time) / MARK_TURNS;
      const same = marks.slice(0, k).filter(mark => mark.event.x === event.x && mark.event.y === event.y).length;
      drawMark(scene, event, age, same);
    });
  }

  #drawNotes(scene) {
    const turn = scene.match.turn(scene.moment.turn);
    (turn?.stderr ?? []).forEach((stderr, player) => {
      readNotes(stderr).shapes.forEach(shape => drawShape(scene, shape, player));
    });
  }
}

/** The elements of a list sorted by time with from < time <= to. */
function within(list, from, to) {
  return list.slice(firstAfter(list, from), firstAfter(list, to));
}

/** Index of the first element after a time. */
function firstAfter(list, time) {
  let low = 0;
  let high = list.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (list[middle].time > time) high = middle;
    else low = middle + 1;
  }
  return low;
}

/** Where a body was in the last turns, corners included: [time, x, y]. */
function trailOf(match, id, moment, turns) {
  const from = Math.max(0, moment.time - turns);
  const trail = [];
  for (let number = Math.floor(from) + 1; number <= moment.turn; number++) {
    for (const [t, x, y] of match.path(id, number)) {
      const time = number - 1 + t;
      if (time >= from && time <= moment.time) trail.push([time, x, y]);
    }
  }
  const here = match.placeAt(id, moment);
  if (here) trail.push([moment.time, here.x, here.y]);
  return trail;
}

/** Where two bodies, or a body and a wall, touched. */
function contactOf(match, impact) {
  if (impact.wall !== undefined) return { x: impact.bx, y: impact.by };
  const a = match.describe(impact.a, match.start.bodies.get(impact.a)).radius;
  const b = match.describe(impact.b, match.start.bodies.get(impact.b)).radius;
  const share = a + b > 0 ? a / (a + b) : 0.5;
  return { x: impact.ax + (impact.bx - impact.ax) * share, y: impact.ay + (impact.by - impact.ay) * share };
}

/** A flash in units of the field: the stronger the impulse, the larger, against the strongest of the match. */
function flashRadius(match, impact) {
  const radius = match.describe(impact.a, match.start.bodies.get(impact.a)).radius;
  const strength = match.largestImpulse > 0 ? Math.abs(impact.impulse) / match.largestImpulse : 0;
  return radius * (0.5 + 1.5 * Math.sqrt(strength));
}

function drawFlash({ ctx, view, paint, match, theme, turnsPerSecond }, impact, age) {
  const { x, y } = contactOf(match, impact);
  const full = Math.max(8, flashRadius(match, impact) * view.scale);
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
  if (turnsPerSecond <= TURNS_PER_SECOND && age < 0.6) {
    write({ ctx, paint }, Math.round(Math.abs(impact.impulse)).toString(), 0, -radius - 8, 11, paint.ink, '600');
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

function drawMark({ ctx, view, paint, match, theme, show }, event, age, row) {
  const x = view.x(event.x);
  const y = view.y(event.y);
  const colour = theme.team(event.body === undefined ? null : match.ownerOf(event.body));
  const radius = event.body === undefined ? 0 : match.describe(event.body, match.start.bodies.get(event.body)).radius;
  const size = view.scale * Math.max(radius, 1) * (theme.isCalm ? 1.4 : 1.1 + age);
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
    write({ ctx, paint, view }, shape.words, view.x(shape.x), view.y(shape.y), 12, theme.team(player), '500');
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
    const far = 2 * Math.max(field.width, field.height) / Math.hypot(wall.insideX, wall.insideY);
    moveTo(ctx, view, wall.x - wall.insideY * far, wall.y + wall.insideX * far);
    lineTo(ctx, view, wall.x + wall.insideY * far, wall.y - wall.insideX * far);
  } else if (wall.ax !== undefined) {
    moveTo(ctx, view, wall.ax, wall.ay);
    lineTo(ctx, view, wall.bx, wall.by);
  }
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

/** How a game without a drawing module of its own looks. */
const PLAIN_LOOK = {
  drawGround(scene) {
    (scene.match.header.drawing.zones ?? []).forEach(zone => drawZone(scene, zone));
  },
  drawBody: drawDisc,
  standing: () => null,
  commandLines: command => [JSON.stringify(command)],
  field: (name, value) => (typeof value === 'number' ? plainNumber(value) : String(value)),
};

function plainNumber(value) {
  return Number.isInteger(value) ? String(value) : value.toFixed(3);
}
