// The page of a series: results by seed and side, answer times, failures; kept replays are one click away.

import { GameFrame } from '../view/gameframe.js';

const find = id => document.getElementById(id);
const series = JSON.parse(find('data').textContent);
const names = series.bots.map(bot => bot.name);
const times = new Map(series.list.map(game => [String(game.game), game]));
const repeats = new Set(series.repeats);
const fixed = (value, digits) => (value === null || value === undefined ? '–' : value.toFixed(digits));
const counted = (count, word) => `${count} ${word}${count === 1 ? '' : 's'}`;
const percent = value => (value === null || value === undefined ? '–' : `${fixed(100 * value, 1)}%`);

function made(parent, tag, text = '', className = '') {
  const element = parent.appendChild(document.createElement(tag));
  element.textContent = text;
  element.className = className;
  return element;
}

function fill(id, heads, rows) {
  const table = /** @type {HTMLTableElement} */ (find(id));
  const head = made(table.tHead, 'tr');
  for (const text of heads) made(head, 'th', text).scope = 'col';
  for (const cells of rows) {
    const row = made(table.tBodies[0], 'tr');
    cells.forEach(text => made(row, 'td', text));
  }
}

/** How the first bot of the call, or the bot that plays alone, did in a game. */
function outcomeOf(game) {
  if (game.failure !== undefined) return { word: 'no result', className: 'failed' };
  const player = Math.max(0, game.order.indexOf(0));
  if (series.alone) return { word: `score ${+game.scores[0].toFixed(2)}`, className: '' };
  const [rank, first] = [game.ranks[player], game.ranks.filter(each => each === 0).length];
  if (rank === 0) return first === 1 ? { word: 'won', className: 'won' } : { word: 'drawn', className: 'drawn' };
  return { word: game.ranks.length === 2 ? 'lost' : `place ${rank + 1} of ${game.ranks.length}`, className: 'lost' };
}

const hasFailed = game => game.failure !== undefined || game.faults.some(fault => fault !== null);
const titleOf = id => times.get(id)?.order.map(entrant => names[entrant]).join(' against ') ?? `Game ${id}`;
const isThere = game => series.replays[game.game] || series.linked[game.game];

/** The option that would have kept the replay of a game. */
function whyMissing(game) {
  if (!series.folder) return '--out DIR keeps the replays of all games, and this page has them then';
  return game?.replay ? `its replay, ${game.replay}, cannot be read or is one of too many: steward replay FILE --view shows it`
    : `--keep ${series.keep} did not keep its replay; --keep all keeps all`;
}

function drawSides() {
  if (series.alone || !series.swap || names.length !== 2) return;
  const rows = [0, 1].map(side => {
    const of = series.list.filter(game => game.order[side] === 0 && game.failure === undefined);
    const count = word => String(of.filter(game => outcomeOf(game).word === word).length);
    return [`${names[0]} as player ${side}`, String(of.length), count('won'), count('drawn'), count('lost')];
  });
  fill('sides', ['Side', 'Games', 'Won', 'Drawn', 'Lost'], rows);
  find('sides-card').hidden = false;
}

function drawFailures() {
  for (const kind of series.failures) {
    const line = made(find('failures'), 'li');
    line.append(`${names[kind.bot]}, ${kind.games} ${kind.games === 1 ? 'game' : 'games'}: ${kind.fault} · `);
    linkTo(line, times.get(String(kind.game)), `game ${kind.game}, seed ${kind.seed}`);
  }
  for (const game of series.list.filter(each => each.failure !== undefined)) {
    made(find('failures'), 'li', `Game ${game.game}, seed ${game.seed}, has no result: ${game.failure}`);
  }
  find('failures-card').hidden = !find('failures').childElementCount;
}

/** A link to a game whose replay is there, at the turn in which a bot failed; otherwise its words say why not. */
function linkTo(parent, game, words, className = '') {
  if (!game || !isThere(game)) {
    made(parent, 'span', words, className).title = whyMissing(game);
    return;
  }
  const failed = (game.faults ?? []).findIndex(fault => fault !== null);
  const link = made(parent, 'a', words, className);
  link.href = `#game=${game.game}${failed < 0 ? '' : `&fault=${failed}`}`;
}

