// The strip that tells the game: the lead as an area (two players) or as lines, impacts as bars by impulse, events,
// faults. A range input lies over it.

import { circle, fillWith, FONT, openCanvas, ramp, strokeWith } from './draw.js';
import { strengthOf } from './effects.js';
import { areSteps } from './series.js';
import { eventWords, grouped, impulseWords, nameOf, shorten } from './text.js';
import { withAlpha } from './theme.js';
import { within } from './times.js';

const THUMB = 14;               // the width of the range input's thumb, as in the style sheet
const IMPACT_PART = 0.24;       // of the height, at the bottom
const TOP = 8;                  // pixels above the highest lead, and
const SIDE = 9;                 // for the events on each side of zero
const NEAR_PIXELS = 5;

export class Timeline {
  canvas; range; tip; match; theme; series; look; width; height; middle;

  constructor({ canvas, range, tip }, match, theme, series, look) {
    Object.assign(this, { canvas, range, tip, match, theme, series, look });
  }

  /** Connects the pointer: scrubbing goes on playing if it was. */
  connect(playback) {
    let wasPlaying = false;
    this.range.addEventListener('pointerdown', () => {
      wasPlaying = playback.playing;
      playback.pause();
    });
    this.range.addEventListener('input', () => playback.scrub(Number(this.range.value)));
    const release = () => {
      if (wasPlaying) playback.play();
      wasPlaying = false;
    };
    this.range.addEventListener('pointerup', release);
    this.range.addEventListener('pointercancel', release);
    this.range.addEventListener('pointermove', event => this.#showTip(event));
    this.range.addEventListener('pointerleave', () => {
      this.tip.hidden = true;
    });
  }

  /** Shows a time; the strip is drawn anew by draw(). */
  move(time) {
    const last = String(this.match.lastTurn);
    if (this.range.max !== last) this.range.max = last;
    this.range.value = String(time);
    const words = `${time.toFixed(2)} of ${last} turns`;
    if (this.range.getAttribute('aria-valuetext') !== words) this.range.setAttribute('aria-valuetext', words);
  }

  #toX(time) {
    return THUMB / 2 + (this.width - THUMB) * (this.match.lastTurn ? time / this.match.lastTurn : 0);
  }

  draw() {
    const { ctx, width, height } = openCanvas(this.canvas);
    Object.assign(this, { width, height });
    if (!width) return;
    const lead = this.series.lead();
    this.middle = lead && this.match.players.length === 2 ? height * (1 - IMPACT_PART) / 2 : height * (1 - IMPACT_PART) - 4;
    if (lead && this.match.players.length === 2) this.#drawArea(ctx, lead);
    else if (lead) this.#drawLines(ctx, lead);
    else this.#drawStrip(ctx);
    this.#drawImpacts(ctx);
    this.#drawEvents(ctx);
    this.#drawFaults(ctx);
  }

