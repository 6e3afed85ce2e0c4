// How games look, by the id of a game. A look says what is special; all else follows from what the replay declares.
//
// A look may have: drawGround, drawBelow, drawBody, drawAbove (each gets a scene), standing(match, turn) with rank,
// body, big, small, warning and pips of each player, leadName and progress(match, turn) with their numbers,
// commandLines(command, player, match), commandOf(body, match, turn), field(name, value), rest(state, match) with pairs
// of name and text beside the bodies, charts(match, series), strip(match, series) with the lines of the timeline where
// there is no lead, focus(match) with the box of what matters of the field, and isUndrawn.

import { circle, captionSize, targetLine, write } from './draw.js';
import { putDisc } from './hulls.js';
import { paintZone } from './ground.js';
import { grouped, nameOf, plainNumber, shorten } from './text.js';

const LOOKS = new Map();
const MOST_CAPTIONS = 100;
const MOST_REST = 200;
const MOST_BLOCK = 8000;
export const LABEL_PIXELS = 8;  // bodies drawn smaller than this have no label

export function addLook(game, look) {
  LOOKS.set(game, { ...PLAIN_LOOK, ...look });
}

export function lookOf(game) {
  return LOOKS.get(game) ?? PLAIN_LOOK;
}

/** What a turn says of scores: one for each player, or null. */
function scoresOf(match, number) {
  const turn = match.turn(number);
  const scores = turn?.scores ?? turn?.state?.scores ?? null;
  return Array.isArray(scores) && scores.length === match.players.length ? scores : null;
}

/** The rank of each value, 0 for the largest. */
export function ranksOf(values) {
  return values.map(value => values.filter(other => other > value).length);
}

/** How a game without a drawing module of its own looks. */
export const PLAIN_LOOK = {
  leadName: 'score',
  drawGround: null,

  drawBelow(scene) {
    const zones = scene.match.turn(scene.moment.settled)?.zones ?? [];
    zones.forEach(zone => paintZone(scene, zone));
    if (!scene.show.targets && scene.selected === null) return;
    for (const body of scene.bodies) {
      const command = scene.match.turn(scene.moment.turn)?.commands?.[body.owner];
      const isAsked = scene.show.targets || body.id === scene.selected;
      if (isAsked && Number.isFinite(command?.x) && Number.isFinite(command?.y)) {
        targetLine(scene, body, command.x, command.y);
      }
    }
  },

  drawBody(scene, body) {
    putDisc(scene, body, body.owner === null || scene.match.isIn(body.owner, scene.moment.turn));
    const radius = body.radius * scene.view.scale;
    if (body.label && radius >= LABEL_PIXELS) {
      write(scene, body.label, scene.view.x(body.x), scene.view.y(body.y), Math.max(9, Math.min(15, radius * 0.7)),
        scene.paint.ink, '800');
    }
  },

  drawAbove(scene) {
    if (scene.show.names && scene.bodies.length < MOST_CAPTIONS) scene.bodies.forEach(body => writeOut(scene, body));
  },

  progress: scoresOf,

  standing(match, number) {
    const scores = scoresOf(match, number);
    if (!scores) return null;
    const ranks = ranksOf(scores);
    return scores.map((score, player) => ({ rank: ranks[player], body: bodyOf(match, number, player),
      big: `${grouped(score)} ${match.header.drawing.lead ?? 'points'}`, small: '', warning: '' }));
  },

  isUndrawn: false,
  commandLines: command => [JSON.stringify(command)],
  commandOf: () => '',
  field: (name, value) => (typeof value === 'number' ? plainNumber(value)
    : typeof value === 'object' && value !== null ? JSON.stringify(value) : String(value)),
  rest: state => Object.entries(state).filter(([name]) => name !== 'bodies')
    .map(([name, value]) => [name, shorten(JSON.stringify(value), MOST_REST)]),
};

/** The look of a guest, whose referee and bots speak lines. */
addLook('guest', {
  isUndrawn: true,
  commandLines: command => command.lines,
  rest: (state, match) => [...(state.asked === undefined ? [] : [['asked', nameOf(match, state.asked)]]),
    ...(state.said ?? []).filter(each => each.lines.length)
      .map(each => [each.block, shorten(each.lines.join('\n'), MOST_BLOCK)])],
});

function bodyOf(match, number, player) {
  for (const body of match.turn(number).bodies.values()) {
    if (match.describe(body.id, body).owner === player) return body.id;
  }
  return null;
}

/** The word OUT below a body whose player is asked no more. */
function writeOut(scene, body) {
  const { match, moment, view, theme } = scene;
  if (body.owner === null || body.owner === undefined || match.isIn(body.owner, moment.turn)) return;
  write(scene, 'OUT', view.x(body.x), view.y(body.y) + body.radius * view.scale + 9, captionSize(view),
    theme.team(body.owner), '700');
}

/** A ring around a body that is selected or pointed at. */
export function drawRing({ ctx, view, paint, moment, theme }, body, isSelected) {
  circle(ctx, view.x(body.x), view.y(body.y), Math.max(5, body.radius * view.scale) + 5);
  ctx.strokeStyle = paint.ink;
  ctx.lineWidth = isSelected ? 2 : 1.25;
  ctx.setLineDash(isSelected ? [6, 4] : []);
  ctx.lineDashOffset = theme.isCalm ? 0 : -8 * moment.time;
  ctx.stroke();
  ctx.setLineDash([]);
}
