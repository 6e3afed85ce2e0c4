// What all parts of the page of a league need: the league shown, elements, numbers, colours of bots.

import { colourOfMany } from '../view/theme.js';

const SVG = 'http://www.w3.org/2000/svg';

/** The league as it came last, how many games are listed, and the version of the bot that is looked at. */
export const state = { league: null, shown: 0, bot: 0, isDark: true };

export const find = id => document.getElementById(id);

export function make(parent, tag, content, className) {
  const made = document.createElement(tag);
  if (content !== undefined && content !== null) made.textContent = content;
  if (className) made.className = className;
  parent.append(made);
  return made;
}

export function drawIn(parent, tag, values, content) {
  const made = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(values)) made.setAttribute(name, value);
  if (content !== undefined) made.textContent = content;
  parent.append(made);
  return made;
}

/** A bot keeps its colour while ranks change: it goes by the number of its version, as on the pages of matches. */
export function colourOf(version) {
  return colourOfMany(version - 1, state.isDark);
}

export function paint(node, bot) {
  node.style.setProperty('--bot', colourOf(bot.version));
  return node;
}

export const fixed = (value, decimals) => value === null || value === undefined ? '–' : value.toFixed(decimals);
export const signed = value => (Math.round(value) > 0 ? '+' : Math.round(value) < 0 ? '−' : '±') + Math.abs(Math.round(value));
/** A bar with one end: of a bot that has won or lost nearly everything. */
export const bounded = bot => bot.bound !== null && bot.bound !== undefined;
export const bound = (value, end) => `${value > 0 ? '>' : '<'} ${Math.round(end)}`.replace('-', '−');
export const plusMinus = bar => bar === null || bar === undefined ? '' : ` ± ${Math.round(bar)}`;
/** A difference as the league's JSON has it: Elo, bar, anytime bar, likelihood of superiority, bound. */
export const difference = ([elo, bar, , superiority, end]) => (end !== null ? bound(superiority - 0.5, end)
  : elo === null || bar === null ? '–' : signed(elo) + plusMinus(bar));
export const thousands = value => value.toLocaleString('en-US').replaceAll(',', '\u2009');

export function heads(table, names) {
  const head = table.tHead;
  head.replaceChildren();
  const row = make(head, 'tr');
  for (const [name, className, title] of names) {
    const cell = make(row, 'th', name, className);
    cell.scope = 'col';
    if (title) cell.title = title;
  }
}

/** A cell with a bot's colour and name; a click looks at the bot. */
export function nameCell(row, bot, onChoose) {
  const cell = make(row, onChoose === undefined ? 'td' : 'th', null, 'name');
  if (onChoose !== undefined) cell.scope = 'row';
  paint(make(cell, 'i', null, 'dot'), bot);
  if (onChoose) make(cell, 'button', bot.name, 'choose').addEventListener('click', () => onChoose(bot));
  else cell.append(bot.name);
  if (bot.random) make(cell, 'span', 'random', 'tag').title = 'draws by lot: its games cannot be played again alike';
  if (bot.paused) make(cell, 'span', 'paused', 'tag').title = 'failed in too many games in a row: plays no more until it is resumed or changed';
  if (!bot.active) make(cell, 'span', 'out', 'tag').title = 'plays no more';
  return cell;
}
