// Beside the field: the bodies with their speeds, and the state drawn.

import { broken } from './json.js';
import { element, grouped, nameOf, shorten } from './text.js';
import { inTeamColour } from './theme.js';

const MOST_ROWS = 60;
const MOST_WHOLE = 5000;        // rows of the sheet; CSV has all
const MOST_FIELD = 24;          // characters
const MOST_ACROSS = 4;          // with more bodies than this, each has a row instead of a column
const MOST_BODIES = 12;         // in the list of bodies with their speeds

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
    this.#shown = { bodies, state };
    const fields = fieldsOf(bodies.slice(0, MOST_ROWS));
    const table = bodies.length <= MOST_ACROSS ? this.#across(bodies, fields) : this.#down(bodies, fields, MOST_ROWS, MOST_FIELD);
    this.root.replaceChildren(...bodies.length ? [table] : [], this.#rest(turn, state));
  }
  #shown = { bodies: [], state: {} };

  /** Opens the state in a sheet: every body in a row, and all else as the replay has it. */
  openWhole(sheet) {
    const { bodies, state } = this.#shown;
    const fields = fieldsOf(bodies);
    const rest = broken(JSON.stringify({ ...state, bodies: undefined }));
    const rows = [['id', ...fields], ...bodies.map(body => [body.id, ...fields.map(field => plain(body[field]))])];
    sheet.open(`State ${this.caption.textContent}`, [...bodies.length ? [this.#down(bodies, fields, MOST_WHOLE, Infinity)] : [],
      element('pre', '', rest === '{}' ? '' : rest)], [...rows.map(row => row.join('\t')), rest].join('\n'));
  }

  /** A column per body. */
  #across(bodies, fields) {
    const head = element('tr', '', null, element('th', '', 'id'), ...bodies.map(body => this.#heading(body)));
    const rows = fields.map(field => element('tr', '', null, element('th', '', field),
      ...bodies.map(body => element('td', '', this.#text(field, body)))));
    return element('table', '', null, head, ...rows);
  }

  /** A row per body. */
  #down(bodies, fields, most, longest) {
    const head = element('tr', '', null, element('th', '', 'id'), ...fields.map(field => element('th', '', field)));
    const rows = bodies.slice(0, most).map(body => element('tr', '', null, this.#heading(body),
      ...fields.map(field => element('td', '', this.#text(field, body, longest)))));
    const left = bodies.length - rows.length;
    if (left > 0) rows.push(element('tr', '', null, element('td', '', `and ${left} more`)));
    return element('table', '', null, head, ...rows);
  }

  #heading(body) {
    return inTeamColour(element('th', '', String(body.id)), this.match.describe(body.id, body).owner);
  }

  #text(field, body, longest = MOST_FIELD) {
    return body[field] === undefined ? '' : shorten(this.look.field(field, body[field]), longest);
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

function fieldsOf(bodies) {
  return [...new Set(bodies.flatMap(body => Object.keys(body)))].filter(field => field !== 'id');
}

function plain(value) {
  return typeof value === 'object' ? JSON.stringify(value) : String(value ?? '');
}
