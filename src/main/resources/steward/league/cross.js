// Who beats whom, and who is better: every bot against every other, whole at any number of bots. Heads stand upright,
// a head sorts by its column, arrow keys go from cell to cell.

import { difference, find, fixed, make, nameCell, plusMinus, state, thousands } from './words.js';

const SMALL = 16;               // from so many bots on cells are small
const CELL_PIXELS = 40;         // both tables stand beside each other where they are whole then
const NAME_PIXELS = 220;

const sorted = { cross: -1, better: -1 };

/** A number of percent for every two bots; 50 is the colour of the ground. */
function drawMatrix(table, value, title, mark, onChoose) {
  const { bots } = state.league;
  const by = sorted[table.id];
  const order = bots.map((_, k) => k);
  if (by >= 0) order.sort((one, other) => (value(other, by) ?? -1) - (value(one, by) ?? -1));
  table.classList.toggle('small', bots.length >= SMALL);
  table.closest('.card').classList.toggle('whole', 2 * (NAME_PIXELS + CELL_PIXELS * bots.length) > document.documentElement.clientWidth);
  const head = make(emptied(table.tHead), 'tr');
  make(head, 'td', '', 'name');
  bots.forEach((bot, k) => {
    const cell = make(head, 'th', null, 'upright');
    cell.scope = 'col';
    cell.setAttribute('aria-sort', by === k ? 'descending' : 'none');
    const button = make(cell, 'button', bot.name, 'sort');
    button.title = `${bot.name}: sorts by this column`;
    button.addEventListener('click', () => {
      sorted[table.id] = by === k ? -1 : k;
      drawMatrix(table, value, title, mark, onChoose);
      table.tHead.querySelectorAll('button')[k].focus();
    });
  });
  const body = emptied(table.tBodies[0]);
  for (const i of order) {
    const row = make(body, 'tr');
    nameCell(row, bots[i], onChoose).prepend(`${bots[i].rank} `);
    bots.forEach((other, j) => {
      const share = i === j ? null : value(i, j);
      const cell = make(row, 'td', i === j ? '·' : share === null ? '–' : Math.round(100 * share), i === j ? 'self' : '');
      cell.tabIndex = -1;
      if (share === null) return;
      cell.style.background = `rgb(from var(${share >= 0.5 ? '--win-c' : '--loss-c'}) r g b / ${Math.abs(share - 0.5)})`;
      cell.title = title(bots[i], other, i, j);
      if (mark(i, j)) cell.classList.add('surprise');
    });
  }
  const first = body.querySelector('td');
  if (first) first.tabIndex = 0;
}

function emptied(part) {
  part.replaceChildren();
  return part;
}

/** Arrow keys move the focus from cell to cell of a table. */
export function connectMatrix(table) {
  table.addEventListener('keydown', event => {
    const steps = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [-1, 0], ArrowDown: [1, 0] }[event.key];
    const cell = event.target.closest('tbody td');
    if (!steps || !cell) return;
    const next = table.rows[cell.parentElement.rowIndex + steps[0]]?.cells[cell.cellIndex + steps[1]];
    if (!next || next.tagName !== 'TD' || !next.closest('tbody')) return;
    event.preventDefault();
    cell.tabIndex = -1;
    next.tabIndex = 0;
    next.focus();
  });
}

export function drawCross(onChoose) {
  const surprises = state.league.surprises ?? [];
  const isSurprise = (i, j) => surprises.some(each => each[0] === i && each[1] === j || each[0] === j && each[1] === i);
  drawMatrix(find('cross'), (i, j) => state.league.cross[i][j]?.[0] ?? null,
    (bot, other, i, j) => `${bot.name} against ${other.name}: ${fixed(100 * state.league.cross[i][j][0], 1)}% of `
      + `${thousands(state.league.cross[i][j][1])} games`, isSurprise, onChoose);
  const list = find('surprises');
  list.replaceChildren();
  for (const [i, j, share, expected] of surprises.slice(0, 10)) {
    const digits = Math.round(100 * share) === Math.round(100 * expected) ? 1 : 0;
    make(list, 'li', `${state.league.bots[i].name} beats ${state.league.bots[j].name} more than ratings tell: `
      + `${fixed(100 * share, digits)}%, where they tell ${fixed(100 * expected, digits)}%.`);
  }
  const differences = state.league.differences ?? [];
  drawMatrix(find('better'), (i, j) => differences[i]?.[j]?.[3] ?? null,
    (bot, other, i, j) => `${bot.name} − ${other.name}: ${difference(differences[i][j])} Elo, anytime`
      + `${plusMinus(differences[i][j][2]) || ' –'}`, () => false, onChoose);
}
