// The ground: sky, stars, field, zones and walls. It is drawn once for each camera, then only copied.

import { circle, fillWith, hash01, lineTo, moveTo, ramp, strokeWith, TAU, write } from './draw.js';
import { niceStep } from './ticks.js';
import { withAlpha } from './theme.js';

const STARS = 170;

export class Ground {
  #canvas = document.createElement('canvas');
  #key = '';

  /** Copies the ground below everything; draws it anew where the camera or the colours have changed. */
  draw(scene, look, pixelRatio) {
    const { view, theme } = scene;
    const key = [view.width, view.height, view.scale, view.offsetX, view.offsetY, theme.version, pixelRatio].join();
    if (key !== this.#key) {
      this.#key = key;
      this.#paint(scene, look, pixelRatio);
    }
    scene.ctx.drawImage(this.#canvas, 0, 0, view.width, view.height);
  }

  #paint(scene, look, pixelRatio) {
    const { view } = scene;
    this.#canvas.width = Math.max(1, Math.round(view.width * pixelRatio));
    this.#canvas.height = Math.max(1, Math.round(view.height * pixelRatio));
    const ctx = this.#canvas.getContext('2d');
    ctx.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0);
    const own = { ...scene, ctx };
    paintSky(own);
    if (look.drawGround) look.drawGround(own);
    else paintPlain(own);
    paintWalls(own);
    scene.fixed.forEach(body => paintFixed(own, body));
  }
}

function paintSky({ ctx, view, paint, theme }) {
  const { width, height } = view;
  const [x, y, far] = [width / 2, height / 2, 0.62 * Math.hypot(width, height)];
  const sky = ramp(ctx.createRadialGradient(x, y, 0, x, y, far),
    [0, paint.sky], [0.6, paint.field], [1, paint.abyss]);
  ctx.fillStyle = sky;
  ctx.fillRect(0, 0, width, height);
  if (!theme.isDark) return;
  for (let k = 0; k < STARS; k++) {
    ctx.globalAlpha = 0.12 + 0.4 * hash01(k, 3);
    ctx.fillStyle = paint.muted;
    circle(ctx, hash01(k, 1) * width, hash01(k, 2) * height, 0.4 + 0.7 * hash01(k, 4));
    ctx.fill();
  }
  ctx.globalAlpha = 1;
}

/** The edge of the field, and a grid where a game asks for one. */
export function paintFrame({ ctx, view, paint, field }, hasGrid = false) {
  const size = view.scale;
  if (hasGrid) {
    ctx.beginPath();
    const step = niceStep(field.width / 16);
    for (let x = Math.ceil(field.left / step) * step; x < field.right; x += step) {
      moveTo(ctx, view, x, field.top);
      lineTo(ctx, view, x, field.bottom);
    }
    for (let y = Math.ceil(field.top / step) * step; y < field.bottom; y += step) {
      moveTo(ctx, view, field.left, y);
      lineTo(ctx, view, field.right, y);
    }
    strokeWith(ctx, paint.faint, 1);
  }
  ctx.strokeStyle = paint.line;
  ctx.lineWidth = 1;
  ctx.strokeRect(view.x(field.left) + 0.5, view.y(field.top) + 0.5, field.width * size, field.height * size);
}

/** The ground of a game without one of its own: frame, grid, and the zones it declares. */
export function paintPlain(scene) {
  if (!scene.match.header.drawing.field) return;
  paintFrame(scene, true);
  (scene.match.header.drawing.zones ?? []).forEach(zone => paintZone(scene, zone));
}

export function paintZone({ ctx, view, paint }, zone) {
  const [x, y, radius] = [view.x(zone.x), view.y(zone.y), zone.radius * view.scale];
  circle(ctx, x, y, radius);
  const disc = ramp(ctx.createRadialGradient(x, y, 0, x, y, Math.max(1, radius)),
    [0, withAlpha(paint.abyss, 0.5)], [1, paint.zone]);
  fillWith(ctx, disc);
  strokeWith(ctx, paint.rim, 1.75);
  if (zone.label) write({ ctx, paint }, zone.label, x, y, Math.max(11, radius * 0.66), paint.muted, '700');
}

function paintWalls({ ctx, view, paint, match, field }) {
  const walls = match.header.drawing.walls ?? match.header.scene?.field?.walls ?? [];
  ctx.lineCap = 'round';
  for (const [colour, width] of [[withAlpha(paint.wall, 0.25), 9], [paint.wall, 3.5]]) {
    ctx.strokeStyle = colour;
    ctx.lineWidth = width;
    for (const wall of Array.isArray(walls) ? walls : [walls]) {
      ctx.beginPath();
      traceWall(ctx, view, wall, field);
      ctx.stroke();
    }
  }
}

/** Something in the way that never moves. */
function paintFixed({ ctx, view, paint }, body) {
  const [x, y, radius] = [view.x(body.x), view.y(body.y), body.radius * view.scale];
  const dome = ramp(ctx.createRadialGradient(x - radius * 0.3, y - radius * 0.35, 0, x, y, Math.max(1, radius)),
    [0, withAlpha(paint.wall, 0.75)], [1, withAlpha(paint.wall, 0.2)]);
  circle(ctx, x, y, radius);
  fillWith(ctx, paint.abyss);
  fillWith(ctx, dome);
  strokeWith(ctx, paint.wall, 3);
  ctx.lineWidth = 1.5;
  circle(ctx, x, y, radius * 0.62);
  ctx.stroke();
  if (body.label) write({ ctx, paint }, body.label, x, y, Math.max(9, radius * 0.5), paint.muted, '600');
}

/** Walls as a scene writes them: a box, segments, half-planes, arenas. */
function traceWall(ctx, view, wall, field) {
  if (wall === 'box' || wall.type === 'box') {
    ctx.rect(view.x(field.left), view.y(field.top), field.width * view.scale, field.height * view.scale);
  } else if (wall.radius !== undefined) {
    ctx.arc(view.x(wall.x), view.y(wall.y), wall.radius * view.scale, 0, TAU);
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
