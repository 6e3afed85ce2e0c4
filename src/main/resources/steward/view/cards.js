// One card per player: what it was sent and answered, its message, stderr, answer time and fault of the turn shown.

import { broken } from './json.js';
import { readNotes } from './notes.js';
import { answerMs, limitMs } from './series.js';
import { element, nameOf, plainNumber, show, shorten } from './text.js';
import { lineMark, TextBox } from './textbox.js';
import { inTeamColour } from './theme.js';

const MOST_COMMAND = 4000;
const MOST_MESSAGE = 280;
const MOST_FAULT = 2000;

export class Cards {
  /** @param {(player: number) => void} onChoose a player's name was pressed */
  constructor(root, match, look, sheet, onChoose) {
    Object.assign(this, { match, look, sheet, onChoose });
    this.cards = match.players.map((_, player) => this.#makeCard(player));
    root.replaceChildren(...this.cards.map(card => card.root));
  }
  match; look; sheet; onChoose;
  number = 0;
  chosen = null;
  /** Expression that is looked for; marked in all texts. */
  sought = null;

  #makeCard(player) {
    const name = nameOf(this.match, player);
    const card = { time: element('span', 'answer-time'), fault: element('p', 'fault'), name: element('button', 'name', name),
      command: element('pre', 'command'), words: element('bdi'), stderr: new TextBox('stderr', `stderr of ${name}`, this.sheet, true),
      sent: new TextBox('sent', `what ${name} was sent`, this.sheet, false) };
    card.name.title = `${name}: a click lets "Event" stop at this player’s events only`;
    card.name.addEventListener('click', () => this.onChoose(player));
    card.message = element('p', 'message', null, card.words);
    card.sentBox = element('details', 'sent-box', null, element('summary', '', 'was sent'), card.sent.root);
    card.sentBox.hidden = true;
    card.sentBox.addEventListener('toggle', () => this.#fillSent(card, player));
    card.root = inTeamColour(element('article', 'card', null, element('h3', '', null, card.name, card.time),
      card.sentBox, card.fault, card.command, card.message, card.stderr.root), player);
    return card;
  }

  update(number, chosen) {
    this.number = number;
    this.chosen = chosen;
    const turn = this.match.turn(number);
    this.cards.forEach((card, player) => {
      const message = turn.messages?.[player];
      const stderr = readNotes(turn.stderr?.[player]).text;
      card.name.setAttribute('aria-pressed', String(player === chosen));
      show(card.time, this.#timeText(turn, player));
      show(card.fault, turn.faults?.[player] && shorten(turn.faults[player], MOST_FAULT));
      show(card.command, this.#commandText(turn, player, turn.commands?.[player]));
      show(card.words, message && shorten(message, MOST_MESSAGE));
      card.message.hidden = card.words.hidden;
      card.stderr.show(stderr, this.#found(stderr) ?? lineMark(stderr, this.match.errorLine(number, player), 'error'));
      card.sentBox.hidden = !this.match.sent?.[number]?.[player];
      this.#fillSent(card, player);
    });
  }

  /** Opens what matters to a place that was found, and brings it into view. */
  reveal({ player, kind }) {
    const card = this.cards[player];
    if (!card) return;
    if (kind === 'sent') card.sentBox.open = true;
    this.update(this.number, this.chosen);
    (kind === 'sent' ? card.sent : card.stderr).scroll();
    card.root.scrollIntoView({ block: 'nearest' });
  }

  #fillSent(card, player) {
    const sent = this.match.sent?.[this.number]?.[player];
    if (!card.sentBox.open || !sent) return;
    const text = broken(sent);
    card.sent.show(text, this.#found(text));
  }

  #found(text) {
    const found = this.sought && text.match(this.sought);
    return found ? { from: found.index, to: found.index + found[0].length, kind: 'found' } : null;
  }

  #commandText(turn, player, command) {
    if (turn.number === 0) return 'before the first turn';
    if (command === null || command === undefined) {
      return turn.faults[player] ? '' : this.match.isIn(player, turn.number) ? 'not asked in this turn'
        : 'out: not asked any more';
    }
    return shorten(this.look.commandLines(command, player, this.match).join('\n'), MOST_COMMAND);
  }

  #timeText(turn, player) {
    const ms = answerMs(this.match, turn, player);
    if (ms === null) return '';
    const limit = limitMs(this.match, turn.number, player);
    return `${ms.toFixed(ms < 10 ? 2 : 1)} ms${Number.isFinite(limit) ? ` of ${plainNumber(limit)}` : ''}`;
  }
}
