// Search over the whole match: faults, messages, commands, stderr, what bots were sent, and events.

import { element, eventWords, nameOf, shorten } from './text.js';
import { inTeamColour } from './theme.js';
import { firstAfter } from './times.js';

const MOST_FOUND = 1000;
const MOST_LISTED = 200;
const LETTERS_BEFORE = 16;              // characters before what was found
const AROUND = 70;
const PAUSE_MS = 150;           // after a key, before it looks

export class Search {
  match; look; onSought; onFound;
  #found = [];

  /**
   * @param {any} parts input, list of places and their count
   * @param {(sought: RegExp) => void} onSought what is looked for, or null
   * @param {(place: object) => void} onFound a place was chosen
   */
  constructor({ input, list, count }, match, look, onSought, onFound) {
    Object.assign(this, { match, look, onSought, onFound });
    let waiting = 0;
    input.addEventListener('input', () => {
      clearTimeout(waiting);
      waiting = setTimeout(() => this.#show(input.value.trim(), list, count), PAUSE_MS);
    });
    input.addEventListener('keydown', event => {
      if (event.key === 'Enter') this.#go(event.shiftKey ? -1 : 1);
      if (event.key === 'Escape') input.blur();
    });
  }

  /** To the next or last place that was found. */
  #go(direction) {
    const time = this.time();
    const next = direction > 0 ? firstAfter(this.#found, time) : firstAfter(this.#found, time - 1e-9) - 1;
    const place = this.#found[next] ?? this.#found.at(direction > 0 ? 0 : -1);      // round and round
    if (place) this.onFound(place);
  }
  time = () => 0;

  #show(words, list, count) {
    const sought = words ? new RegExp(words.replace(/[.*+?^${}()|[\]\\]/g, '\\$&').replace(/[:,]/g, '$&\\s*'), 'i') : null;   // also in broken JSON
    this.#found = sought ? this.#find(sought) : [];
    const most = this.#found.length;
    count.textContent = !sought ? '' : most === 0 ? 'nothing' : most >= MOST_FOUND ? `the first ${MOST_FOUND} places`
      : most === 1 ? '1 place' : `${most} places`;
    list.hidden = !most;
    list.replaceChildren(...this.#found.slice(0, MOST_LISTED).map(place => this.#row(place)));
    this.onSought(sought);
  }

  #find(sought) {
    const found = [];
    for (let number = 0; number <= this.match.lastTurn && found.length < MOST_FOUND; number++) {
      for (const place of this.#textsOf(number)) {
        const at = place.text.search(sought);
        if (at >= 0) found.push({ ...place, text: shorten(place.text.slice(Math.max(0, at - LETTERS_BEFORE)), AROUND).replaceAll('\n', ' ') });
      }
    }
    return found.sort((one, other) => one.time - other.time);
  }

  #textsOf(number) {
    const { match, look } = this;
    const turn = match.turn(number);
    const texts = match.players.flatMap((_, player) => {
      const command = turn.commands?.[player];
      return [['fault', turn.faults?.[player]], ['message', turn.messages?.[player]],
        ['command', command && look.commandLines(command, player, match).join('\n')], ['stderr', turn.stderr?.[player]],
        ['sent', match.sent?.[number]?.[player]]].filter(([, text]) => text).map(([kind, text]) => ({ time: number, player, kind, text }));
    });
    for (const event of turn.events ?? []) {
      if (event.text) {
        texts.push({ time: number - 1 + event.time, player: null, kind: 'event', text: eventWords(match, { event, turn: number }) });
      }
    }
    return texts;
  }

  #row(place) {
    const who = place.player === null ? '' : `${nameOf(this.match, place.player)}, `;
    const button = element('button', '', null, element('span', 'when', String(Number(place.time.toFixed(2)))),
      inTeamColour(element('span', 'who', place.text), place.player), element('span', 'value', place.kind));
    button.title = `${who}${place.kind}, turn ${Math.ceil(place.time)}`;
    button.addEventListener('click', () => this.onFound(place));
    return element('li', '', null, button);
  }
}
