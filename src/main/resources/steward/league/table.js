// The table of bots with their bars, and that of workers.

import { bound, bounded, difference, drawIn, find, fixed, heads, make, nameCell, paint, plusMinus, signed, state, thousands } from './words.js';

/** Head of the column of differences: to the row above, or to one bot. */
function toHead() {
  const to = new Set(state.league.bots.map(bot => bot.to).filter(name => name));
  return to.size === 1 && state.league.bots.length > 2 ? `To ${[...to][0]}` : 'To above';
}

export function drawTable(onChoose) {
  const table = find('table');
  heads(table, [['#', 'num'], ['Bot', 'name'], ['Rating', ''], ['±', '', '95% bar, for a number of games fixed before'],
    ['Elo', 'bars'], [toHead(), 'table-wide', 'the difference with its 95% bar'],
    ['± anytime', 'table-wide', '95% bar that holds however often one looks and whenever one stops'],
    ['Ranks', '', 'what the games leave open, with 95%'], ['Games', ''],
    ['Points', '', 'share of the points'], ['Faults', ''],
    ['All failed', 'table-wide', 'games in which all players failed in the same turn: they count in no rating'], ['Mean ms', 'table-wide', 'mean answer time'],
    ['Worst ms', 'table-wide', 'longest answer'], ['Score', 'table-wide', 'the game’s own, mean']]);
  const body = table.tBodies[0];
  body.replaceChildren();
  const played = state.league.bots.filter(bot => bot.games > 0 && bot.rating !== null);
  // A bar of which nothing is known is null, and not drawn.
  const wide = bot => bot.bar === null ? 0 : Math.min(bot.anytime ?? 3 * bot.bar, 3 * bot.bar);
  const low = Math.min(0, ...played.map(bot => bot.rating - wide(bot)));
  const high = Math.max(0, ...played.map(bot => bot.rating + wide(bot)));
  const place = value => 1 + 98 * (value - low) / Math.max(1, high - low);
  for (const bot of state.league.bots) {
    const row = make(body, 'tr', null, bot.active ? '' : 'out');
    make(row, 'td', bot.rank, 'num');
    nameCell(row, bot, onChoose);
    const told = bot.games > 0 && bot.rating !== null;
    make(row, 'td', told ? signed(bot.rating) : '–');
    const bar = make(row, 'td', !told ? '–' : bounded(bot) ? bound(bot.rating - bot.bound, bot.bound) : bot.bar !== null ? Math.round(bot.bar) : '–');
    if (bot.games && bar.textContent === '–') bar.title = told ? 'Too few games for a bar or a bound' : 'No other bot that it can be compared with';
    const cell = make(row, 'td', null, 'bars');
    if (told) {
      const svg = drawIn(paint(cell, bot), 'svg', { viewBox: '0 0 100 18', preserveAspectRatio: 'none', role: 'img',
        'aria-label': signed(bot.rating) + plusMinus(bot.bar)
          + (bounded(bot) ? `, surely ${bound(bot.rating - bot.bound, bot.bound)}` : '') });
      drawIn(svg, 'line', { x1: place(0), x2: place(0), y1: 0, y2: 18, 'vector-effect': 'non-scaling-stroke' });
      drawIn(svg, 'line', { class: 'anytime', x1: place(bot.rating - wide(bot)), x2: place(bot.rating + wide(bot)), y1: 9, y2: 9,
        'vector-effect': 'non-scaling-stroke' });
      const left = place(bot.rating - bot.bar);
      if (bot.bar !== null) drawIn(svg, 'rect', { x: left, y: 5, width: Math.max(0.4, place(bot.rating + bot.bar) - left), height: 8, rx: 1 });
      drawIn(svg, 'rect', { x: place(bot.rating) - 0.5, y: 2, width: 1, height: 14 }).style.opacity = 1;
    }
    make(row, 'td', bot.games && bot.difference ? difference(bot.difference) : '–', 'table-wide');
    make(row, 'td', bot.games && bot.anytime ? Math.round(bot.anytime) : '–', 'table-wide');
    make(row, 'td', !bot.games || !bot.best ? '–' : bot.best === bot.worst ? bot.best : `${bot.best}–${bot.worst}`);
    make(row, 'td', thousands(bot.games));
    make(row, 'td', bot.points === null ? '–' : fixed(100 * bot.points, 1) + '%');
    make(row, 'td', bot.faults, bot.faults ? 'faulty' : '');
    make(row, 'td', bot.allFailed, 'table-wide');
    make(row, 'td', fixed(bot.meanMs, 2), 'table-wide');
    make(row, 'td', fixed(bot.worstMs, 1), 'table-wide');
    make(row, 'td', fixed(bot.score, 2), 'table-wide');
  }
  const anchor = state.league.bots.find(bot => bot.name === state.league.anchor?.[0]);
  find('meaning').textContent = (state.league.apart ?? []).map(sentence => sentence + ' ').join('')
    + `Rating: Elo; 100 ahead takes 64 points of 100. ${anchor ? anchor.name + ' is the anchor' : '0 is the mean'}. The `
    + 'band is its 95% bar for a number of games that was fixed before, the line the one that holds however often one looks '
    + 'and whenever one stops. Ranks: what the games leave open, with 95%.'
    + (state.league.repeats ? ` ${state.league.repeats} more games only repeat earlier ones and do not count.` : '')
    + (state.league.again ? ` ${state.league.again} more games were played again, since others used the processors.` : '')
    + (state.league.forgiven ? ` ${state.league.forgiven} more were forgiven and do not count.` : '')
    + (state.league.without > state.league.forgiven ? ` ${state.league.without - state.league.forgiven} more have no result.` : '');
}

/** Those that play on other machines. */
export function drawWorkers() {
  const workers = state.league.workers ?? [];
  find('workers-card').hidden = !workers.length;
  const table = find('workers');
  heads(table, [['Worker', 'name'], ['State', 'left'], ['Games', ''], ['Games/s', '', 'in this run'], ['Faults', '', 'of bots'],
    ['Hiccups', '', 'games played again, since others used its processors'], ['Set aside', '', 'games that do not count'],
    ['Version', 'table-wide'], ['Last word', 'table-wide']]);
  const body = table.tBodies[0];
  body.replaceChildren();
  const list = find('doubts');
  list.replaceChildren();
  for (const worker of workers) {
    const row = make(body, 'tr');
    const cell = make(row, 'td', worker.name, 'name');
    if (worker.doubts.length) make(cell, 'span', 'doubtful', 'tag faulty').title = worker.doubts.join('; ');
    make(row, 'td', worker.state || '–', ['caught', 'suspended'].includes(worker.state) ? 'left faulty' : 'left');
    make(row, 'td', thousands(worker.games));
    make(row, 'td', fixed(worker.rate, 2));
    make(row, 'td', worker.faults, worker.faults ? 'faulty' : '');
    make(row, 'td', worker.repeated);
    make(row, 'td', worker.aside, worker.aside ? 'faulty' : '');
    make(row, 'td', worker.program ?? '–', 'table-wide');
    make(row, 'td', worker.silentMs < 0 ? '–' : `${Math.round(worker.silentMs / 1000)} s ago`, 'table-wide');
    for (const doubt of worker.doubts) make(list, 'li', `${worker.name} is doubtful: ${doubt}.`);
  }
}
