// The scrub bar: a range input over a strip of marks for impacts, marks of the game and faults.

const THUMB = 14;               // the width of the range input's thumb, as in the style sheet
const LANE_IMPACTS = 0.28;
const LANE_MARKS = 0.72;
const LANE_FAULTS = 0.2;

class Timeline {
  constructor(canvas, range, match, theme, onSeek) {
    this.canvas = canvas;
    this.range = range;
    this.match = match;
    this.theme = theme;
    range.addEventListener('input', () => onSeek(Number(range.value)));
  }

  /** Shows a time; the strip is drawn anew by draw(). */
  move(time) {
    this.range.max = String(this.match.lastTurn);
    this.range.value = String(time);
    this.range.setAttribute('aria-valuetext', `turn ${Math.ceil(time)} of ${this.match.lastTurn}`);
  }

  draw() {
    const { ctx, width, height } = openCanvas(this.canvas);
    this.toX = time => THUMB / 2 + (width - THUMB) * (this.match.lastTurn ? time / this.match.lastTurn : 0);
    ctx.fillStyle = this.theme.paint.line;
    ctx.fillRect(THUMB / 2, height / 2 - 1, width - THUMB, 2);
    this.#drawImpacts(ctx, height);
    this.#drawMarks(ctx, height);
    this.#drawFaults(ctx, height);
  }

  #drawImpacts(ctx, height) {
    ctx.fillStyle = this.theme.paint.flash;
    for (const { time, impact } of this.match.impacts) {
      const strength = Math.sqrt(Math.abs(impact.impulse) / this.match.largestImpulse || 0);
      const high = height * LANE_IMPACTS * (0.3 + 0.7 * strength);
      ctx.fillRect(this.toX(time) - 0.75, height / 2 - 3 - high, 1.5, high);
    }
  }

  #drawMarks(ctx, height) {
    for (const { time, turn, event } of this.match.events) {
      const owner = event.body === undefined ? null : this.match.describeIn(event.body, turn).owner;
      const row = owner === null ? 0 : owner % 3;
      ctx.fillStyle = this.theme.team(owner);
      circle(ctx, this.toX(time), height * LANE_MARKS + (row - 0.5) * 5, event.kind === 'mark' ? 2.2 : 3);
      ctx.fill();
    }
  }

  #drawFaults(ctx, height) {
    ctx.strokeStyle = this.theme.paint.bad;
    ctx.lineWidth = 2.5;
    for (const { time } of this.match.faults) {
      const x = this.toX(time);
      const y = height * LANE_FAULTS;
      ctx.beginPath();
      ctx.moveTo(x - 4, y - 4);
      ctx.lineTo(x + 4, y + 4);
      ctx.moveTo(x + 4, y - 4);
      ctx.lineTo(x - 4, y + 4);
      ctx.stroke();
    }
  }
}

/** Makes a canvas as sharp as the screen and empty; sizes are in CSS pixels. */
function openCanvas(canvas) {
  const { width, height } = canvas.getBoundingClientRect();
  const ratio = devicePixelRatio || 1;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const ctx = canvas.getContext('2d');
  ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
  return { ctx, width, height };
}
