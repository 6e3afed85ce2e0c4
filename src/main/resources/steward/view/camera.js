// The camera: which part of the field is seen, and how large. It follows bodies, or stays where the hand put it.

export const FOLLOW_MODES = ['field', 'leader', 'selected', 'all'];
const RATE = 5;                 // per second, of the exponential approach
const MOST_ZOOM = 12;
const FOLLOW_ZOOM = 2.4;
const MARGIN = 14;              // pixels
const WHEEL = 0.0016;           // zoom per pixel of the wheel, as a power of e

export class Camera {
  scale = 1;
  offsetX = 0;
  offsetY = 0;
  width = 1;
  height = 1;
  follow = 'field';
  isHeld = false;               // moved by hand: it stays
  isReturning = false;          // on its way back to the whole
  covered = 0;                  // pixels at the top
  whole = null;
  box = null;

  x(units) {
    return this.offsetX + units * this.scale;
  }

  y(units) {
    return this.offsetY + units * this.scale;
  }

  /** The size of the canvas, and the strip at the top that is covered. */
  resize(width, height, covered) {
    Object.assign(this, { width, height, covered });
  }

  /** The box that is the whole now; unless it was moved, that is what is seen. */
  frame(box) {
    this.box = box;
    this.whole = this.#fit(box);
    if (!this.isMoved && !this.isReturning) this.#set(this.whole);
  }

  /** True if it does not show the whole field. */
  get isMoved() {
    return this.isHeld || this.follow !== 'field';
  }

  #fit(box) {
    const high = this.height - this.covered;
    const scale = Math.max(1e-9, Math.min((this.width - 2 * MARGIN) / (box.right - box.left),
      (high - 2 * MARGIN) / (box.bottom - box.top)));
    return this.#around((box.left + box.right) / 2, (box.top + box.bottom) / 2, scale);
  }

  #around(x, y, scale) {
    return { scale, offsetX: this.width / 2 - x * scale,
      offsetY: (this.height + this.covered) / 2 - y * scale };
  }

  #set({ scale, offsetX, offsetY }) {
    Object.assign(this, { scale, offsetX, offsetY });
  }

  /** Moves toward what is followed. Returns true while it is still on its way. */
  advance(seconds, bodies, isCalm) {
    if (this.isHeld) return false;
    const goal = this.#goal(bodies);
    const share = isCalm ? 1 : 1 - Math.exp(-RATE * seconds);
    const far = Math.max(Math.abs(goal.offsetX - this.offsetX), Math.abs(goal.offsetY - this.offsetY),
      1000 * Math.abs(goal.scale / this.scale - 1));
    if (far < 0.3) {
      this.isReturning = false;
      this.#set(goal);
      return false;
    }
    this.#set({ scale: this.scale + (goal.scale - this.scale) * share,
      offsetX: this.offsetX + (goal.offsetX - this.offsetX) * share,
      offsetY: this.offsetY + (goal.offsetY - this.offsetY) * share });
    return true;
  }

  #goal(bodies) {
    if (this.follow === 'field' || !bodies.length) return this.whole;
    if (this.follow !== 'all') return this.#around(bodies[0].x, bodies[0].y, this.whole.scale * FOLLOW_ZOOM);
    const room = 0.12 * (this.box.right - this.box.left);
    const goal = this.#fit({ left: Math.min(...bodies.map(body => body.x)) - room,
      right: Math.max(...bodies.map(body => body.x)) + room,
      top: Math.min(...bodies.map(body => body.y)) - room,
      bottom: Math.max(...bodies.map(body => body.y)) + room });
    if (goal.scale > this.whole.scale * 3) goal.scale = this.whole.scale * 3;
    return goal.scale < this.whole.scale ? this.whole : goal;
  }

  /** Zooms so that what is under the pointer stays there. */
  zoom(x, y, pixels) {
    const least = this.whole.scale * 0.5;
    const scale = Math.min(MOST_ZOOM * this.whole.scale, Math.max(least, this.scale * Math.exp(-WHEEL * pixels)));
    const ratio = scale / this.scale;
    this.#set({ scale, offsetX: x - (x - this.offsetX) * ratio, offsetY: y - (y - this.offsetY) * ratio });
    this.isHeld = true;
  }

  pan(dx, dy) {
    this.offsetX += dx;
    this.offsetY += dy;
    this.isHeld = true;
  }

  setFollow(mode) {
    this.isHeld = false;
    this.isReturning = mode === 'field';
    this.follow = mode;
  }
}
