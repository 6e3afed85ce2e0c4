// Over the field: who plays, what they have, who leads, and at the end who won and why.

import { element, grouped, MOST_NAME, nameOf, show, shorten } from './text.js';
import { inTeamColour } from './theme.js';

const MOST_ABREAST = 4;         // with more players than this, their cells are small
const MOST_PIPS = 40;
const MOST_REASON = 280;

/** The strip at the top of the field: a cell per player with the turn between them. */
export class Scores {
  root; match; look; series;

  constructor(root, match, look, series) {
    Object.assign(this, { root, match, look, series });
    this.turn = element('b', '', '0');
    this.of = element('span', 'clock-of', '');
    this.clock = element('div', 'clock', null, this.turn, this.of);
    this.cells = match.players.map((_, player) => this.#makeCell(player));
    const middle = Math.ceil(this.cells.length / 2);
    root.classList.toggle('alone', !this.cells.length);
    root.classList.toggle('many', this.cells.length > 2);
    root.classList.toggle('crowd', this.cells.length > MOST_ABREAST);
    root.setAttribute('role', 'group');
    root.setAttribute('aria-label', 'Scores');
    if (this.cells.length > 2) root.tabIndex = 0;      // on a phone it is moved sideways
    root.replaceChildren(...this.cells.slice(0, middle).map(cell => cell.root), this.clock,
      ...this.cells.slice(middle).map(cell => cell.root));
  }

  #makeCell(player) {
    const cell = { rank: element('span', 'rank'), name: element('b', 'name', nameOf(this.match, player)),
      big: element('span', 'big'), small: element('span', 'small'), pips: element('span', 'pips') };
    cell.root = inTeamColour(element('div', 'score', null, cell.rank, cell.name, cell.big, cell.small, cell.pips), player);
    if (this.match.players.length === 2 && player === 1) cell.root.classList.add('right');
    cell.root.title = `${nameOf(this.match, player)} ${this.match.players[player].bot ?? ''}`;
    return cell;
  }

  update(moment, standing) {
    const key = `${moment.turn} ${moment.settled} ${this.match.lastTurn}`;
    if (key === this.#key) return;
    this.#key = key;
    this.turn.textContent = String(moment.settled);
    this.of.textContent = `of ${grouped(this.match.lastTurn)}`;
    const lead = this.series.lead();
    this.cells.forEach((cell, player) => {
      const isIn = this.match.isIn(player, moment.turn);
      const line = standing?.[player];
      show(cell.rank, line && this.cells.length > 1 && moment.settled > 0 ? String(line.rank + 1) : '');
      show(cell.big, isIn ? line?.big ?? '' : 'OUT');
      show(cell.small, line?.warning && isIn ? line.warning : [line?.small, this.#leadOf(lead, player, moment.settled)]
        .filter(Boolean).join(' · '));
      this.#showPips(cell, line?.pips);
      cell.root.classList.toggle('leads', line?.rank === 0 && moment.settled > 0);
      cell.root.classList.toggle('warned', Boolean(line?.warning) && isIn);
      cell.root.classList.toggle('out', !isIn);
    });
  }
  #key = '';

  /** "+1.7" of the one who leads, of two. */
  #leadOf(lead, player, turn) {
    if (!lead || lead.length !== 2) return '';
    const ahead = (lead[player][turn] ?? 0) - (lead[1 - player][turn] ?? 0);
    return ahead > 0.005 ? `+${grouped(ahead)}` : '';
  }

  #showPips(cell, pips) {
    if (!pips || pips.groups * pips.each > MOST_PIPS) return;
    if (!cell.marks) {
      cell.marks = Array.from({ length: pips.groups * pips.each }, (_, k) =>
        element('i', k > 0 && k % pips.each === 0 ? 'first' : ''));
      cell.pips.replaceChildren(...cell.marks);
    }
    cell.marks.forEach((mark, k) => mark.style.setProperty('--done', `${Math.round(100 * Math.max(0, Math.min(1, pips.done - k)))}%`));
  }
}

/** Who won, in a few words. */
export function headlineOf(match) {
  const { standing } = match.result;
  const best = standing.flatMap(({ rank }, player) => (rank === 0 ? [player] : []));
  if (standing.length === 1) return nameOf(match, 0);
  return best.length === 1 ? `${nameOf(match, best[0])} wins` : `Draw: ${best.map(player => nameOf(match, player)).join(' and ')}`;
}

/** The lower third at the end: who won, why, and everybody's rank. */
export class Ending {
  isDismissed = false;

  root; match; series; onSeek;

  constructor(root, match, series, onSeek) {
    Object.assign(this, { root, match, series, onSeek });
  }

  update(isAtEnd) {
    const isShown = isAtEnd && Boolean(this.match.result);
    if (!isShown) this.isDismissed = false;
    const wasHidden = this.root.hidden;
    this.root.hidden = !isShown || this.isDismissed;
    if (wasHidden && !this.root.hidden) this.#fill(this.match.result);
  }

  #fill(result) {
    const close = element('button', 'close', '×');
    close.setAttribute('aria-label', 'Close');
    close.addEventListener('click', () => {
      this.isDismissed = true;
      this.root.hidden = true;
    });
    const ranks = result.standing
      .map((standing, player) => ({ ...standing, player }))
      .sort((one, other) => one.rank - other.rank)
      .map(line => this.#rankLine(line, result));
    const list = element('ol', '', null, ...ranks);
    list.tabIndex = 0;
    list.setAttribute('aria-label', 'Ranks');
    this.root.replaceChildren(
      element('p', 'headline', headlineOf(this.match)),
      element('p', 'reason', `${shorten(result.ending, MOST_REASON)}, turn ${result.turns}`, this.#leadWords(result)), list, close);
  }

  /** Since when the winner was ahead of all others, or who was ahead in its place. */
  #leadWords({ standing }) {
    const lead = this.series.lead();
    const winners = standing.flatMap(({ rank }, player) => (rank === 0 ? [player] : []));
    if (!lead || winners.length !== 1 || standing.length < 2) return '';
    const [winner] = winners;
    const last = lead[0].length - 1;
    const isAhead = (player, turn) => lead.every((list, other) => other === player || (lead[player][turn] ?? 0) > (list[turn] ?? 0));
    let turn = last;
    while (turn >= 0 && isAhead(winner, turn)) turn--;
    if (turn < last) return this.#momentButton(`${nameOf(this.match, winner)} was ahead from turn ${turn + 1} to the end`, turn + 1);
    const leader = lead.findIndex((_, player) => isAhead(player, last));
    return leader < 0 ? '' : element('span', 'then', `${nameOf(this.match, leader)} was ahead at the end`);
  }

  #momentButton(words, time) {
    const button = element('button', 'then', words);
    button.addEventListener('click', () => this.onSeek(time));
    return button;
  }

  #rankLine({ player, rank, score, out }, result) {
    const why = result.players[player]?.fault ?? out;
    const fault = this.match.faults.find(each => each.player === player);
    const line = fault && this.match.errorLine(fault.time, player).trim();
    const reason = why ? [fault ? this.#momentButton(`out in turn ${fault.time}: ${shorten(why, MOST_REASON)}`, fault.time)
      : `out: ${shorten(why, MOST_REASON)}`, line ? element('code', '', shorten(line, MOST_REASON)) : ''] : [];
    return inTeamColour(element('li', '', null, element('span', 'rank', String(rank + 1)),
      element('b', 'name', shorten(nameOf(this.match, player), MOST_NAME)), element('span', 'points', grouped(score)),
      element('span', 'why', null, ...reason)), player);
  }
}
