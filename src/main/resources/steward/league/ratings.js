// Ratings over games, of all bots: a click on a name hides or shows its line, the pointer says the values.

import { wholeTicks } from '../view/ticks.js';
import { colourOf, find, make, paint, signed, state, thousands } from './words.js';

const EARLY = 0.05;             // of the games: so few say little and would fill the plot with their bars
const SPACE = 30;               // Elo above and below
const MOST_BANDS = 6;           // bars of more lines hide each other
const COLOURS = 16;             // of so many lines; further ones are dashed

const hidden = new Set();
let plot = null;

export function drawRatings() {
  const { league } = state;
  const box = find('path');
  const points = league.path.points.filter((point, k, all) => point.games !== all[k + 1]?.games);     // repeats count once
  plot?.destroy();
  plot = null;
  box.replaceChildren();
  if (points.length < 2) {
    make(box, 'p', 'There are too few games yet.', 'note');
    return;
  }
  const bots = league.bots.filter(bot => league.path.versions.includes(bot.version));
  const columns = bots.map(bot => league.path.versions.indexOf(bot.version));
  const last = points[points.length - 1];
  const settled = points.filter(point => point.games >= last.games * EARLY);
  const seen = settled.flatMap(point => columns.map(k => point.ratings[k]).filter(value => value !== null));
  const [low, high] = [Math.min(0, ...seen) - SPACE, Math.max(0, ...seen) + SPACE];
  const values = bots.map((_, place) => points.map(point => point.ratings[columns[place]]));
  const shownBots = bots.filter(bot => !hidden.has(bot.version));
  const hasBands = shownBots.length <= MOST_BANDS;
  // A band that is wider than the chart would only paint it.
  const isDrawn = (point, bar) => bar !== null && 2 * bar < high - low && point.games >= last.games * EARLY;
  const bars = hasBands ? bots.flatMap((bot, place) => (hidden.has(bot.version) ? [] : [1, -1].map(sign => points.map((point, k) =>
    (values[place][k] === null || !isDrawn(point, point.bars[columns[place]]) ? null
      : values[place][k] + sign * point.bars[columns[place]]))))) : [];
  const isLeftOut = hasBands && shownBots.some(bot => !isDrawn(last, last.bars[league.path.versions.indexOf(bot.version)]));
  const style = getComputedStyle(box);
  const axis = { stroke: style.getPropertyValue('color'), font: '11px system-ui, sans-serif',
    grid: { stroke: 'rgb(128 140 160 / 18%)', width: 1 }, ticks: { show: false } };
  const legend = make(box, 'div', null, 'chips');
  const area = make(box, 'div');
  const size = () => ({ width: Math.max(280, box.clientWidth), height: Math.round(Math.max(260, Math.min(460, box.clientWidth * 0.36))) });
  plot = new uPlot({
    ...size(), legend: { show: false }, padding: [8, 28, 0, 0],
    cursor: { y: false, drag: { x: false, y: false }, focus: { prox: 24 }, points: { size: 6 } },
    focus: { alpha: 0.25 },
    hooks: { setCursor: [self => tell(self, bots, points, values)] },
    scales: { x: { time: false }, y: { range: [low, high] } },
    axes: [{ ...axis, size: 24, splits: wholeTicks, values: (_, splits) => splits.map(thousands) },
      { ...axis, size: 50, values: (_, splits) => splits.map(value => (value === 0 ? '0' : signed(value))) }],
    bands: hasBands ? shownBots.map((bot, k) => ({ series: [1 + bots.length + 2 * k, 2 + bots.length + 2 * k],
      fill: `color-mix(in srgb, ${colourOf(bot.version)} 14%, transparent)` })) : [],
    series: [{}, ...bots.map(bot => ({ label: bot.name, stroke: colourOf(bot.version), width: 2, dash: bot.version > COLOURS ? [6, 3] : [], spanGaps: true,
      show: !hidden.has(bot.version), points: { show: false } })),
      ...bars.map(() => ({ stroke: 'transparent', width: 0, points: { show: false } }))],
  }, [points.map(point => point.games), ...values, ...bars], area);
  plot.root.setAttribute('role', 'img');
  plot.root.setAttribute('aria-label', 'Rating of each bot over the number of games; the table says how it ends');
  const words = make(box, 'p', null, 'note');
  words.id = 'path-words';
  words.textContent = `A click on a name hides its line.${isLeftOut
    ? ' A band that is not drawn is wider than the chart, or not known: there are too few games.' : ''}`;
  for (const bot of bots) {
    const chip = make(legend, 'button', null, 'chip');
    paint(make(chip, 'i', null, 'dot'), bot);
    chip.append(bot.name);
    chip.setAttribute('aria-pressed', String(!hidden.has(bot.version)));
    chip.addEventListener('click', () => {
      if (!hidden.delete(bot.version)) hidden.add(bot.version);
      drawRatings();
    });
  }
}

function tell(self, bots, points, values) {
  const k = self.cursor.idx;
  const box = find('path-words');
  if (!box || k === null || k === undefined) return;
  const told = bots.map((bot, place) => [bot, values[place][k]]).filter(([bot, value]) => value !== null && !hidden.has(bot.version))
    .sort((one, other) => other[1] - one[1]).map(([bot, value]) => `${bot.name} ${signed(value)}`);
  box.textContent = `${thousands(points[k].games)} games: ${told.join(' · ')}`;
}
