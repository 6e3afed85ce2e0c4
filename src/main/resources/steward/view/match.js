// The recorded match: what the lines of a replay say, and where every body is at any time.

import { cornersOf, placeOn } from './paths.js';

const USUAL_RADIUS = 0.03;      // of the field's longer side

export class Match {
  header = null;
  result = null;
  isAnotherPlayed = false;        // where this match came from
  turns = [];
  hasTimes = false;               // whether answer times were measured: an import has none
  impacts = [];
  events = [];
  faults = [];
  largestImpulse = 0;
  topSpeed = 0;                   // of all bodies of players, in units a turn
  start = null;
  descriptions = new Map();
  sent = null;                    // lines that each player was sent, by turn; null where they are not known
  errors = new Map();             // which line of a bot's stderr says why it failed, by turn and player
  isSparse = false;               // whether the states of some turns were left out: bodies fly straight between them

  get lastTurn() {
    return this.turns.length;
  }

  /** The largest radius for which effects are drawn in full: a large body shall not hide the field. */
  get usualRadius() {
    const field = this.header.drawing.field;
    return field ? USUAL_RADIUS * Math.max(field.width, field.height) : Infinity;
  }

  get players() {
    return this.header ? this.header.players : [];
  }

  /** Takes the next line of a replay: header, turn or result. Returns whether it brought something new. */
  addLine(line) {
    return this.addRecord(JSON.parse(line));
  }

  addRecord(record) {
    if (record.type === 'steward-replay') return this.#setHeader(record);
    if (record.type === 'turn') return this.#addTurn(record);
    if (record.type === 'result') return this.#setResult(record);
    return false;
  }