function cellOf(row, game) {
  const cell = made(row, 'td');
  if (!game) return;
  const { word, className } = outcomeOf(game);
  linkTo(cell, game, word, className);
  if (game.failure !== undefined) return;
  cell.append(` · ${counted(game.turns, 'turn')}${repeats.has(game.game) ? ' · repeats an earlier game' : ''}`);
  game.faults.forEach((fault, player) => {
    if (fault !== null) made(cell, 'div', `${names[game.order[player]]} failed in turn ${game.faultTurns[player]}: ${fault}`, 'failed');
  });
}

function drawGames() {
  const which = /** @type {HTMLSelectElement} */ (find('which')).value;
  const shown = series.list.filter(game => !which || which === 'failed' && hasFailed(game)
    || outcomeOf(game).word === which || which === 'lost' && outcomeOf(game).className === 'lost');
  const table = /** @type {HTMLTableElement} */ (find('games'));
  table.tHead.replaceChildren();
  table.tBodies[0].replaceChildren();
  const sides = [...new Set(series.list.map(game => game.order.join()))].sort();
  const head = made(table.tHead, 'tr');
  for (const text of ['Seed', ...sides.map(side => side.split(',').map(entrant => names[entrant]).join(' against '))]) made(head, 'th', text).scope = 'col';
  const seeds = new Map();
  for (const game of shown) seeds.set(game.seed, [...seeds.get(game.seed) ?? [], game]);
  for (const [seed, games] of seeds) {
    const row = made(table.tBodies[0], 'tr');
    made(row, 'td', seed);
    for (const side of sides) cellOf(row, games.find(game => game.order.join() === side));
  }
  find('count').textContent = `${shown.length} of ${series.list.length}`;
}

const missing = series.list.filter(game => !isThere(game)).length;
find('scene').textContent = `${counted(series.games, 'game')} of ${series.scene}, ${counted(series.seeds, 'seed')}`
  + `${series.swap ? ', sides changed' : ''}${series.games < series.planned ? `; ${series.planned} were planned` : ''}`;
const heads = series.alone ? ['Bot', 'Games', 'Mean score', 'Failed'] : ['Bot', 'Points', '95%', 'Won', 'Drawn', 'Lost', 'Failed'];
fill('bots', heads, series.bots.map((bot, index) => {
  if (series.alone) return [bot.name, String(series.list.filter(game => game.order[0] === index).length), fixed(bot.meanScore, 2), String(bot.faults)];
  const interval = bot.interval95.length ? bot.interval95.map(percent).join(' to ') : '–';
  return [bot.name, percent(bot.points), interval, String(bot.wins), String(bot.draws), String(bot.losses), String(bot.faults)];
}));
fill('times', ['Bot', 'Mean', '99 of 100', 'Worst', 'In game', 'First, worst'], series.times.map((time, bot) => {
  const where = time.worstGame === null ? '–' : `${time.worstGame}, turn ${time.worstTurn}`;
  return [names[bot], fixed(time.mean, 2), fixed(time.p99, 2), fixed(time.worst, 2), where, fixed(time.worstFirst, 1)];
}));
drawSides();
drawFailures();
drawGames();
if (missing) {
  const none = missing === series.list.length ? 'No replay is in this page' : `${counted(missing, 'replay')} of ${series.list.length} are not in this page`;
  find('kept').textContent = `${none}: ${whyMissing(series.list.find(game => !isThere(game)))}.`;
  find('kept').hidden = false;
}
find('filter').addEventListener('submit', event => event.preventDefault());
find('which').addEventListener('change', drawGames);
const frame = new GameFrame({ data: () => series, title: titleOf, missing: id => {
  find('notice').textContent = `Game ${id} is not in this page: ${times.has(id) ? whyMissing(times.get(id)) : `the series has games 1 to ${series.list.length}`}`;
  find('notice').hidden = false;
} });
window.steward = { ready: true };
frame.follow();
