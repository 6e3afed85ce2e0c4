// What happened around the moment shown: impacts, events and faults, each a button that goes there.

import { element, eventWords, impulseWords, nameOf, shorten } from './text.js';
import { inTeamColour } from './theme.js';
import { firstAfter } from './times.js';

const MOST_SHOWN = 9;
const BEFORE = 5;               // of them, so many have happened
const MOST_TEXT = 70;

export class Happened {
  root; match; timeline; onSeek;

  constructor(root, match, timeline, onSeek) {
    Object.assign(this, { root, match, timeline, onSeek });
  }

  update(moment) {
    const all = this.#all();
    const next = firstAfter(all, moment.time + 1e-9);
    const from = Math.max(0, Math.min(next - BEFORE, all.length - MOST_SHOWN));
    const key = `${from} ${next} ${all.length}`;
    if (key === this.#key) return;
    this.#key = key;
    const rows = all.slice(from, from + MOST_SHOWN).map((each, k) => this.#row(each, from + k === next - 1));
    this.root.replaceChildren(...rows.length ? rows : [element('li', 'none', 'nothing but flight')]);
  }
  #key = '';

  /** Events that the game tells of, of one player or, if null, of all. */
  eventsOf(player) {
    const told = this.match.events.filter(({ event }) => event.text);
    return player === null ? told : told.filter(({ event, turn }) => this.timeline.ownerOf(event, turn) === player);
  }

  /** All of it in the order of time; made anew when the match has grown. */
  #all() {
    const { impacts, events, faults } = this.match;
    const size = impacts.length + events.length + faults.length;
    if (this.#size !== size) {
      this.#size = size;
      this.#list = [...impacts, ...this.eventsOf(null), ...faults].sort((one, other) => one.time - other.time);
    }
    return this.#list;
  }
  #size = -1;
  #list = [];

  #row(each, isNow) {
    const { words, value, player } = this.#describe(each);
    const button = element('button', isNow ? 'now' : '', null, element('span', 'when', each.time.toFixed(2)),
      inTeamColour(element('span', 'who', shorten(words, MOST_TEXT)), player), element('span', 'value', value));
    button.addEventListener('click', () => this.onSeek(each.time));
    if (isNow) button.setAttribute('aria-current', 'true');
    return element('li', '', null, button);
  }

  #describe({ impact, event, turn, player, fault }) {
    if (impact) {
      const { owner } = this.match.describeIn(impact.a, turn);
      return { words: this.#pairOfNames(impact, turn), value: impact.impulse === undefined ? '' : impulseWords(impact), player: owner };
    }
    if (event) return { words: eventWords(this.match, { event, turn }), value: '✓', player: this.timeline.ownerOf(event, turn) };
    return { words: `${nameOf(this.match, player)}: ${fault}`, value: '×', player };
  }

  /** Both bodies, with the kind where there are several kinds; or a body and a wall. */
  #pairOfNames(impact, turn) {
    const nameOfBody = id => (this.#kinds() > 1 ? `${this.match.describeIn(id, turn).kind} ${id}` : String(id));
    return `${nameOfBody(impact.a)} × ${impact.wall === undefined ? nameOfBody(impact.b) : this.match.wallName(impact.wall)}`;
  }

  #kinds() {
    return this.#kindCount ??= new Set([...this.match.start.bodies.values()]
      .map(body => this.match.describe(body.id, body).kind)).size;
  }
  #kindCount;
}
