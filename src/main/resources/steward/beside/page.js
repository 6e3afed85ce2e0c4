// Two matches side by side by one clock: the turns that differ, and in which commands and states.

import { pageOf } from '../view/gameframe.js';

const TURNS_PER_SECOND = 5;
const MOST_ROWS = 200;
const LONGEST_FRAME = 0.25;     // seconds
const LINK_MS = 1000;

const find = id => document.getElementById(id);
const data = JSON.parse(find('data').textContent);
const shell = { before: data.shell[0], after: data.shell[1] };
const frames = [0, 1].map(k => /** @type {HTMLIFrameElement} */ (find(`match-${k}`)));
const clock = { time: 0, end: 0, playing: false, last: 0, linked: 0, shown: NaN };
let matches = [];               // the hooks of both pages

/** Puts a match into its frame, without controls and details, and waits for it. */
async function open(frame, k) {
  frame.name = JSON.stringify({ steward: location.href, link: '#t=0' });
  frame.srcdoc = pageOf(shell, [data.replays[k], data.details[k]], data.files[k]);
  await new Promise(done => frame.addEventListener('load', done, { once: true }));
  while (!frame.contentWindow['steward']?.ready) await new Promise(done => setTimeout(done, 50));
  const problem = frame.contentDocument.body.dataset.problem;
  if (problem) throw new Error(`${data.files[k]}: ${problem}`);
  frame.contentDocument.body.classList.add('bare');
  frame.contentWindow.addEventListener('keydown', onKey, true);
  return frame.contentWindow['steward'];
}

/** A value for people: objects as JSON, numbers as they are. */
const words = value => (value === undefined ? '–' : typeof value === 'object' && value !== null ? JSON.stringify(value) : String(value));

/** Pairs of rows that differ in a turn of both: commands and faults by player, then states by body and field. */
function differencesOf(turn) {
  const [one, other] = matches.map(each => each.match().turn(turn));
  if (!one || !other) return [];
  const rows = [];
  const compare = (name, a, b) => JSON.stringify(a) !== JSON.stringify(b) && rows.push([name, words(a), words(b)]);
  matches[0].match().players.forEach(({ name }, player) => {
    const [a, b] = [one, other].map((each, k) => (each.commands?.[player] ? matches[k].commandLines(turn, player).join('; ') : undefined));
    compare(`${name}: command`, a, b);
    compare(`${name}: fault`, one.faults?.[player] ?? undefined, other.faults?.[player] ?? undefined);
  });
  if (one.hash === other.hash) return rows;                      // what is rounded for the page is no difference
  for (const id of new Set([...one.bodies.keys(), ...other.bodies.keys()])) {
    const [a, b] = [one.bodies.get(id) ?? {}, other.bodies.get(id) ?? {}];
    for (const field of new Set([...Object.keys(a), ...Object.keys(b)])) compare(`body ${id}: ${field}`, a[field], b[field]);
  }
  for (const field of new Set([...Object.keys(one.state ?? {}), ...Object.keys(other.state ?? {})])) {
    if (field !== 'bodies') compare(`state: ${field}`, one.state[field], other.state[field]);
  }
  return rows;
}

/** True if the turn is in both and is not the same. */
function differs(turn) {
  const [one, other] = matches.map(each => each.match().turn(turn));
  return Boolean(one && other) && (one.hash !== other.hash || JSON.stringify([one.commands, one.faults]) !== JSON.stringify([other.commands, other.faults]));
}

function listDifferences(turn) {
  if (turn === clock.shown) return;
  clock.shown = turn;
  const isOver = matches.some(each => turn > each.lastTurn());
  const rows = isOver ? [] : differencesOf(turn);
  if (!isOver && data.results.length > 0 && turn === matches[0].lastTurn()) rows.push(['result', ...data.results]);
  find('h-differs').textContent = isOver ? `Turn ${turn}: one match is over` : `${turn === 0 ? 'Start' : `Turn ${turn}`}: ${rows.length
    ? `${rows.length} ${rows.length === 1 ? 'difference' : 'differences'}` : 'no difference'}${data.first < 0 ? '' : ` · first turn that differs: ${data.first}`}`;
  const body = /** @type {HTMLTableElement} */ (find('differs')).tBodies[0];
  body.replaceChildren(...rows.slice(0, MOST_ROWS).map(cells => {
    const row = document.createElement('tr');
    for (const text of cells) row.appendChild(document.createElement('td')).textContent = text;
    return row;
  }));
}

