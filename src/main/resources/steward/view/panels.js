// Beside the field: what each player was sent, said and did in the turn shown, the bodies, and the state drawn.

import { readNotes } from './notes.js';
import { answerMs, limitMs } from './series.js';
import { element, grouped, nameOf, plainNumber, show, shorten } from './text.js';
import { inTeamColour } from './theme.js';

const MOST_COMMAND = 600;
const MOST_MESSAGE = 280;
const MOST_STDERR = 6000;
const MOST_SENT = 8000;
const MOST_ROWS = 60;
const MOST_ACROSS = 4;          // with more bodies than this, each has a row instead of a column
const MOST_BODIES = 12;         // in the list of bodies with their speeds

/** One card per player: what it was sent and answered, message, stderr, answer time and fault of the turn shown. */
export class Cards {
  constructor(root, match, look) {
    this.match = match;
    this.look = look;
    this.cards = match.players.map((_, player) => this.#makeCard(player));
    root.replaceChildren(...this.cards.map(card => card.root));
  }

  #makeCard(player) {
    const card = { time: element('span', 'answer-time'), fault: element('p', 'fault'),
      command: element('pre', 'command'), words: element('bdi'), stderr: element('pre', 'stderr'),
      sent: element('pre', 'sent') };
    card.message = element('p', 'message', null, card.words);
    for (const [area, name] of [[card.stderr, 'stderr of'], [card.sent, 'sent to']]) {
      area.tabIndex = 0;
      area.setAttribute('aria-label', `${name} ${nameOf(this.match, player)}`);
    }
    card.sentBox = element('details', 'sent-box', null, element('summary', '', 'was sent'), card.sent);
    card.sentBox.hidden = true;
    card.sentBox.addEventListener('toggle', () => this.#fillSent(card, player));
    card.root = inTeamColour(element('article', 'card', null,
      element('h3', '', null, element('b', 'name', nameOf(this.match, player)), card.time),
      card.sentBox, card.fault, card.command, card.message, card.stderr), player);
    return card;
  }

  update(number) {
    this.number = number;
    const turn = this.match.turn(number);
    this.cards.forEach((card, player) => {
      const message = turn.messages?.[player];
      show(card.time, this.#timeText(turn, player));
      show(card.fault, turn.faults?.[player] && shorten(turn.faults[player], MOST_MESSAGE));
      show(card.command, this.#commandText(turn, player, turn.commands?.[player]));
      show(card.words, message && shorten(message, MOST_MESSAGE));
      card.message.hidden = card.words.hidden;
      show(card.stderr, shorten(readNotes(turn.stderr?.[player]).text, MOST_STDERR));
      card.sentBox.hidden = !this.match.sent?.[number]?.[player];
      this.#fillSent(card, player);
    });
  }

  #fillSent(card, player) {
    const sent = this.match.sent?.[this.number]?.[player];
    if (card.sentBox.open && sent) card.sent.textContent = shorten(sent, MOST_SENT);
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
    const limit = limitMs(this.match, turn.number);
    return `${ms.toFixed(ms < 10 ? 2 : 1)} ms${Number.isFinite(limit) ? ` of ${plainNumber(limit)}` : ''}`;
  }
}

/** Bodies of players with their speed as a bar; a click selects one, and the field follows the choice. */
export class BodyList {
  root; match; look; onSelect;

  constructor(root, match, look, onSelect) {
    Object.assign(this, { root, match, look, onSelect });
    this.rows = new Map();
  }

  update(moment, selected) {
    const all = this.match.bodiesAt(moment).filter(body => body.owner !== null && body.owner !== undefined);
    const bodies = all.slice(0, MOST_BODIES);
    const key = `${all.length} ${bodies.map(body => body.id).join()}`;
    if (key !== this.#key) {
      this.#key = key;
      this.rows = new Map(bodies.map(body => [body.id, this.#makeRow(body)]));
      this.root.replaceChildren(...[...this.rows.values()].map(row => row.root));
      if (all.length > bodies.length) this.root.append(element('p', 'more', `and ${all.length - bodies.length} more, in the state below`));
    }
    this.root.hidden = !bodies.length;
    const most = this.match.topSpeed || 1;
    for (const body of bodies) {
      const row = this.rows.get(body.id);
      const speed = Math.hypot(body.vx ?? 0, body.vy ?? 0);
      row.speed.textContent = grouped(speed);
      row.bar.style.setProperty('--share', `${Math.min(100, Math.round(100 * speed / most))}%`);
      row.order.textContent = shorten(this.look.commandOf(body, this.match, moment.turn) || body.kind, 60);
      row.root.setAttribute('aria-pressed', String(body.id === selected));
    }
  }
  #key = null;

  #makeRow(body) {
    const row = { order: element('span', 'order'), speed: element('b', 'speed-of'), bar: element('i', 'bar') };
    row.root = inTeamColour(element('button', 'body-row', null, element('span', 'badge', body.label || String(body.id)),
      row.order, row.speed, element('small', '', 'u'), row.bar), body.owner);
    row.root.title = `${nameOf(this.match, body.owner)}: ${body.kind} ${body.id}; a click selects it`;
    row.root.addEventListener('click', () => this.onSelect(body.id));
    return row;
  }
}

/** The state of the moment drawn: within a turn the places are, and the rest is of the end of the turn before. */
export class StateTable {
  root; caption; match; look;

  constructor(root, caption, match, look) {
    Object.assign(this, { root, caption, match, look });
  }

  /**
   * At the end of a turn the state is the replay's; within one only places are known, and they are the ones drawn. Of a
   * turn whose state was left out nothing else is known.
   */
  update(moment) {
    const turn = this.match.turn(moment.settled);
    if (this.match.isSparse && turn.isKept === false) {
      const [from, to] = this.match.keptAround(moment);
      this.caption.textContent = `places at ${moment.time.toFixed(2)}, straight from turn ${from} to ${to}: `
        + `the state of turn ${moment.settled} was left out`;
      this.#show(this.match.bodiesAt(moment).map(({ id, x, y }) => ({ id, x, y })), turn, {});
      return;
    }
    const isWithin = moment.turn > moment.settled && turn.bodies.size > 0;
    const when = moment.settled === 0 ? 'at the start' : `at the end of turn ${moment.settled}`;
    this.caption.textContent = isWithin ? `places at ${moment.time.toFixed(2)}, the rest ${when}` : when;
    const bodies = isWithin ? this.match.bodiesAt(moment).map(({ id, x, y }) => ({ id, ...turn.bodies.get(id), x, y }))
      : [...turn.bodies.values()];
    this.#show(bodies, turn, turn.state);
  }

  #show(bodies, turn, state) {
    const fields = [...new Set(bodies.slice(0, MOST_ROWS).flatMap(body => Object.keys(body)))]
      .filter(field => field !== 'id');
    const table = bodies.length <= MOST_ACROSS ? this.#across(bodies, fields) : this.#down(bodies, fields);
    this.root.replaceChildren(...bodies.length ? [table] : [], this.#rest(turn, state));
  }

  /** A column per body. */
  #across(bodies, fields) {
    const head = element('tr', '', null, element('th', '', 'id'), ...bodies.map(body => this.#heading(body)));
    const rows = fields.map(field => element('tr', '', null, element('th', '', field),
      ...bodies.map(body => element('td', '', this.#text(field, body)))));
    return element('table', '', null, head, ...rows);
  }

  /** A row per body. */
  #down(bodies, fields) {
    const head = element('tr', '', null, element('th', '', 'id'), ...fields.map(field => element('th', '', field)));
    const rows = bodies.slice(0, MOST_ROWS).map(body => element('tr', '', null, this.#heading(body),
      ...fields.map(field => element('td', '', this.#text(field, body)))));
    const left = bodies.length - rows.length;
    if (left > 0) rows.push(element('tr', '', null, element('td', '', `and ${left} more`)));
    return element('table', '', null, head, ...rows);
  }

  #heading(body) {
    return inTeamColour(element('th', '', String(body.id)), this.match.describe(body.id, body).owner);
  }

  #text(field, body) {
    return body[field] === undefined ? '' : shorten(this.look.field(field, body[field]), 24);
  }

  #rest(turn, state) {
    const rest = element('dl', 'rest');
    for (const [name, text] of this.look.rest(state, this.match)) {
      rest.append(element('dt', '', name), element('dd', '', text));
    }
    if (turn.impactsInAll) rest.append(element('dt', '', 'impacts'), element('dd', '', String(turn.impactsInAll)));
    if (turn.impactLimit) {
      rest.append(element('dt', '', 'impact limit'), element('dd', 'fault', `reached at ${turn.impactLimit.time}`));
    }
    if (turn.hash) rest.append(element('dt', '', 'hash'), element('dd', '', turn.hash));
    return rest;
  }
}
