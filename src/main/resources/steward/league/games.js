// The last games, by bot, opponent and result; those that failed say why.

import { reasonOf } from './bot.js';
import { find, heads, make, paint, state, thousands } from './words.js';

const NOT_KEPT = 'its replay was not kept: "keep": "all" in league.json keeps all, "lost" those that have a loser';

export function options(select, first) {
  const before = select.value;
  select.replaceChildren();
  make(select, 'option', first).value = '';
  for (const bot of state.league.bots) make(select, 'option', bot.name).value = bot.version;
  select.value = before;
  if (select.selectedIndex < 0) select.value = '';
}

function isShown(game) {
  const bot = Number(find('bot').value), against = Number(find('against').value);
  const result = find('result').value;
  if (find('kept').checked && !game.replay) return false;
  const seats = game.seats.filter(seat => !bot || seat.version === bot);
  if (!seats.length || against && !game.seats.some(seat => seat.version === against && (!bot || seat !== seats[0]))) {
    return false;
  }
  const first = game.seats.filter(seat => seat.rank === 0).length;
  return !result || result === 'failed' && (bot ? seats : game.seats).some(seat => seat.fault)
    || game.counts && seats.some(seat => result === 'won' && seat.rank === 0 && first === 1
      || result === 'drawn' && seat.rank === 0 && first > 1 || result === 'lost' && seat.rank > 0);
}

export function drawGames() {
  const table = find('games');
  heads(table, [['Game', 'num'], ['Bots, best first', 'left'], ['Turns', ''], ['Seed', 'table-wide'], ['Replay', '']]);
  const body = table.tBodies[0];
  body.replaceChildren();
  const found = state.league.list.filter(isShown);
  const names = new Map(state.league.bots.map(bot => [bot.version, bot]));
  for (const game of found.slice(0, state.shown)) {
    const row = make(body, 'tr');
    make(row, 'td', game.id, 'num');
    const cell = make(row, 'td', null, 'left');
    const first = game.seats.filter(seat => seat.rank === 0).length;
    [...game.seats].sort((a, b) => a.rank - b.rank).forEach((seat, k) => {
      if (k) cell.append(game.counts && first > 1 ? ' = ' : ' · ');
      const bot = names.get(seat.version);
      if (bot) paint(make(cell, 'i', null, 'dot'), bot);
      make(cell, 'span', bot ? bot.name : '?', game.counts && seat.rank === 0 && first === 1 ? 'win' : '');
      if (seat.fault) {
        make(cell, 'span', `failed: ${reasonOf(seat)}`, 'tag faulty').title = (seat.error ? `${seat.error}\n` : '') + seat.fault;
      }
    });
    if (game.problem) make(cell, 'span', 'no result', 'tag faulty').title = game.problem;
    else if (!game.counts) make(cell, 'span', 'played again', 'tag').title = 'others used the processors';
    make(row, 'td', game.turns);
    make(row, 'td', game.seed, 'table-wide');
    const last = make(row, 'td');
    if (game.replay === 'live') {
      const link = make(last, 'a', 'Watch', 'link');
      link.href = `replay/${game.id}${faultOf(game)}`;
      link.target = '_blank';
      link.rel = 'noopener';
    } else if (game.replay === 'page') {
      const link = make(last, 'a', 'Watch', 'link');
      link.href = `#game=${game.id}${faultOf(game).replace('#', '&')}`;
    } else if (game.replay) {
      make(last, 'span', 'on disk').title = `${game.replay}\nsteward replay FILE --view shows it`;
    } else {
      make(last, 'span', '–').title = NOT_KEPT;
    }
  }
  find('count').textContent = `${thousands(found.length)} of the last ${thousands(state.league.list.length)} games`;
  find('not-kept').textContent = `A game marked – has no replay: ${NOT_KEPT.replace('its replay was not kept: ', '')}.`;
  find('not-kept').hidden = found.every(game => game.replay);
  find('more').hidden = found.length <= state.shown;
}

/** The link to the moment at which a bot failed, the one that is looked at if it did; empty if none did. */
function faultOf(game) {
  const failed = game.seats.flatMap((seat, player) => (seat.fault ? [player] : []));
  const player = failed.find(each => game.seats[each].version === state.bot) ?? failed[0];
  return player === undefined ? '' : `#fault=${player}`;
}

/** The title of a game's page. */
export function titleOf(id) {
  const game = state.league.list.find(each => String(each.id) === id);
  const names = new Map(state.league.bots.map(bot => [bot.version, bot.name]));
  return game ? game.seats.map(seat => names.get(seat.version) ?? '?').join(' against ') : `Game ${id}`;
}

/** Says why a game that an address names cannot be shown. */
export function tellMissing(id) {
  const game = state.league.list.find(each => String(each.id) === id);
  if (game?.replay === 'live') return location.replace(`replay/${id}${location.hash.replace(/^#game=\d+&?/, '#')}`);
  const why = !game ? 'it is not among the games of this page' : game.replay ? `its replay is ${game.replay}` : NOT_KEPT;
  find('notice').textContent = `Game ${id} is not in this page: ${why}`;
  find('notice').hidden = false;
}
