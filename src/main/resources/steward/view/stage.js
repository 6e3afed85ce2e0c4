// The field on its canvas. Everything here follows from what the game described; a look adds what is special to one.

const TRAIL_TURNS = 12;
const TRAIL_TURNS_OF_CROWD = 2;
const CROWD = 40;
const FLASH_TURNS = 1.2;        // how long an impact stays in view
const FLASH_SECONDS = 0.15;     // and at least this long when turns fly by
const MARK_TURNS = 4;
const MARGIN_PIXELS = 10;
const GROWTH = 0.05;            // how far beyond the field the view may reach, as a share of it

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
    for (const met of within(match.impacts, moment.time - life, moment.time)) {
      drawFlash(scene, met, (moment.time - met.time) / life);
    }
  }

  #drawMarks(scene) {
    const { match, moment } = scene;
    const marks = within(match.events, moment.time - MARK_TURNS, moment.time);
    marks.forEach((mark, k) => {
      const age = (moment.time - mark.time) / MARK_TURNS;
      const { x, y } = mark.event;
      drawMark(scene, mark, age, marks.slice(0, k).filter(({ event }) => event.x === x && event.y === y).length);
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

/** How games look, by the id of a game; the drawing module of each adds its own. */
const LOOKS = {};

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
