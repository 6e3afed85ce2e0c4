// What bots draw: lines on stderr such as "@line 0 0 100 100 red", "@circle 5 5 3 #fa0", "@text 7 7 some words".

import { shorten } from './text.js';

const MOST_SHAPES = 200;
export const MOST_WORDS = 80;
const FARTHEST = 1e7;
const NO_NOTES = { shapes: [], text: '' };
const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;
const NO_COLOUR = /^(inherit|initial|unset|revert)$/i;     // taken by styles, but no colours
const SHAPES = { '@line': readLine, '@circle': readCircle, '@text': readText };

/**
 * Splits one player's stderr of one turn.
 * Returns the shapes to draw, at most MOST_SHAPES, and the remaining text, bad drawing lines included.
 */
export function readNotes(stderr) {
  if (!stderr) return NO_NOTES;
  const shapes = [];
  const rest = [];
  let left = 0;
  for (const line of stderr.trimEnd().split('\n')) {
    const shape = readShape(line);
    if (!shape) rest.push(line);
    else if (shapes.length < MOST_SHAPES) shapes.push(shape);
    else left++;
  }
  if (left > 0) rest.push(`(${left} more drawings left out, ${MOST_SHAPES} is the limit of a turn)`);
  return { shapes, text: rest.join('\n') };
}

function readShape(line) {
  const words = line.trim().split(/\s+/);
  return Object.hasOwn(SHAPES, words[0]) ? SHAPES[words[0]](words, line) : null;
}

function readLine([, x1, y1, x2, y2, colour, ...more]) {
  const numbers = [x1, y1, x2, y2].map(readNumber);
  return more.length || numbers.includes(null) || !isColour(colour) ? null
    : { kind: 'line', x1: numbers[0], y1: numbers[1], x2: numbers[2], y2: numbers[3], colour };
}

function readCircle([, x, y, radius, colour, ...more]) {
  const numbers = [x, y, radius].map(readNumber);
  return more.length || numbers.includes(null) || numbers[2] < 0 || !isColour(colour) ? null
    : { kind: 'circle', x: numbers[0], y: numbers[1], radius: numbers[2], colour };
}

function readText([, x, y, ...words]) {
  const numbers = [x, y].map(readNumber);
  return numbers.includes(null) || !words.length ? null
    : { kind: 'text', x: numbers[0], y: numbers[1], words: shorten(words.join(' '), MOST_WORDS) };
}

function readNumber(word) {
  const number = NUMBER.test(word) ? Number(word) : NaN;
  return Math.abs(number) <= FARTHEST ? number : null;
}

/** A name or #hex; none at all means the colour of the player. */
function isColour(word) {
  return word === undefined || (/^(#[0-9a-f]{3,8}|[a-z]{3,24})$/i.test(word)
    && !NO_COLOUR.test(word) && CSS.supports('color', word));
}
