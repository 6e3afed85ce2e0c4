// One bot: its games, its failures by kind, against whom it does worst, and how it lost.

import { find, fixed, make, paint, signed, state, thousands } from './words.js';

const MOST_WORST = 5;
const MOST_KIND = 40;
const MOST_ERROR = 80;

/** The kind of a failure: its words up to the first detail. */
export function kindOf(fault) {
  const kind = fault.split(/[:;,(]|\d/)[0].trim();
  return kind.length > MOST_KIND ? `${kind.slice(0, MOST_KIND)}…` : kind || 'failed';
}

/** Why the bot of a seat failed: the line of its stderr that says it, or the kind of the failure. */
export function reasonOf(seat) {
  if (!seat.error) return kindOf(seat.fault);
  return seat.error.length > MOST_ERROR ? `${seat.error.slice(0, MOST_ERROR)}…` : seat.error;
}

/** Fills the card of the bot that is looked at, or hides it. */
export function drawBot(onClose) {
  const { league } = state;
  const card = find('bot-card');
  const index = league.bots.findIndex(bot => bot.version === state.bot);
  card.hidden = index < 0;
  if (index < 0) return;
  const bot = league.bots[index];
  const box = find('bot-view');
  box.replaceChildren();
  const head = make(box, 'p', null, 'bot-head');
  paint(make(head, 'i', null, 'dot'), bot);
  make(head, 'b', bot.name);
  make(head, 'span', `rank ${bot.rank} · ${bot.games && bot.rating !== null ? signed(bot.rating) : '–'} Elo · ${thousands(bot.games)} games · `
    + `${bot.points === null ? '–' : `${fixed(100 * bot.points, 1)}%`} of the points · ${bot.faults} faults`, 'scene');
  const close = make(head, 'button', 'Close', 'more');
  close.addEventListener('click', onClose);
  const columns = make(box, 'div', null, 'bot-columns');
  list(columns, 'Worst opponents', worstOf(league, index), 'has met nobody yet');
  list(columns, 'Failures by kind, in the last games', failuresOf(league, bot), 'none');
  const why = league.why?.[bot.version];
  if (!why) return;
  make(box, 'h3', 'Lost games, of the last ones');
  const lines = make(box, 'div', null, 'scroll');
  lines.tabIndex = 0;
  lines.setAttribute('role', 'group');
  lines.setAttribute('aria-label', 'Lost games');
  make(lines, 'pre', why.join('\n'));
}

function list(parent, title, lines, none) {
  const part = make(parent, 'div');
  make(part, 'h3', title);
  const rows = make(part, 'ul', null, 'plain-list');
  for (const line of lines.length ? lines : [none]) make(rows, 'li', line);
}

function worstOf(league, index) {
  return league.bots.map((other, k) => ({ other, share: league.cross[index]?.[k]?.[0] ?? null, games: league.cross[index]?.[k]?.[1] }))
    .filter(({ share }, k) => k !== index && share !== null)
    .sort((one, other) => one.share - other.share).slice(0, MOST_WORST)
    .map(({ other, share, games }) => `${other.name}: ${fixed(100 * share, 1)}% of ${thousands(games)} games`);
}

function failuresOf(league, bot) {
  const kinds = new Map();
  for (const game of league.list) {
    for (const seat of game.seats) {
      if (seat.version !== bot.version || !seat.fault) continue;
      const kind = seat.error ? `${reasonOf(seat)} · ${kindOf(seat.fault)}` : kindOf(seat.fault);
      kinds.set(kind, [...kinds.get(kind) ?? [], game.id]);
    }
  }
  return [...kinds].sort((one, other) => other[1].length - one[1].length)
    .map(([kind, games]) => `${games.length} × ${kind} (game ${games.slice(0, 5).join(', ')}${games.length > 5 ? ', …' : ''})`);
}
