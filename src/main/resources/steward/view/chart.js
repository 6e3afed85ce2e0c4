// Answer times: one line per player over the turns, on a logarithmic scale, with the limit.

const NANOS_PER_MS = 1e6;
const LEAST_MS = 0.001;
const CHART_LEFT = 40;
const CHART_RIGHT = 8;
const CHART_TOP = 8;
const CHART_BOTTOM = 8;

/** The limit of a player's answer in a turn, in ms; Infinity without deadlines. */
function limitMs(match, number) {
  const { time } = match.header.scene;
  const factor = match.header.timeFactor ?? Infinity;
  return (number === 1 ? time.firstAnswerMs : time.answerMs) * factor;
}

class TimeChart {
  constructor(canvas, match, theme, onSeek) {
    this.canvas = canvas;
    this.match = match;
    this.theme = theme;
    canvas.addEventListener('pointerdown', event => onSeek(this.#turnAt(event)));
    canvas.addEventListener('pointermove', event => {
      if (event.buttons) onSeek(this.#turnAt(event));
    });
  }

  #turnAt(event) {
    const { left, width } = this.canvas.getBoundingClientRect();
    const share = (event.clientX - left - CHART_LEFT) / (width - CHART_LEFT - CHART_RIGHT);
    return Math.round(share * this.match.lastTurn);
  }

  draw(time) {
    const { ctx, width, height } = openCanvas(this.canvas);
    const turns = this.match.turns;
    if (!turns.length) return;
    const [low, high] = this.#range();
    const toX = turn => CHART_LEFT + (width - CHART_LEFT - CHART_RIGHT) * turn / turns.length;
    const toY = ms => height - CHART_BOTTOM
      - (height - CHART_TOP - CHART_BOTTOM) * (Math.log10(Math.max(LEAST_MS, ms)) - low) / (high - low);
    this.#drawScale(ctx, width, toY, low, high);
    this.#drawLimit(ctx, toX, toY);
    this.match.players.forEach((_, player) => this.#drawPlayer(ctx, player, toX, toY));
    ctx.fillStyle = this.theme.paint.ink;
    ctx.fillRect(toX(time) - 0.5, CHART_TOP, 1, height - CHART_TOP - CHART_BOTTOM);
  }

  /** Decades that hold all answers and the limits. */
  #range() {
    let [low, high] = [Infinity, -Infinity];
    for (const turn of this.match.turns) {
      for (const nanos of turn.answerNanos) {
        if (nanos === null) continue;
        const decade = Math.log10(Math.max(LEAST_MS, nanos / NANOS_PER_MS));
        low = Math.min(low, decade);
        high = Math.max(high, decade);
      }
    }
    for (const limit of [limitMs(this.match, 1), limitMs(this.match, 2)]) {
      if (Number.isFinite(limit)) high = Math.max(high, Math.log10(limit) + 0.1);
    }
    if (low > high) return [-1, 2];
    return [Math.floor(low), Math.max(Math.ceil(high * 4) / 4, Math.floor(low) + 1)];
  }

  #drawScale(ctx, width, toY, low, high) {
    ctx.font = `11px ${FONT}`;
    ctx.textAlign = 'right';
    ctx.textBaseline = 'middle';
    for (let decade = Math.ceil(low); decade <= high; decade++) {
      const y = toY(10 ** decade);
      ctx.fillStyle = this.theme.paint.line;
      ctx.fillRect(CHART_LEFT, y, width - CHART_LEFT - CHART_RIGHT, 1);
      ctx.fillStyle = this.theme.paint.muted;
      ctx.fillText(decade >= 0 ? String(10 ** decade) : (10 ** decade).toFixed(-decade), CHART_LEFT - 6, y);
    }
  }

  #drawLimit(ctx, toX, toY) {
    const [first, other] = [limitMs(this.match, 1), limitMs(this.match, 2)];
    if (!Number.isFinite(other)) return;
    ctx.strokeStyle = this.theme.paint.bad;
    ctx.lineWidth = 1.5;
    ctx.setLineDash([5, 3]);
    ctx.beginPath();
    ctx.moveTo(toX(0), toY(first));
    ctx.lineTo(toX(1), toY(first));
    ctx.lineTo(toX(1), toY(other));
    ctx.lineTo(toX(this.match.lastTurn), toY(other));
    ctx.stroke();
    ctx.setLineDash([]);
  }

  #drawPlayer(ctx, player, toX, toY) {
    ctx.strokeStyle = this.theme.team(player);
    ctx.lineWidth = 1.25;
    ctx.lineJoin = 'round';
    ctx.beginPath();
    for (const turn of this.match.turns) {
      const nanos = turn.answerNanos[player];
      if (nanos === null || nanos === undefined) continue;
      ctx.lineTo(toX(turn.number), toY(nanos / NANOS_PER_MS));
    }
    ctx.stroke();
  }
}