function drawMarks() {
  const canvas = /** @type {HTMLCanvasElement} */ (find('marks'));
  const { width, height } = canvas.getBoundingClientRect();
  Object.assign(canvas, { width, height });
  const ctx = canvas.getContext('2d');
  const x = turn => 8 + (width - 16) * turn / Math.max(1, clock.end);
  canvas.style.color = 'var(--bad)';
  const bad = getComputedStyle(canvas).color;
  canvas.style.color = 'var(--muted)';
  const muted = getComputedStyle(canvas).color;
  ctx.fillStyle = bad;
  ctx.globalAlpha = 0.35;
  for (let turn = 1; turn <= clock.end; turn++) {
    if (differs(turn)) ctx.fillRect(x(turn - 1), height / 2, Math.max(1, x(turn) - x(turn - 1)), height / 2);
  }
  ctx.globalAlpha = 1;
  if (data.first >= 0) ctx.fillRect(x(data.first) - 1, 0, 3, height);
  ctx.fillStyle = muted;
  for (const each of matches) ctx.fillRect(x(each.lastTurn()) - 1, height / 2, 2, height / 2);
}

function show(time) {
  clock.time = Math.max(0, Math.min(clock.end, time));
  matches.forEach((each, k) => {
    each.show(Math.min(clock.time, each.lastTurn()));
    find(`name-${k}`).classList.toggle('is-over', clock.time >= each.lastTurn() && clock.time > 0);
  });
  /** @type {HTMLInputElement} */ (find('scrub')).value = String(clock.time);
  find('time').textContent = clock.time.toFixed(2);
  listDifferences(Math.ceil(clock.time - 1e-9));
  const now = performance.now();
  if (clock.playing && now - clock.linked < LINK_MS) return;
  clock.linked = now;
  history.replaceState(null, '', `#t=${clock.time.toFixed(2)}`);
}

function setPlaying(playing) {
  if (playing && clock.time >= clock.end) clock.time = 0;
  clock.playing = playing;
  find('play').textContent = playing ? 'Pause' : 'Play';
  clock.last = performance.now();
  if (playing) requestAnimationFrame(step);
  else show(clock.time);
}

function step(now) {
  if (!clock.playing) return;
  const seconds = Math.min(LONGEST_FRAME, Math.max(0, (now - clock.last) / 1000));
  clock.last = now;
  show(clock.time + seconds * TURNS_PER_SECOND * Number(/** @type {HTMLSelectElement} */ (find('speed')).value));
  if (clock.time >= clock.end) setPlaying(false);
  else requestAnimationFrame(step);
}

function seek(time) {
  if (clock.playing) setPlaying(false);
  show(time);
}

const ACTIONS = { ' ': () => setPlaying(!clock.playing), ArrowLeft: () => seek(Math.ceil(clock.time - 1e-9) - 1),
  ArrowRight: () => seek(Math.floor(clock.time + 1e-9) + 1), x: () => data.first >= 0 && seek(data.first), Home: () => seek(0), End: () => seek(clock.end) };

function onKey(event) {
  if (event.ctrlKey || event.altKey || event.metaKey || !ACTIONS[event.key]) return;
  if (event.target.matches?.('select, button') && event.key === ' ') return;
  event.preventDefault();
  event.stopPropagation();
  ACTIONS[event.key]();
}

function followLink(link) {
  const named = /^#t=(\d+(?:\.\d+)?)$/.exec(link);
  if (named && Math.abs(Number(named[1]) - clock.time) > 0.005) seek(Number(named[1]));
}

async function start() {
  window.steward = { ready: false };
  try {
    matches = await Promise.all(frames.map(open));
  } catch (problem) {
    find('notice').textContent = `The replays cannot be shown: ${problem.message}`;
    find('notice').hidden = false;
    throw problem;
  }
  clock.end = Math.max(...matches.map(each => each.lastTurn()));
  /** @type {HTMLInputElement} */ (find('scrub')).max = String(clock.end);
  data.files.forEach((name, k) => (find(`name-${k}`).textContent = `${name} · ${matches[k].lastTurn()} turns`));
  find('first').hidden = data.first < 0;
  find('scrub').addEventListener('input', event => seek(Number(/** @type {HTMLInputElement} */ (event.target).value)));
  document.querySelectorAll('[data-key]').forEach(button => button.addEventListener('click', () => ACTIONS[button.getAttribute('data-key')]()));
  document.addEventListener('keydown', onKey);
  addEventListener('hashchange', () => followLink(location.hash));
  addEventListener('resize', drawMarks);
  drawMarks();
  const link = location.hash;
  show(0);
  followLink(link);
  window.steward = { ready: true, matches, time: () => clock.time, seek, differences: differencesOf };
}

start();
