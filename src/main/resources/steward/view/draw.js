// Strokes that every drawing needs: circles, words, lines in units of the field, and pictures that are drawn once.

export const FONT = 'ui-sans-serif, system-ui, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif';
export const TAU = 2 * Math.PI;
const OUTSIDE = 40;             // pixels: words this far out of view are not moved into it

/**
 * Words around a point, readable on any ground; given a view, they are moved into it from its edge.
 * @param {any} scene
 */
export function write(scene, words, x, y, size, colour, weight = '400') {
  const { ctx, paint, view } = scene;
  ctx.font = `${weight} ${size}px ${FONT}`;
  if (view) {
    if (x < -OUTSIDE || y < -OUTSIDE || x > view.width + OUTSIDE || y > view.height + OUTSIDE) return;
    const half = ctx.measureText(words).width / 2 + 4;
    x = Math.max(half, Math.min(view.width - half, x));
    y = Math.max(size, Math.min(view.height - size, y));
  }
  ctx.textAlign = 'center';
  ctx.textBaseline = 'middle';
  ctx.lineJoin = 'round';
  ctx.lineWidth = Math.max(2.5, size / 4);
  ctx.strokeStyle = paint.halo;
  ctx.strokeText(words, x, y);
  ctx.fillStyle = colour;
  ctx.fillText(words, x, y);
}

export function captionSize(view) {
  return Math.max(9.5, Math.min(12, view.width / 60));
}

export function circle(ctx, x, y, radius) {
  ctx.beginPath();
  ctx.arc(x, y, Math.max(0, radius), 0, TAU);
}

export function moveTo(ctx, view, x, y) {
  ctx.moveTo(view.x(x), view.y(y));
}

export function lineTo(ctx, view, x, y) {
  ctx.lineTo(view.x(x), view.y(y));
}

/** Fills the form that was drawn last. */
export function fillWith(ctx, colour) {
  ctx.fillStyle = colour;
  ctx.fill();
}

/** Draws the line of the form that was drawn last. */
export function strokeWith(ctx, colour, width) {
  ctx.strokeStyle = colour;
  ctx.lineWidth = width;
  ctx.stroke();
}

/** Draws a straight line. */
export function strokeLine(ctx, fromX, fromY, toX, toY) {
  ctx.beginPath();
  ctx.moveTo(fromX, fromY);
  ctx.lineTo(toX, toY);
  ctx.stroke();
}

/** A gradient with its colours, each behind its share of the way. */
export function ramp(gradient, ...colours) {
  colours.forEach(([share, colour]) => gradient.addColorStop(share, colour));
  return gradient;
}

/** A closed form through corners [x, y], enlarged. */
export function polygon(ctx, corners, size) {
  ctx.beginPath();
  for (const [x, y] of corners) ctx.lineTo(x * size, y * size);
  ctx.closePath();
}

/** A regular form with a corner at the top. */
export function regular(ctx, x, y, radius, sides, turned = 0) {
  ctx.beginPath();
  for (let k = 0; k < sides; k++) {
    const angle = turned - Math.PI / 2 + k * TAU / sides;
    ctx.lineTo(x + radius * Math.cos(angle), y + radius * Math.sin(angle));
  }
  ctx.closePath();
}

/** A dashed line of a body's command, with a ring where it ends. */
export function targetLine({ ctx, view, theme }, body, x, y, hasEnd = true) {
  ctx.strokeStyle = theme.team(body.owner);
  ctx.globalAlpha = 0.75;
  ctx.lineWidth = 1.5;
  ctx.setLineDash([4, 4]);
  strokeLine(ctx, view.x(body.x), view.y(body.y), view.x(x), view.y(y));
  ctx.setLineDash([]);
  if (hasEnd) {
    circle(ctx, view.x(x), view.y(y), 4.5);
    ctx.stroke();
  }
  ctx.globalAlpha = 1;
}

/** A command that only gives a direction: a dashed line of four radii. */
export function directionLine(scene, body, x, y) {
  const far = Math.hypot(x - body.x, y - body.y);
  const share = Math.min(1, 4 * body.radius / Math.max(1e-9, far));
  targetLine(scene, body, body.x + (x - body.x) * share, body.y + (y - body.y) * share, share === 1);
}

/** A number 0..1 that follows from two whole numbers: decoration that is the same whenever one scrubs back. */
export function hash01(a, b) {
  let h = Math.imul(a + 0x9e3779b9, 0x85ebca6b) ^ Math.imul(b + 0x165667b1, 0xc2b2ae35);
  h = Math.imul(h ^ (h >>> 15), 0x2c1b3c6d);
  h = Math.imul(h ^ (h >>> 12), 0x297a2d39);
  return ((h ^ (h >>> 15)) >>> 0) / 4294967296;
}

/** Makes a canvas as sharp as the screen and empty; sizes are in CSS pixels. */
export function openCanvas(canvas) {
  const { width, height } = canvas.getBoundingClientRect();
  const ratio = devicePixelRatio || 1;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const ctx = canvas.getContext('2d');
  ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
  return { ctx, width, height };
}

/** Pictures of bodies, drawn once for each size and colour, then only copied. */
class Sprites {
  #made = new Map();
  #version = -1;

  /** The picture of a name in a radius of pixels; draw gets a context whose origin is its middle. */
  get(scene, name, radius, reach, draw) {
    if (this.#version !== scene.theme.version || this.#made.size > MOST_SPRITES) {
      this.#made.clear();
      this.#version = scene.theme.version;
    }
    const size = radius < 24 ? Math.max(1, Math.round(radius * 2) / 2) : Math.round(radius);
    let sizes = this.#made.get(name);
    if (!sizes) this.#made.set(name, sizes = new Map());
    let sprite = sizes.get(size);
    if (!sprite) {
      if (sizes.size > MOST_SIZES) sizes.clear();
      const half = Math.ceil(size * reach + 2);
      const ratio = devicePixelRatio || 1;
      const canvas = document.createElement('canvas');
      canvas.width = canvas.height = Math.ceil(2 * half * ratio);
      const ctx = canvas.getContext('2d');
      ctx.setTransform(ratio, 0, 0, ratio, half * ratio, half * ratio);
      draw(ctx, size);
      sprite = { canvas, half, size };
      sizes.set(size, sprite);
    }
    return sprite;
  }

  /** Puts a picture with its middle at a place; angle 0 is as it was drawn. */
  put(scene, name, x, y, radius, angle, reach, draw) {
    const sprite = this.get(scene, name, radius, reach, draw);
    const half = sprite.half * radius / sprite.size;
    const { ctx } = scene;
    if (!angle) {
      ctx.drawImage(sprite.canvas, x - half, y - half, 2 * half, 2 * half);
      return;
    }
    ctx.translate(x, y);
    ctx.rotate(angle);
    ctx.drawImage(sprite.canvas, -half, -half, 2 * half, 2 * half);
    ctx.rotate(-angle);
    ctx.translate(-x, -y);
  }
}
const MOST_SPRITES = 300;        // names
const MOST_SIZES = 60;

export const sprites = new Sprites();
