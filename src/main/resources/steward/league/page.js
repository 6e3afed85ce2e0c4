// The page of a league: everything is drawn from one object, which comes with the page or by server-sent events.

// Okabe and Ito's colours, told apart with every kind of colour vision; the darker set is for light ground.
const ON_DARK = ['#56b4e9', '#f0a030', '#2fc79b', '#e08fbf', '#f0e442', '#ef7a45', '#a9b8ff', '#b5d96b'];
const ON_LIGHT = ['#0072b2', '#d55e00', '#00795a', '#a8417c', '#7a6a00', '#3d4a57', '#4b46b8', '#4d7a00'];
const PAGE_OF_GAMES = 100;
const SVG = 'http://www.w3.org/2000/svg';

const element = id => document.getElementById(id);
const isDark = () => {
  const chosen = document.documentElement.dataset.theme;
  return chosen ? chosen === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
};

let league = null;
let shown = PAGE_OF_GAMES;

function make(parent, tag, content, className) {
  const made = document.createElement(tag);
  if (content !== undefined && content !== null) made.textContent = content;
  if (className) made.className = className;
  parent.append(made);
  return made;
}

function draw(parent, tag, values, content) {
  const made = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(values)) made.setAttribute(name, value);
  if (content !== undefined) made.textContent = content;
  parent.append(made);
  return made;
}

/** A bot keeps its colour while ranks change: it goes by the number of its version. */
function paint(node, bot) {
  const colours = isDark() ? ON_DARK : ON_LIGHT;
  node.style.setProperty('--bot', colours[(bot.version - 1) % colours.length]);
  return node;
}

const fixed = (value, decimals) => value === null || value === undefined ? '–' : value.toFixed(decimals);
const signed = value => (Math.round(value) > 0 ? '+' : Math.round(value) < 0 ? '−' : '±') + Math.abs(Math.round(value));
/** A bar with one end: of a bot that has won or lost nearly everything. */
const bounded = bot => bot.bound !== null && bot.bound !== undefined;
const bound = (value, end) => `${value > 0 ? '>' : '<'} ${Math.round(end)}`;
const plusMinus = bar => bar === null || bar === undefined ? '' : ` ± ${Math.round(bar)}`;
const thousands = value => value.toLocaleString('en-US').replaceAll(',', '\u2009');

function heads(table, names) {
  const head = table.tHead;
  head.replaceChildren();
  const row = make(head, 'tr');
  for (const [name, className, title] of names) {
    const cell = make(row, 'th', name, className);
    cell.scope = 'col';
    if (title) cell.title = title;
  }
}

function nameCell(row, bot) {
  const cell = make(row, 'td', null, 'name');
  paint(make(cell, 'i', null, 'dot'), bot);
  cell.append(bot.name);
  if (bot.random) make(cell, 'span', 'random', 'tag').title = 'draws by lot: its games cannot be played again alike';
  if (!bot.active) make(cell, 'span', 'out', 'tag').title = 'plays no more';
  return cell;
}