  /** A second header, as after a reconnection, is the same or that of another match, which is left out. */
  #setHeader(header) {
    if (this.header) {
      this.isAnotherPlayed ||= header.headerHash !== this.header.headerHash;
      return false;
    }
    this.header = header;
    header.drawing ??= {};
    for (const description of header.drawing.bodies ?? []) {
      this.descriptions.set(description.id, description);
    }
    this.start = { number: 0, state: header.start.state, hash: header.start.hash,
      bodies: byId(header.start.state.bodies ?? []) };
    return true;
  }

  /** Turns come in order; one that is already there, as after a reconnection, is left out. */
  #addTurn(record) {
    if (!this.header || record.turn !== this.turns.length + 1) return false;
    const outcome = record.outcome;
    const state = outcome.state ?? this.turn(record.turn - 1).state;   // an imported or sparse turn may have none
    this.isSparse ||= !outcome.state && !this.header.imported;
    const turn = {
      number: record.turn,
      commands: record.commands,
      faults: record.faults ?? [],
      messages: record.messages ?? [],
      stderr: record.stderr ?? [],
      answerNanos: record.times?.answerNanos ?? [],
      impacts: outcome.impacts ?? [],
      impactsInAll: outcome.impactsInAll ?? (outcome.impacts ?? []).length,
      impactLimit: outcome.impactLimit ?? null,
      events: outcome.events ?? [],
      knots: outcome.paths ? new Map(outcome.paths.map(path => [path.id, path.knots])) : cornersOf(outcome.impacts),
      bodies: byId(state.bodies ?? []),
      paths: new Map(),
      scores: outcome.scores ?? null,
      resources: outcome.resources ?? null,
      zones: outcome.zones ?? null,
      state,
      isKept: Boolean(outcome.state),
      hash: outcome.hash,
    };
    this.hasTimes ||= turn.answerNanos.some(nanos => nanos > 0);
    this.turns.push(turn);
    this.#collect(turn);
    return true;
  }

  #collect(turn) {
    for (const body of turn.bodies.values()) {
      if (body.vx === undefined) continue;
      this.topSpeed = Math.max(this.topSpeed, Math.hypot(body.vx, body.vy));
    }
    for (const impact of turn.impacts) {
      this.impacts.push({ time: turn.number - 1 + impact.time, turn: turn.number, impact });
      this.largestImpulse = Math.max(this.largestImpulse, Math.abs(impact.impulse ?? 0));
    }
    for (const event of [...turn.events].sort((one, other) => one.time - other.time)) {
      this.events.push({ time: turn.number - 1 + event.time, turn: turn.number, event });
    }
    turn.faults.forEach((fault, player) => {
      if (fault !== null) this.faults.push({ time: turn.number, player, fault });
    });
  }

  #setResult(result) {
    if (this.result) return false;
    this.result = result;
    return true;
  }

  /** Turn 0 is the start; null for a turn that is not there. */
  turn(number) {
    return number === 0 ? this.start : this.turns[number - 1] ?? null;
  }

  /** What the game said of a body: from the drawing, or from its state if it came later. */
  describe(id, state) {
    const description = this.descriptions.get(id) ?? {};
    return {
      id,
      kind: state?.kind ?? description.kind ?? 'body',
      owner: state?.owner ?? description.owner ?? state?.player ?? null,
      label: state?.label ?? description.label ?? '',
      radius: state?.radius ?? description.radius ?? 0,
      colour: description.colour ?? null,
    };
  }

  /** What is known of a body in a turn: from its end, or from its start for a body that ceased to be in it. */
  describeIn(id, number) {
    return this.describe(id, this.turn(number)?.bodies.get(id) ?? this.turn(number - 1)?.bodies.get(id));
  }

  /** The line of a player's stderr in a turn that says why it failed; empty where there is none, or where none is known. */
  errorLine(number, player) {
    const line = this.errors.get(`${number} ${player}`);
    return line === undefined ? '' : this.turn(number).stderr[player].split(/\r\n|\r|\n/)[line] ?? '';
  }

  /** Name of a wall by its place: a side of the field, or its kind with its number where several have the name. */
  wallName(index) {
    this.#wallNames ??= namesOfWalls(this.header.drawing);
    return this.#wallNames[index] ?? 'wall';
  }
  #wallNames = null;

  /** Whether the player was still asked for a command in that turn. */
  isIn(player, number) {
    if (number === 0 || !this.turns.length) return true;
    const turn = this.turn(Math.min(number, this.lastTurn));
    // A guest's referee asks one player at a time: who has not failed may be asked again.
    if (this.header.game === 'guest') return !this.faults.some(each => each.player === player && each.time <= number);
    return turn.commands[player] !== null;
  }

  /** Bodies that never move and are in no state, such as bumpers. */
  fixedBodies() {
    const fixed = [];
    for (const description of this.descriptions.values()) {
      if (description.x !== undefined && !this.start.bodies.has(description.id)) {
        fixed.push({ ...this.describe(description.id), x: description.x, y: description.y });
      }
    }
    return fixed;
  }

  /**
   * All moving bodies that exist at a moment, with place, velocity and radius; before, after and now are their states
   * before the turn, after it, and after the last turn that is whole.
   */
  bodiesAt(moment) {
    if (this.isSparse) return this.#sparseBodiesAt(moment);
    const now = this.turn(moment.turn);
    if (!now) return [];
    now.cast ??= this.#castOf(now);
    const bodies = [];
    for (const { description, before, after, path } of now.cast) {
      const place = placeOn(path, moment.fraction);
      if (!place) continue;
      const from = before?.radius ?? description.radius;
      const to = after?.radius ?? from;
      const [earlier, later] = [before ?? after ?? NO_STATE, after ?? before ?? NO_STATE];
      const now = moment.fraction < 1 ? earlier : later;
      bodies.push({ ...description, x: place.x, y: place.y, vx: place.vx ?? now.vx, vy: place.vy ?? now.vy,
        before: earlier, after: later, now, radius: from + (to - from) * moment.fraction });
    }
    return bodies;
  }

  /** The turns around a moment of a sparse replay whose states are kept, or the last turn that is there yet. */
  keptAround(moment) {
    let [from, to] = [moment.settled, moment.turn];
    while (from > 0 && !this.turn(from).isKept) from--;
    while (to < this.lastTurn && to > 0 && !this.turn(to).isKept) to++;
    return [from, to];
  }

  /** Bodies of a replay that is sparse, straight between the states that it keeps. */
  #sparseBodiesAt(moment) {
    const [from, to] = this.keptAround(moment);
    const [before, after] = [this.turn(from).bodies, this.turn(to).bodies];
    const turns = to - from || 1;
    const past = moment.time - from;
    return [...before.values()].filter(body => after.has(body.id)).map(body => {
      const next = after.get(body.id);
      const [vx, vy] = to === from ? [body.vx, body.vy] : [(next.x - body.x) / turns, (next.y - body.y) / turns];
      return { ...this.describe(body.id, body), before: body, after: next, now: body, vx, vy,
        x: to === from ? body.x : body.x + vx * past, y: to === from ? body.y : body.y + vy * past };
    });
  }

  /** Everybody who is there in a turn: descriptions, states and ways, looked up once. */
  #castOf(now) {
    const earlier = now.number === 0 ? now : this.turn(now.number - 1);
    const born = (now.events ?? []).filter(event => event.kind === 'birth').map(event => event.body);
    const ids = new Set([...earlier.bodies.keys(), ...now.bodies.keys(), ...born]);
    return [...ids].map(id => {
      const [before, after] = [earlier.bodies.get(id), now.bodies.get(id)];
      const path = now.number === 0 ? [[1, after.x, after.y]] : this.path(id, now.number);
      return { description: this.describe(id, after ?? before), before, after, path };
    });
  }

  /** Where a body is, or null where it is not. */
  placeAt(id, moment) {
    if (moment.turn === 0) {
      const body = this.start.bodies.get(id);
      return body ? { x: body.x, y: body.y } : null;
    }
    return placeOn(this.path(id, moment.turn), moment.fraction);
  }

  /**
   * The corners [t, x, y] of a body's way through a turn, in the order of time: from where it was (or came into
   * being), through its impacts, to where it is at the end (or ceased to be). Between corners it flies straight.
   */
  path(id, number) {
    const turn = this.turn(number);
    if (!turn || number === 0) return [];
    let path = turn.paths.get(id);
    if (!path) {
      path = this.#makePath(id, turn);
      turn.paths.set(id, path);
    }
    return path;
  }

  #makePath(id, turn) {
    const before = this.turn(turn.number - 1).bodies.get(id);
    const after = turn.bodies.get(id);
    const eventOf = kind => turn.events.find(event => event.kind === kind && event.body === id);
    const corner = event => event && [event.time, event.x, event.y];
    const first = before ? [0, before.x, before.y] : corner(eventOf('birth'));
    const last = after ? [1, after.x, after.y] : corner(eventOf('death'));
    return [first, ...(turn.knots.get(id) ?? []), last].filter(Boolean);
  }

  /** The box around everything that moves, over all turns: left, top, right, bottom. */
  extent() {
    const box = this.#extent;
    for (; box.turns <= this.lastTurn; box.turns++) {
      for (const body of this.turn(box.turns).bodies.values()) {
        const radius = body.radius ?? this.descriptions.get(body.id)?.radius ?? 0;
        box.left = Math.min(box.left, body.x - radius);
        box.right = Math.max(box.right, body.x + radius);
        box.top = Math.min(box.top, body.y - radius);
        box.bottom = Math.max(box.bottom, body.y + radius);
      }
    }
    return box;
  }
  #extent = { turns: 0, left: Infinity, top: Infinity, right: -Infinity, bottom: -Infinity };
}

const NO_STATE = {};

function namesOfWalls({ walls = [], field }) {
  const names = walls.map(wall => nameOfWall(wall, field));
  return names.map((name, index) => (names.indexOf(name) === names.lastIndexOf(name) ? name : `${name} ${index}`));
}

/** The y axis points down. */
function nameOfWall({ type, insideX, insideY, ax, ay, bx, by }, field) {
  if (type === 'arena') return 'arena';
  if (type === 'half-plane') {
    if (Math.abs(insideX) === 1) return insideX > 0 ? 'left wall' : 'right wall';
    if (Math.abs(insideY) === 1) return insideY > 0 ? 'top wall' : 'bottom wall';
  }
  if (type === 'segment' && field && ax === bx) return ax < field.x + field.width / 2 ? 'left wall' : 'right wall';
  if (type === 'segment' && field && ay === by) return ay < field.y + field.height / 2 ? 'top wall' : 'bottom wall';
  return 'wall';
}

function byId(bodies) {
  return new Map(bodies.map(body => [body.id, body]));
}