  #drawBase(ctx) {
    ctx.fillStyle = this.theme.paint.line;
    ctx.fillRect(THUMB / 2, Math.round(this.middle), this.width - THUMB, 1);
  }

  /** Above zero the first player leads, below it the second. */
  #drawArea(ctx, [first, second]) {
    const { theme } = this;
    const leads = first.map((value, turn) => (value ?? 0) - (second[turn] ?? 0));
    const [above, below] = [Math.max(0, ...leads), Math.max(0, ...leads.map(lead => -lead))];
    const room = this.height * (1 - IMPACT_PART);
    const unit = (room - TOP - 2 * SIDE) / Math.max(1e-9, above + below);
    const middle = this.middle = above + below > 0 ? TOP + SIDE + above * unit : room / 2;
    const toY = lead => middle - lead * unit;
    const step = Math.max(1, Math.floor(leads.length / this.width));
    const isStepped = areSteps([leads]);
    for (const [sign, player] of [[1, 0], [-1, 1]]) {
      const colour = theme.team(player);
      const fill = ramp(ctx.createLinearGradient(0, toY(sign > 0 ? above : -below) - sign, 0, middle),
        [0, withAlpha(colour, 0.65)], [1, withAlpha(colour, 0.12)]);
      ctx.save();
      ctx.beginPath();
      ctx.rect(0, sign > 0 ? 0 : middle, this.width, sign > 0 ? middle : this.height);
      ctx.clip();
      ctx.beginPath();
      ctx.moveTo(this.#toX(0), middle);
      for (let turn = 0; turn < leads.length; turn += step) {
        if (isStepped && turn > 0) ctx.lineTo(this.#toX(turn), toY(leads[turn - step]));
        ctx.lineTo(this.#toX(turn), toY(leads[turn]));
      }
      ctx.lineTo(this.#toX(leads.length - 1), toY(leads[leads.length - 1]));
      strokeWith(ctx, colour, 1.75);
      ctx.lineTo(this.#toX(leads.length - 1), middle);
      ctx.closePath();
      fillWith(ctx, fill);
      ctx.restore();
    }
    this.#drawBase(ctx);
    const name = this.match.header.drawing.lead ?? this.look.leadName;
    const best = leads.reduce((one, other) => (Math.abs(other) > Math.abs(one) ? other : one), 0);
    this.#caption(ctx, `lead in ${name}, at most ${grouped(Math.abs(best))}`);
  }

  #drawLines(ctx, lists) {
    const floor = this.middle;
    const all = lists.flat().filter(value => value !== null);
    const [low, high] = [Math.min(...all), Math.max(...all)];
    const toY = value => floor - (value - low) / Math.max(1e-9, high - low) * (floor - 8);
    this.#drawBase(ctx);
    const isStepped = areSteps(lists);
    lists.forEach((list, player) => {
      ctx.beginPath();
      list.forEach((value, turn) => {
        if (value === null) return;
        if (isStepped && turn > 0) ctx.lineTo(this.#toX(turn), toY(list[turn - 1] ?? value));
        ctx.lineTo(this.#toX(turn), toY(value));
      });
      ctx.strokeStyle = this.theme.team(player);
      ctx.lineWidth = 1.75;
      ctx.lineJoin = 'round';
      ctx.stroke();
    });
    this.#caption(ctx, `${this.match.header.drawing.lead ?? this.look.leadName}, 0 to ${grouped(high)}`);
  }

  /** Where there is no lead: the lines of the look, each as high as its largest value. */
  #drawStrip(ctx) {
    this.#drawBase(ctx);
    let x = THUMB / 2;
    this.#strip().forEach(({ name, list }, k) => {
      const high = Math.max(...list.filter(value => value !== null));
      ctx.beginPath();
      list.forEach((value, turn) => {
        if (value !== null) ctx.lineTo(this.#toX(turn), this.middle - Math.max(0, value) / (high || 1) * (this.middle - 18));
      });
      strokeWith(ctx, this.theme.team(k), 1.75);
      x += this.#caption(ctx, `${name}, at most ${grouped(high)}`, x, this.theme.team(k)) + 14;
    });
  }

  #strip() {
    return this.look.strip?.(this.match, this.series) ?? [];
  }

  /** Returns how wide it is. */
  #caption(ctx, words, x = THUMB / 2, colour = this.theme.paint.muted) {
    ctx.font = `11px ${FONT}`;
    ctx.textAlign = 'left';
    ctx.textBaseline = 'top';
    ctx.fillStyle = colour;
    ctx.fillText(words, x, 2);
    return ctx.measureText(words).width;
  }

  #drawImpacts(ctx) {
    const strongest = new Float32Array(Math.ceil(this.width));        // one bar a pixel is enough
    for (const { time, impact } of this.match.impacts) {
      const x = Math.max(0, Math.min(strongest.length - 1, Math.round(this.#toX(time))));
      strongest[x] = Math.max(strongest[x], 0.2 + 0.8 * Math.sqrt(strengthOf(this.match, impact)));
    }
    ctx.fillStyle = this.theme.paint.flash;
    strongest.forEach((strength, x) => {
      if (strength) ctx.fillRect(x - 0.75, this.height * (1 - IMPACT_PART * strength), 1.5, this.height * IMPACT_PART * strength);
    });
  }

  #drawEvents(ctx) {
    const { events } = this.match;
    for (const { time, turn, event } of events) {
      if (!event.text) continue;
      const owner = this.ownerOf(event, turn);
      const isBig = event.kind !== 'mark' || /lap/.test(event.text ?? '');
      ctx.fillStyle = this.theme.team(owner);
      const y = this.match.players.length === 2 && owner !== null ? this.middle + (owner === 0 ? -6 : 6)
        : this.middle - 5 - (owner ?? 0) % 4 * 5;
      circle(ctx, this.#toX(time), y, isBig && event.text ? 3.6 : 2.2);
      ctx.fill();
    }
  }

  /** The player whom an event concerns: the one it names, or the owner of its body. */
  ownerOf(event, turn) {
    const named = /\bplayer (\d+)\b/.exec(event.text ?? '')?.[1];
    if (named !== undefined) return Number(named);
    return event.body === undefined ? null : this.match.describeIn(event.body, turn).owner;
  }

  #drawFaults(ctx) {
    ctx.strokeStyle = this.theme.paint.bad;
    ctx.lineWidth = 2.5;
    for (const { time } of this.match.faults) {
      const [x, y] = [this.#toX(time), 20];
      ctx.beginPath();
      ctx.moveTo(x - 4, y - 4);
      ctx.lineTo(x + 4, y + 4);
      ctx.moveTo(x + 4, y - 4);
      ctx.lineTo(x - 4, y + 4);
      ctx.stroke();
    }
  }

  #showTip(event) {
    const { left, width } = this.range.getBoundingClientRect();
    const share = (event.clientX - left - THUMB / 2) / (width - THUMB);
    const time = Math.max(0, Math.min(1, share)) * this.match.lastTurn;
    const near = NEAR_PIXELS * this.match.lastTurn / Math.max(1, width);
    const turn = Math.floor(time);
    const lines = [`${time.toFixed(2)}, after turn ${turn}`, ...this.#leadWords(turn)];
    const impacts = within(this.match.impacts, time - near, time + near);
    const strongest = impacts.reduce((one, other) =>
      (!one || Math.abs(other.impact.impulse ?? 0) > Math.abs(one.impact.impulse ?? 0) ? other : one), null);
    if (strongest) lines.push(`impact ${pairOf(this.match, strongest.impact)}: ${impulseWords(strongest.impact)}`);
    for (const each of within(this.match.events, time - near, time + near).slice(0, 2)) {
      if (each.event.text) lines.push(shorten(eventWords(this.match, each), 60));
    }
    for (const { player, fault } of within(this.match.faults, time - near, time + near).slice(0, 2)) {
      lines.push(`${nameOf(this.match, player)}: ${shorten(fault, 60)}`);
    }
    this.tip.textContent = lines.join('\n');
    this.tip.hidden = false;
    const half = this.tip.offsetWidth / 2;
    this.tip.style.left = `${Math.max(half, Math.min(width - half, event.clientX - left))}px`;
  }

  #leadWords(turn) {
    const lead = this.series.lead();
    if (!lead) return this.#strip().map(({ name, list }) => `${name} ${grouped(list[turn] ?? NaN)}`);
    const name = this.match.header.drawing.lead ?? this.look.leadName;
    if (lead.length !== 2) {
      return lead.map((list, player) => ({ player, value: list[turn] ?? 0 })).sort((one, other) => other.value - one.value)
        .map(({ player, value }) => `${nameOf(this.match, player)}: ${grouped(value)}`);
    }
    const ahead = (lead[0][turn] ?? 0) - (lead[1][turn] ?? 0);
    return [ahead === 0 ? 'level' : `${nameOf(this.match, ahead > 0 ? 0 : 1)} +${grouped(Math.abs(ahead))} ${name}`];
  }
}

/** Who met whom: two bodies, or a body and a wall. */
export function pairOf(match, impact) {
  return `${impact.a} × ${impact.wall === undefined ? impact.b : match.wallName(impact.wall)}`;
}
