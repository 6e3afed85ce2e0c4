// Charts over the turns, by uPlot, with one cursor: a click goes to the turn, a line shows where the match stands.

import { areSteps, limitsOf } from './series.js';
import { element, grouped, nameOf } from './text.js';
import { FONT } from './draw.js';
import { wholeTicks } from './ticks.js';

const HEIGHT = 104;
const LEAST_MS = 0.001;

/** One chart: a heading with the values of the moment, and a plot. */
class Chart {
  charts; lists; isLog; limits; names; isWithin; plot; turns; shown;

  constructor(charts, { title, unit, lists, isLog = false, limits = [], names = [], isWithin = false }) {
    Object.assign(this, { charts, lists, isLog, limits, names, isWithin });
    this.values = element('span', 'chart-values');
    this.box = element('div', 'chart');
    this.root = element('figure', 'chart-card', null,
      element('figcaption', '', null, element('span', '', title), element('small', '', unit), this.values), this.box);
    this.box.setAttribute('role', 'img');
    this.box.setAttribute('aria-label', `${title} ${names.length ? '' : 'of each player '}over the turns; the values of the turn shown stand above`);
    this.now = element('i', 'chart-now');
  }

  data() {
    const lists = this.lists();
    const turns = Array.from({ length: lists[0]?.length ?? 0 }, (_, turn) => turn);
    const data = [turns, ...lists.map(list => (this.isLog ? list.map(value => value && Math.max(LEAST_MS, value)) : list))];
    this.limits.forEach(limit => data.push(turns.map(turn => (turn === 0 ? null : limit(turn)))));
    return data;
  }

  build(width) {
    this.plot?.destroy();
    const { theme, match } = this.charts;
    const { paint } = theme;
    const axis = { stroke: paint.muted, font: `11px ${FONT}`, grid: { stroke: paint.faint, width: 1 },
      ticks: { show: false } };
    const log = value => (value >= 1 ? grouped(value) : String(Number(value.toPrecision(1))));
    this.plot = new uPlot({
      width, height: HEIGHT, legend: { show: false }, padding: [6, 12, 0, 0],
      cursor: { sync: { key: 'turns' }, y: false, points: { show: false }, drag: { x: false, y: false } },
      scales: { x: { time: false }, y: this.isLog ? { distr: 3 } : { range: fromZero } },
      axes: [{ ...axis, size: 18, gap: 2, splits: wholeTicks },
        { ...axis, size: 40, gap: 3, space: 26, ...this.isLog ? { splits: powersOfTen } : {}, values: (_, splits) => splits.map(value =>
          (value === null ? '' : this.isLog ? log(value) : short(value))) }],
      series: [{}, ...this.lists().map((_, player) =>
        ({ stroke: theme.team(player), width: 1.4, spanGaps: true, points: { show: false },
          ...areSteps(this.lists()) ? { paths: uPlot.paths.stepped({ align: 1 }) } : {} })),
        ...this.limits.map(() => ({ stroke: paint.bad, width: 1.25, dash: [5, 4], points: { show: false } }))],
    }, this.data(), this.box);
    this.plot.over.append(this.now);
    this.plot.over.addEventListener('click', event => {
      this.charts.onSeek(Math.round(this.plot.posToVal(event.clientX - this.plot.over.getBoundingClientRect().left, 'x')));
    });
    this.turns = match.lastTurn;
  }

  update(time) {
    if (!this.plot) return;
    if (this.turns !== this.charts.match.lastTurn) {
      this.turns = this.charts.match.lastTurn;
      this.shown = null;
      this.plot.setData(this.data());
    }
    this.now.style.transform = `translateX(${this.plot.valToPos(time, 'x')}px)`;
    const turn = this.isWithin ? Math.ceil(time) : Math.floor(time);
    if (turn === this.shown || this.charts.match.players.length > MOST_VALUES) return;
    this.shown = turn;
    const when = element('small', '', `${this.isWithin ? 'in' : 'after'} ${turn}`);
    this.values.replaceChildren(when, ...this.lists().map((list, player) => {
      const number = list[turn] === null || list[turn] === undefined ? '–' : grouped(list[turn]);
      const value = element('b', '', this.names.length > 1 ? `${this.names[player]} ${number}` : number);
      value.style.color = `var(--team-${player % 16})`;
      value.title = this.names[player] ?? nameOf(this.charts.match, player);
      return value;
    }));
  }
}
const MOST_VALUES = 4;

function fromZero(_, low, high) {
  return [Math.min(0, low), high > 0 ? high * 1.05 : 1];
}

function powersOfTen(_, __, low, high) {
  const [from, to] = [Math.floor(Math.log10(low)), Math.ceil(Math.log10(high))];
  return Array.from({ length: to - from + 1 }, (___, k) => 10 ** (from + k));
}

function short(value) {
  return Math.abs(value) >= 10_000 ? `${grouped(value / 1000)}k` : grouped(value);
}

export class Charts {
  root; match; theme; series; look; onSeek;
  charts = [];

  constructor(root, match, theme, series, look, onSeek) {
    Object.assign(this, { root, match, theme, series, look, onSeek });
  }

  /** Makes the charts that this match has something for. */
  #choose() {
    const { series, match, look } = this;
    const name = match.header.drawing.lead ?? look.leadName;
    const chosen = [];
    if (series.lead()) chosen.push({ title: capital(name), unit: '', lists: () => series.lead() });
    if (match.players.length && match.topSpeed > 0) chosen.push({ title: 'Speed', unit: 'u a turn', lists: () => series.speed() });
    for (const each of series.resourceNames()) {
      chosen.push({ title: capital(each), unit: '', lists: () => series.resource(each) });
    }
    chosen.push(...look.charts?.(match, series) ?? []);
    if (match.hasTimes) {
      const limits = limitsOf(match);
      chosen.push({ title: 'Answer time', unit: `ms${limits.length ? '' : ', no deadlines'}`,
        lists: () => series.answerTimes(), isLog: true, isWithin: true, limits });
    }
    const key = chosen.map(each => each.title).join();
    if (key === this.#key) return;
    this.#key = key;
    this.charts = chosen.map(each => new Chart(this, each));
    this.root.replaceChildren(...this.charts.map(chart => chart.root));
  }
  #key = null;

  /** After a change of size or colours. */
  build() {
    this.#choose();
    const width = Math.floor(this.root.clientWidth);
    this.root.hidden = !this.charts.length;
    if (width > 40 && this.match.lastTurn) this.charts.forEach(chart => chart.build(width));
  }

  draw(time) {
    if (this.match.lastTurn && (!this.charts.length || !this.charts[0].plot)) this.build();
    this.charts.forEach(chart => chart.update(time));
  }
}

function capital(words) {
  return words.charAt(0).toUpperCase() + words.slice(1);
}
