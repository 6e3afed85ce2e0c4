// The field on its canvas. Everything here follows from what the game described; a look adds what is special to one.

import { Camera } from './camera.js';
import { captionSize, circle, fillWith, lineTo, moveTo, write } from './draw.js';
import { drawImpacts, drawMarks } from './effects.js';
import { Ground } from './ground.js';
import { drawRing } from './looks.js';
import { readNotes } from './notes.js';
import { drawTrails, drawVelocities } from './trails.js';

const GROWTH = 0.05;            // how far beyond the field the view may reach, as a share of it, and
const REACH = 0.4;              // how far for bodies of players, while they are out there
const LOOK_AHEAD = 3;           // turns before and after those in which the view makes room for them
const SMOOTH = 2;               // turns before and after over which it moves
const PICK_PIXELS = 14;         // a tap this near to a small body means it

export class Stage {
  view = new Camera();
  show = { trails: true, vectors: true, targets: false, impacts: true, notes: true, names: true };
  selected = null;
  hovered = null;
  numbers = [];                 // impulses drawn last, with their places
  #ground = new Ground();

  constructor(canvas, match, theme, look) {
    this.canvas = canvas;
    this.ctx = canvas.getContext('2d');
    this.match = match;
    this.theme = theme;
    this.look = look;
  }

  /** Makes the canvas as sharp as the screen; covered is the height of the strip at its top that hides it. */
  resize(covered = 0) {
    const { width, height } = this.canvas.getBoundingClientRect();
    this.pixelRatio = devicePixelRatio || 1;
    const [wide, high] = [Math.round(width * this.pixelRatio), Math.round(height * this.pixelRatio)];
    if (this.canvas.width !== wide || this.canvas.height !== high) Object.assign(this.canvas, { width: wide, height: high });
    if (this.match.header && width && height) this.view.resize(width, height, covered);
  }

  /** The field as the game declared it, or the box of all that moves where it did not. */
  get field() {
    const declared = this.match.header.drawing.field;
    const seen = this.match.extent();
    const { x, y, width, height } = declared ?? (seen.left < seen.right
      ? { x: seen.left, y: seen.top, width: seen.right - seen.left, height: seen.bottom - seen.top }
      : { x: 0, y: 0, width: 16, height: 9 });
    return { left: x, top: y, right: x + width, bottom: y + height, width, height };
  }

  /** What is seen as a whole at a time: the field, and who has left it; who goes farther is pointed at from the edge. */
  #boxAt(time) {
    const { match, field } = this;
    const [width, height] = [field.right - field.left, field.bottom - field.top];
    if (!match.players.length) return reaching(field, match.extent(), GROWTH * width, GROWTH * height);
    const base = this.look.focus?.(match) ?? field;
    const room = turn => {                                  // the largest of the turns around it, so that all are seen
      let box = base;
      for (let k = turn - LOOK_AHEAD; k <= turn + LOOK_AHEAD; k++) {
        if (k >= 0 && k <= match.lastTurn) box = around(box, this.#outlineOf(k));
      }
      return box;
    };
    const rooms = [];
    for (let k = Math.floor(time) - SMOOTH; k <= Math.floor(time) + 1 + SMOOTH; k++) rooms.push(room(k));
    const past = time - Math.floor(time);
    const mean = side => rooms.reduce((sum, box, k) =>
      sum + box[side] * (k === 0 ? 1 - past : k === rooms.length - 1 ? past : 1), 0) / (2 * SMOOTH + 1);
    const wanted = { left: mean('left'), top: mean('top'), right: mean('right'), bottom: mean('bottom') };
    return reaching(base, wanted, REACH * width, REACH * height);
  }

