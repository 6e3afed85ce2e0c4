// The page of a league: everything is drawn from one object, which comes with the page or by server-sent events.

import { GameFrame } from '../view/gameframe.js';
import { Theme } from '../view/theme.js';
import { loadLibrary } from '../view/unpack.js';
import { drawBot } from './bot.js';
import { connectMatrix, drawCross } from './cross.js';
import { drawGames, options, tellMissing, titleOf } from './games.js';
import { drawRatings } from './ratings.js';
import { drawTable, drawWorkers } from './table.js';
import { find, fixed, state, thousands } from './words.js';

const PAGE_OF_GAMES = 100;

/** Looks at a bot: its card, and its games. */
function choose(bot) {
  state.bot = bot ? bot.version : 0;
  find('bot').value = bot ? String(bot.version) : '';
  drawBot(() => choose(null));
  drawGames();
  if (bot) find('bot-card').scrollIntoView({ block: 'nearest' });
}

function drawAll() {
  const { league } = state;
  const failed = Math.round(league.bots.reduce((sum, bot) => sum + (bot.allFailed ?? 0), 0) / (league.players ?? 1));
  const left = [[league.repeats, 'only repeat earlier ones'], [league.again, 'were played again'], [league.forgiven, 'were forgiven'],
    [league.without - (league.forgiven ?? 0), 'have no result'], [failed, 'failed for all']]
    .filter(([count]) => count).map(([count, words]) => `${thousands(count)} ${words}`);
  const all = league.games + (league.repeats ?? 0) + league.again + league.without + failed;
  find('scene').textContent = `${thousands(all)} games of ${league.scene}`
    + (left.length ? `: ${[`${thousands(league.games)} count`, ...left].join(', ')}` : '')
    + (league.rate ? `, ${fixed(league.rate, league.rate < 10 ? 2 : 0)} a second` : '');
  drawTable(choose);
  drawWorkers();
  drawCross(choose);
  drawRatings();
  options(find('bot'), 'any');
  options(find('against'), 'any');
  drawBot(() => choose(null));
  drawGames();
  if (!isFollowed) frame.follow();
  isFollowed = true;
  window.steward.drawn = (window.steward.drawn ?? 0) + 1;
  window.steward.ready = true;
}

function follow(feed) {
  document.body.classList.add('live');
  const source = new EventSource(feed);
  source.onmessage = event => {
    find('notice').hidden = true;
    state.league = JSON.parse(event.data);
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
      find('notice').hidden = true;
      follow(feed);
    });
    find('notice').replaceChildren(`${event.data} `, button);
    find('notice').hidden = false;
    window.steward.ready = true;
  });
  source.onerror = () => {
    find('notice').textContent = 'The league is no longer being played, or this page cannot reach it.';
    find('notice').hidden = false;
    document.body.classList.remove('live');
  };
  source.onopen = () => document.body.classList.add('live');
}

window.steward = { get league() { return state.league; } };
state.shown = PAGE_OF_GAMES;
let theme = null;
theme = new Theme(() => {
  state.isDark = theme?.isDark ?? true;
  if (state.league) drawAll();
});
state.isDark = theme.isDark;
find('theme').addEventListener('click', () => theme.toggle());
find('filter').addEventListener('submit', event => event.preventDefault());
find('filter').addEventListener('change', () => {
  state.shown = PAGE_OF_GAMES;
  drawGames();
});
find('more').addEventListener('click', () => {
  state.shown += 5 * PAGE_OF_GAMES;
  drawGames();
});
connectMatrix(find('cross'));
connectMatrix(find('better'));
let resized = 0;
addEventListener('resize', () => {
  cancelAnimationFrame(resized);
  resized = requestAnimationFrame(() => {
    if (!state.league) return;
    drawRatings();
    drawCross(choose);
  });
});

const frame = new GameFrame({ data: () => state.league, title: titleOf, missing: tellMissing });
let isFollowed = false;

loadLibrary().then(() => {
  const data = find('data').textContent;
  if (data.trim()) {
    state.league = JSON.parse(data);
    drawAll();
  }
  if (document.body.dataset.feed) follow(document.body.dataset.feed);
});
