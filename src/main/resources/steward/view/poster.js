// A picture of the match to be handed on: the field, above it names and scores, at the end who won; no buttons.

import { FONT } from './draw.js';
import { headlineOf } from './scores.js';
import { grouped, nameOf, shorten } from './text.js';

const STRIP_PIXELS = 52;               // pixels, of names and scores
const FOOT_PIXELS = 26;                // of the scene and the moment
const LONGEST_NAME = 22;
const NARROW_PIXELS = 130;             // a cell of fewer pixels has no second line

/** The size of a poster in pixels of the field's canvas. */
export function sizeOf({ stage }) {
  const { canvas, pixelRatio, view } = stage;
  const above = Math.max(0, STRIP_PIXELS - view.covered) * pixelRatio;
  return { width: canvas.width, height: Math.round(canvas.height + above + FOOT_PIXELS * pixelRatio), above: Math.round(above) };
}

/** Draws the present moment into a canvas, which is made as large as a poster, or as wide as is asked. */
export function drawPoster(page, canvas, width = sizeOf(page).width) {
  const { stage, playback, match, theme } = page;
  const size = sizeOf(page);
  const scale = width / size.width;
  const [wide, high] = [2 * Math.round(width / 2), 2 * Math.round(size.height * scale / 2)];
  if (canvas.width !== wide || canvas.height !== high) Object.assign(canvas, { width: wide, height: high });
  const ctx = canvas.getContext('2d', { willReadFrequently: true });
  ctx.setTransform(scale, 0, 0, scale, 0, 0);
  ctx.fillStyle = theme.paint.ground;
  ctx.fillRect(0, 0, size.width, size.height);
  ctx.drawImage(stage.canvas, 0, size.above);
  const ratio = stage.pixelRatio * scale;
  ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
  const [w, h] = [wide / ratio, high / ratio];
  drawStrip(ctx, page, w);
  const { header } = match;
  ctx.fillStyle = theme.paint.panel;
  ctx.fillRect(0, h - FOOT_PIXELS, w, FOOT_PIXELS);
  say(ctx, `${header.scene?.name ?? header.game} · seed ${header.seed}`, 12, h - FOOT_PIXELS / 2, 12, theme.paint.muted, 'left', w - 160);
  say(ctx, `turn ${playback.time.toFixed(2)} of ${grouped(match.lastTurn)}`, w - 12, h - FOOT_PIXELS / 2, 12, theme.paint.muted, 'right');
  if (match.result && playback.time >= playback.end) drawWinner(ctx, page, w, h - FOOT_PIXELS);
  return canvas;
}

function say(ctx, words, x, y, size, colour, align, most = 1e4, weight = '500') {
  ctx.font = `${weight} ${size}px ${FONT}`;
  ctx.textAlign = align;
  ctx.textBaseline = 'middle';
  ctx.fillStyle = colour;
  ctx.fillText(words, x, y, most);
}

/** A cell for each player: its colour, name and score. */
function drawStrip(ctx, { match, stage, playback, theme }, width) {
  ctx.fillStyle = theme.paint.panel;
  ctx.fillRect(0, 0, width, STRIP_PIXELS);
  const standing = stage.standing(playback.moment);
  const cell = width / Math.max(1, match.players.length);
  match.players.forEach((_, player) => {
    const x = player * cell;
    const line = standing?.[player];
    const isIn = match.isIn(player, playback.moment.turn);
    ctx.fillStyle = theme.team(player);
    ctx.fillRect(x, 0, 5, STRIP_PIXELS);
    const name = `${line?.rank === 0 && playback.moment.settled > 0 && match.players.length > 1 ? '♛ ' : ''}${shorten(nameOf(match, player), LONGEST_NAME)}`;
    say(ctx, name, x + 14, 17, 14, theme.paint.ink, 'left', cell - 24, '700');
    const words = isIn ? [line?.big, cell < NARROW_PIXELS ? '' : line?.small].filter(Boolean).join(' · ') : 'OUT';
    say(ctx, words, x + 14, 37, 12, theme.team(player), 'left', cell - 24, '600');
  });
  if (!match.players.length) say(ctx, match.header.scene?.name ?? match.header.game, 14, STRIP_PIXELS / 2, 15, theme.paint.ink, 'left', width - 28, '700');
}

function drawWinner(ctx, { match, theme }, width, bottom) {
  const high = 58;
  ctx.globalAlpha = 0.88;
  ctx.fillStyle = theme.paint.panel;
  ctx.fillRect(0, bottom - high, width, high);
  ctx.globalAlpha = 1;
  if (match.players.length) say(ctx, headlineOf(match), width / 2, bottom - high + 22, 20, theme.paint.ink, 'center', width - 24, '800');
  say(ctx, `${shorten(match.result.ending, 120)}, turn ${match.result.turns}`, width / 2, bottom - 15, 12, theme.paint.muted, 'center', width - 24);
}