  /** The box around the ways of players' bodies through a turn. */
  #outlineOf(turn) {
    let box = this.#outlines[turn];
    if (!box) {
      box = NOTHING;
      for (const state of this.match.turn(turn).bodies.values()) {
        const { owner, radius } = this.match.describe(state.id, state);
        if (owner === null) continue;
        for (const [, x, y] of turn === 0 ? [[1, state.x, state.y]] : this.match.path(state.id, turn)) {
          box = around(box, { left: x - radius, top: y - radius, right: x + radius, bottom: y + radius });
        }
      }
      this.#outlines[turn] = box;
    }
    return box;
  }
  #outlines = [];

  /** Lets the camera move. Returns true while it is on its way. */
  advance(moment, seconds) {
    const { follow } = this.view;
    if (!this.view.isMoved) return this.view.isReturning && this.view.advance(seconds, [], this.theme.isCalm);
    const bodies = this.match.bodiesAt(moment);
    const leader = this.standing(moment)?.find(each => each.rank === 0)?.body;
    const wanted = follow === 'all' ? bodies.filter(body => body.owner !== null && body.owner !== undefined)
      : bodies.filter(body => body.id === (follow === 'selected' ? this.selected : leader));
    return this.view.advance(seconds, wanted, this.theme.isCalm);
  }

  /** Who is where at the end of the last whole turn. */
  standing(moment) {
    if (this.#standingTurn !== moment.settled) {
      this.#standing = this.look.standing(this.match, moment.settled);
      this.#standingTurn = moment.settled;
    }
    return this.#standing;
  }
  #standing = null;
  #standingTurn = -1;

  /** Draws the match at a moment; turnsPerSecond is 0 while it stands still. */
  draw(moment, turnsPerSecond) {
    const { ctx, look } = this;
    ctx.setTransform(this.pixelRatio, 0, 0, this.pixelRatio, 0, 0);
    if (!this.match.header || this.view.width <= 1) return;
    this.view.frame(this.#boxAt(moment.time));
    const scene = this.#scene(moment, turnsPerSecond);
    this.#ground.draw(scene, look, this.pixelRatio);
    if (this.show.trails) drawTrails(scene);
    look.drawBelow?.(scene);
    if (this.show.vectors) drawVelocities(scene);
    scene.bodies.forEach(body => look.drawBody(scene, body));
    this.#drawRings(scene);
    this.numbers = this.show.impacts ? drawImpacts(scene) : [];
    look.drawAbove?.(scene);
    drawMarks(scene);
    if (this.show.notes) this.#drawNotes(scene);
    scene.bodies.forEach(body => pointAtHidden(scene, body));
  }

  /** Everything that a drawing function needs to know. */
  #scene(moment, turnsPerSecond) {
    return { ctx: this.ctx, view: this.view, match: this.match, theme: this.theme, paint: this.theme.paint,
      show: this.show, moment, turnsPerSecond, bodies: this.match.bodiesAt(moment), field: this.field,
      fixed: this.match.fixedBodies(), standing: this.standing(moment), selected: this.selected };
  }

  #drawRings(scene) {
    if (this.selected === null && this.hovered === null) return;
    for (const body of scene.bodies) {
      if (body.id === this.selected || body.id === this.hovered) drawRing(scene, body, body.id === this.selected);
    }
  }

  #drawNotes(scene) {
    const turn = scene.match.turn(scene.moment.turn);
    (turn?.stderr ?? []).forEach((stderr, player) => {
      readNotes(stderr).shapes.forEach(shape => drawShape(scene, shape, player));
    });
  }

  /** The body at a place of the canvas, or null. */
  bodyAt(moment, x, y) {
    let best = null;
    let nearest = Infinity;
    for (const body of this.match.bodiesAt(moment)) {
      const far = Math.hypot(this.view.x(body.x) - x, this.view.y(body.y) - y);
      if (far <= Math.max(PICK_PIXELS, body.radius * this.view.scale) && far < nearest) [best, nearest] = [body, far];
    }
    return best;
  }
}

const NOTHING = { left: Infinity, top: Infinity, right: -Infinity, bottom: -Infinity };

function around(one, other) {
  return { left: Math.min(one.left, other.left), top: Math.min(one.top, other.top),
    right: Math.max(one.right, other.right), bottom: Math.max(one.bottom, other.bottom) };
}

/** The box around a field and more, which reaches at most so far beyond the field. */
function reaching(field, more, wide, high) {
  const box = around(field, more);
  return { left: Math.max(field.left - wide, box.left), top: Math.max(field.top - high, box.top),
    right: Math.min(field.right + wide, box.right), bottom: Math.min(field.bottom + high, box.bottom) };
}

/** A small arrow at the edge for a body that is out of view, or under the scores. */
function pointAtHidden({ ctx, view, paint, theme }, body) {
  const [x, y] = [view.x(body.x), view.y(body.y)];
  if (x >= 0 && x <= view.width && y >= view.covered && y <= view.height || body.owner === null) return;
  const atX = Math.min(view.width - 14, Math.max(14, x));
  const atY = Math.min(view.height - 14, Math.max(view.covered + 14, y));
  ctx.save();
  ctx.translate(atX, atY);
  ctx.rotate(Math.atan2(y - atY, x - atX));
  ctx.beginPath();
  ctx.moveTo(12, 0);
  ctx.lineTo(-6, 8);
  ctx.lineTo(-6, -8);
  fillWith(ctx, theme.team(body.owner));
  ctx.restore();
  write({ ctx, paint }, body.label, atX, atY, 10, paint.ink, '700');
}

function drawShape({ ctx, view, paint, theme }, shape, player) {
  ctx.strokeStyle = shape.colour ?? theme.team(player);
  ctx.lineWidth = 2;
  ctx.lineCap = 'butt';
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
