// Opens the replay of a game that is in this page, at the moment of the link.

import { GameFrame } from '../view/gameframe.js';

const data = JSON.parse(document.getElementById('data').textContent);
const frame = new GameFrame({ data: () => data,
  title: game => document.querySelector(`[data-game="${game}"]`)?.getAttribute('data-title') ?? `Game ${game}`, missing: () => {} });
frame.follow();