function drawTable() {
  const table = element('table');
  heads(table, [['#', 'num'], ['Bot', 'name'], ['Rating', ''], ['±', '', '95% bar, for a number of games fixed before'],
    ['', 'bars'], ['± anytime', 'table-wide', '95% bar that holds however often one looks and whenever one stops'],
    ['Ranks', '', 'what the games leave open, with 95%'], ['Games', ''],
    ['Points', '', 'share of the points'], ['Faults', ''],
    ['All failed', 'table-wide', 'games in which all players failed in the same turn: they count in no rating'], ['Mean ms', 'table-wide', 'mean answer time'],
    ['Worst ms', 'table-wide', 'longest answer'], ['Score', 'table-wide', 'the game’s own, mean']]);
  const body = table.tBodies[0];
  body.replaceChildren();
  const played = league.bots.filter(bot => bot.games > 0);
  // A bar of which nothing is known is null, and not drawn.
  const wide = bot => bot.bar === null ? 0 : Math.min(bot.anytime ?? 3 * bot.bar, 3 * bot.bar);
  const low = Math.min(0, ...played.map(bot => bot.rating - wide(bot)));
  const high = Math.max(0, ...played.map(bot => bot.rating + wide(bot)));
  const place = value => 1 + 98 * (value - low) / Math.max(1, high - low);
  for (const bot of league.bots) {
    const row = make(body, 'tr', null, bot.active ? '' : 'out');
    make(row, 'td', bot.rank, 'num');
    nameCell(row, bot);
    make(row, 'td', bot.games ? signed(bot.rating) : '–');
    const bar = make(row, 'td', !bot.games ? '–' : bounded(bot) ? bound(bot.rating, bot.bound) : bot.bar !== null ? Math.round(bot.bar) : '–');
    if (bot.games && bar.textContent === '–') bar.title = 'Too few games for a bar or a bound';
    const cell = make(row, 'td', null, 'bars');
    if (bot.games) {
      const svg = draw(paint(cell, bot), 'svg', { viewBox: '0 0 100 18', preserveAspectRatio: 'none', role: 'img',
        'aria-label': signed(bot.rating) + plusMinus(bot.bar)
          + (bounded(bot) ? `, surely ${bound(bot.rating, bot.bound)}` : '') });
      draw(svg, 'line', { x1: place(0), x2: place(0), y1: 0, y2: 18, 'vector-effect': 'non-scaling-stroke' });
      draw(svg, 'line', { class: 'anytime', x1: place(bot.rating - wide(bot)), x2: place(bot.rating + wide(bot)), y1: 9, y2: 9,
        'vector-effect': 'non-scaling-stroke' });
      const left = place(bot.rating - bot.bar);
      if (bot.bar !== null) draw(svg, 'rect', { x: left, y: 5, width: Math.max(0.4, place(bot.rating + bot.bar) - left), height: 8, rx: 1 });
      draw(svg, 'rect', { x: place(bot.rating) - 0.5, y: 2, width: 1, height: 14 }).style.opacity = 1;
    }
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
  element('meaning').textContent = 'Rating: Elo by a joint fit of all games; 0 is the mean by games. The '
    + 'band is its 95% bar for a number of games that was fixed before, the line the one that holds however often one looks '
    + 'and whenever one stops. Ranks: what the games leave open, with 95%.'
    + (league.repeats ? ` ${league.repeats} more games only repeat earlier ones and do not count.` : '')
    + (league.again ? ` ${league.again} more games were played again, since others used the processors.` : '')
    + (league.without ? ` ${league.without} more have no result.` : '');
}

/** A number of percent for every two bots; 50 is the colour of the ground. */
function drawMatrix(table, value, title, mark) {
  heads(table, [['', 'name'], ...league.bots.map(bot => ['#' + bot.rank, '', bot.name])]);
  const body = table.tBodies[0];
  body.replaceChildren();
  league.bots.forEach((bot, i) => {
    const row = make(body, 'tr');
    const name = nameCell(row, bot);
    name.prepend(`${bot.rank} `);
    league.bots.forEach((other, j) => {
      const share = i === j ? null : value(i, j);
      const td = make(row, 'td', i === j ? '·' : share === null ? '–' : Math.round(100 * share), i === j ? 'self' : '');
      if (share !== null) {
        const strength = Math.abs(share - 0.5) * 1.3;
        td.style.background = `rgb(from var(${share >= 0.5 ? '--win-c' : '--loss-c'}) r g b / ${strength})`;
        td.title = title(bot, other, i, j);
        if (mark(i, j)) td.classList.add('surprise');
      }
    });
  });
}

function drawCross() {
  const surprises = league.surprises ?? [];
  const isSurprise = (i, j) => surprises.some(each => each[0] === i && each[1] === j || each[0] === j && each[1] === i);
  drawMatrix(element('cross'), (i, j) => league.cross[i][j]?.[0] ?? null,
    (bot, other, i, j) => `${bot.name} against ${other.name}: ${fixed(100 * league.cross[i][j][0], 1)}% of `
      + `${thousands(league.cross[i][j][1])} games`, isSurprise);
  const list = element('surprises');
  list.replaceChildren();
  for (const [i, j, share, expected] of surprises.slice(0, 10)) {
    const digits = Math.round(100 * share) === Math.round(100 * expected) ? 1 : 0;
    make(list, 'li', `${league.bots[i].name} beats ${league.bots[j].name} more than ratings tell: `
      + `${fixed(100 * share, digits)}%, where they tell ${fixed(100 * expected, digits)}%.`);
  }
  const differences = league.differences ?? [];
  drawMatrix(element('better'), (i, j) => differences[i]?.[j]?.[3] ?? null,
    (bot, other, i, j) => `${bot.name} − ${other.name}: ${signed(differences[i][j][0])}`
      + `${plusMinus(differences[i][j][1])}${typeof differences[i][j][4] === 'number'
        ? `, surely ${bound(differences[i][j][0], differences[i][j][4])},` : ''} Elo, anytime${plusMinus(differences[i][j][2]) || ' –'}`, () => false);
}

/** Those that play on other machines. */
function drawWorkers() {
  const workers = league.workers ?? [];
  element('workers-card').hidden = !workers.length;
  const table = element('workers');
  heads(table, [['Worker', 'name'], ['State', 'left'], ['Games', ''], ['Games/s', '', 'in this run'], ['Faults', '', 'of bots'],
    ['Hiccups', '', 'games played again, since others used its processors'], ['Set aside', '', 'games that do not count'],
    ['Version', 'table-wide'], ['Last word', 'table-wide']]);
  const body = table.tBodies[0];
  body.replaceChildren();
  const list = element('doubts');
  list.replaceChildren();
  for (const worker of workers) {
    const row = make(body, 'tr');
    const cell = make(row, 'td', worker.name, 'name');
    if (worker.doubts.length) make(cell, 'span', 'doubtful', 'tag faulty').title = worker.doubts.join('; ');
    make(row, 'td', worker.state || '–', worker.state === 'caught' ? 'left faulty' : 'left');
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

/** Round steps of 1, 2 or 5 with a power of ten. */
function ticks(low, high, most) {
  const rough = (high - low) / most;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map(each => each * power).find(each => each >= rough);
  const all = [];
  for (let value = Math.ceil(low / step) * step; value <= high; value += step) all.push(value);
  return all;
}

function drawPath() {
  const box = element('path');
  const points = league.path.points;
  box.replaceChildren();
  if (points.length < 2) {
    make(box, 'p', 'There are too few games yet.', 'note');
    return;
  }
  const bots = league.bots.filter(bot => league.path.versions.includes(bot.version)).slice(0, ON_DARK.length);
  const columns = bots.map(bot => league.path.versions.indexOf(bot.version));
  const width = Math.max(320, Math.min(900, box.clientWidth || 600));
  const height = Math.round(Math.max(220, width * 0.52));
  const margin = { left: 48, right: Math.min(130, width * 0.24), top: 8, bottom: 24 };
  const last = points[points.length - 1];
  // The first few games say little and would fill the plot with their bars.
  const settled = points.filter(point => point.games >= last.games * 0.05);
  const all = settled.flatMap(point => columns.map(k => point.ratings[k]).filter(value => value !== null));
  const low = Math.min(...all) - 30, high = Math.max(...all) + 30;
  const x = games => margin.left + (width - margin.left - margin.right) * games / last.games;
  const y = rating => margin.top + (height - margin.top - margin.bottom) * (high - rating) / (high - low);
  const clip = value => Math.max(low, Math.min(high, value));
  const svg = draw(box, 'svg', { viewBox: `0 0 ${width} ${height}`, role: 'img',
    'aria-label': 'Rating of each bot over the number of games; the table says how it ends' });
  for (const tick of ticks(low, high, 6)) {
    draw(svg, 'line', { class: tick === 0 ? 'zero' : 'axis', x1: margin.left, x2: width - margin.right, y1: y(tick), y2: y(tick) });
    draw(svg, 'text', { x: margin.left - 6, y: y(tick) + 4, 'text-anchor': 'end' }, tick === 0 ? '0' : signed(tick));
  }
  for (const tick of ticks(0, last.games, width < 500 ? 3 : 5)) {
    draw(svg, 'text', { x: x(tick), y: height - 6, 'text-anchor': 'middle' }, thousands(tick));
  }
  const labels = [];
  // Bars as wide as the plot would only hide the lines.
  const bars = columns.map(k => last.bars[k]).filter(bar => bar !== null);
  const hasBands = bars.length > 0 && Math.max(...bars) < (high - low) / 4;
  bots.forEach((bot, place) => {
    const k = columns[place];
    const line = points.filter(point => point.ratings[k] !== null);
    if (!line.length) return;
    const group = paint(draw(svg, 'g', {}), bot);
    const banded = hasBands ? settled.filter(point => point.ratings[k] !== null && point.bars[k] !== null) : [];
    const upper = banded.map(point => `${x(point.games)},${y(clip(point.ratings[k] + point.bars[k]))}`);
    const lower = banded.map(point => `${x(point.games)},${y(clip(point.ratings[k] - point.bars[k]))}`).reverse();
    draw(group, 'polygon', { class: 'band', points: [...upper, ...lower].join(' ') });
    draw(group, 'path', { d: 'M' + line.map(point => `${x(point.games)},${y(clip(point.ratings[k]))}`).join('L') });
    labels.push({ bot, y: y(clip(line[line.length - 1].ratings[k])) });
  });
  // Names stand beside the ends of their lines, pushed apart where these are close.
  labels.sort((a, b) => a.y - b.y);
  labels.forEach((label, k) => { if (k) label.y = Math.max(label.y, labels[k - 1].y + 14); });
  const over = labels.length ? Math.max(0, labels[labels.length - 1].y - (height - margin.bottom)) : 0;
  const room = Math.floor((margin.right - 20) / 7);
  for (const label of labels) {
    const name = label.bot.name.length > room ? label.bot.name.slice(0, room - 1) + '…' : label.bot.name;
    const group = paint(draw(svg, 'g', {}), label.bot);
    draw(group, 'circle', { cx: width - margin.right + 7, cy: label.y - over, r: 4, fill: 'var(--bot)' });
    draw(group, 'text', { class: 'label', x: width - margin.right + 15, y: label.y - over + 4 }, name);
  }
}

function options(select, first) {
  const before = select.value;
  select.replaceChildren();
  make(select, 'option', first).value = '';
  for (const bot of league.bots) make(select, 'option', bot.name).value = bot.version;
  select.value = before;
  if (select.selectedIndex < 0) select.value = '';
}

function isShown(game) {
  const bot = Number(element('bot').value), against = Number(element('against').value);
  const result = element('result').value;
  if (element('kept').checked && !game.replay) return false;
  const seats = game.seats.filter(seat => !bot || seat.version === bot);
  if (!seats.length || against && !game.seats.some(seat => seat.version === against && (!bot || seat !== seats[0]))) {
    return false;
  }
  const first = game.seats.filter(seat => seat.rank === 0).length;
  return !result || result === 'failed' && (bot ? seats : game.seats).some(seat => seat.fault)
    || game.counts && seats.some(seat => result === 'won' && seat.rank === 0 && first === 1
      || result === 'drawn' && seat.rank === 0 && first > 1 || result === 'lost' && seat.rank > 0);
}

function drawGames() {
  const table = element('games');
  heads(table, [['Game', 'num'], ['Bots, best first', 'left'], ['Turns', ''], ['Seed', 'table-wide'], ['Replay', '']]);
  const body = table.tBodies[0];
  body.replaceChildren();
  const found = league.list.filter(isShown);
  const names = new Map(league.bots.map(bot => [bot.version, bot]));
  for (const game of found.slice(0, shown)) {
    const row = make(body, 'tr');
    make(row, 'td', game.id, 'num');
    const cell = make(row, 'td', null, 'left');
    const first = game.seats.filter(seat => seat.rank === 0).length;
    [...game.seats].sort((a, b) => a.rank - b.rank).forEach((seat, k) => {
      if (k) cell.append(game.counts && first > 1 ? ' = ' : ' · ');
      const bot = names.get(seat.version);
      if (bot) paint(make(cell, 'i', null, 'dot'), bot);
      make(cell, 'span', bot ? bot.name : '?', game.counts && seat.rank === 0 && first === 1 ? 'win' : '');
      if (seat.fault) make(cell, 'span', 'failed', 'tag faulty').title = seat.fault;
    });
    if (game.problem) make(cell, 'span', 'no result', 'tag faulty').title = game.problem;
    else if (!game.counts) make(cell, 'span', 'played again', 'tag').title = 'others used the processors';
    make(row, 'td', game.turns);
    make(row, 'td', game.seed, 'table-wide');
    const last = make(row, 'td');
    if (game.replay === 'live') {
      const link = make(last, 'a', 'Watch', 'link');
      link.href = `replay/${game.id}`;
      link.target = '_blank';
      link.rel = 'noopener';
    } else if (game.replay === 'page') {
      make(last, 'button', 'Watch', 'link').addEventListener('click', () => watch(game, names));
    } else if (game.replay) {
      make(last, 'span', 'on disk').title = game.replay;
    }
  }
  element('count').textContent = `${thousands(found.length)} of the last ${thousands(league.list.length)} games`;
  element('more').hidden = found.length <= shown;
}

/** Opens a replay that is in this page: the page of a match, put together here. */
function watch(game, names) {
  const escape = text => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');
  const title = game.seats.map(seat => names.get(seat.version)?.name ?? '?').join(' against ');
  const page = league.shell.before.replaceAll('{{title}}', escape(title)) + league.replays[game.id] + league.shell.after;
  const address = URL.createObjectURL(new Blob([page], { type: 'text/html' }));
  window.steward.opened = address;
  window.open(address, '_blank');
}

function drawAll() {
  element('scene').textContent = `${thousands(league.games)} games of ${league.scene}`
    + (league.rate ? `, ${fixed(league.rate, league.rate < 10 ? 2 : 0)} a second` : '');
  drawTable();
  drawWorkers();
  drawCross();
  drawPath();
  options(element('bot'), 'any');
  options(element('against'), 'any');
  drawGames();
  window.steward.drawn = (window.steward.drawn ?? 0) + 1;
  window.steward.ready = true;
}

function follow(feed) {
  document.body.classList.add('live');
  const source = new EventSource(feed);
  source.onmessage = event => {
    element('notice').hidden = true;
    league = JSON.parse(event.data);
    drawAll();
  };
  source.addEventListener('end', () => {
    source.close();
    document.body.classList.remove('live');
  });
  source.addEventListener('refused', event => {
    source.close();
    document.body.classList.remove('live');
    const button = document.createElement('button');
    button.textContent = 'Connect again';
    button.addEventListener('click', () => {
      element('notice').hidden = true;
      follow(feed);
    });
    element('notice').replaceChildren(`${event.data} `, button);
    element('notice').hidden = false;
    window.steward.ready = true;
  });
  source.onerror = () => {
    element('notice').textContent = 'The league is no longer being played, or this page cannot reach it.';
    element('notice').hidden = false;
    document.body.classList.remove('live');
  };
  source.onopen = () => document.body.classList.add('live');
}

window.steward = { get league() { return league; } };
element('theme').addEventListener('click', () => {
  document.documentElement.dataset.theme = isDark() ? 'light' : 'dark';
  if (league) drawAll();
});
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => { if (league) drawAll(); });
element('filter').addEventListener('submit', event => event.preventDefault());
element('filter').addEventListener('change', () => { shown = PAGE_OF_GAMES; drawGames(); });
element('more').addEventListener('click', () => { shown += 5 * PAGE_OF_GAMES; drawGames(); });
let resized = 0;
addEventListener('resize', () => {
  cancelAnimationFrame(resized);
  resized = requestAnimationFrame(() => { if (league) drawPath(); });
});

const data = element('data').textContent;
if (data.trim()) {
  league = JSON.parse(data);
  drawAll();
}
if (document.body.dataset.feed) follow(document.body.dataset.feed);
