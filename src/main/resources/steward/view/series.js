// Numbers of a match over its turns, one list for each player: lead, speed, answer times, and a game's resources.

const NANOS_PER_MS = 1e6;

/**
 * The limit of a player's answer in a turn, in ms; Infinity without deadlines. It may be the player's own; a guest's
 * referee says it as it asks.
 */
export function limitMs(match, number, player) {
  const own = match.players[player]?.time;
  const time = own ?? match.header.scene?.time ?? {};
  const asked = !own && match.turn(number - 1)?.state?.said?.filter(each => each.block === 'NEXT_PLAYER_INFO').at(-1);
  const limit = asked ? Number(asked.lines.join(' ').trim().split(/\s+/)[2]) : number === 1 ? time.firstAnswerMs : time.answerMs;
  return (limit ?? Infinity) * (match.header.timeFactor ?? Infinity);
}

/** The limits of all players as functions of the turn, each once; null in a turn without. None without deadlines. */
export function limitsOf(match) {
  const all = match.players.map((each, player) => turn => {
    const limit = limitMs(match, turn, player);
    return Number.isFinite(limit) ? limit : null;
  });
  return all.filter((limit, k) => limit(2) !== null
    && all.findIndex(other => other(1) === limit(1) && other(2) === limit(2)) === k);
}

/** The answer time of a player in ms, or null where none was measured. */
export function answerMs(match, turn, player) {
  const nanos = turn?.answerNanos?.[player];
  return !match.hasTimes || nanos === null || nanos === undefined ? null : nanos / NANOS_PER_MS;
}

/** True if all of it is whole, such as goals: a value lasts until the end of the turn that changes it. */
export function areSteps(lists) {
  return lists.every(list => list.every(value => value === null || Number.isInteger(value)));
}

/** Lists that grow with the match: each turn is computed once. */
export class Series {
  #lists = new Map();

  constructor(match, look) {
    this.match = match;
    this.look = look;
  }

  /** Lists of the match as a whole, over turns 0 to the last, of what values(turn) gives. */
  ofTurns(name, count, values) {
    return this.#grow(name, number => values(this.match.turn(number)), Array(count).fill(0));
  }

  /** A list per player, over turns 0 to the last, of what value(player, number) gives; null where it gives nothing. */
  #grow(name, values, owners = this.match.players) {
    let lists = this.#lists.get(name);
    if (!lists) {
      lists = owners.map(() => []);
      this.#lists.set(name, lists);
    }
    for (let number = lists[0]?.length ?? 0; number <= this.match.lastTurn; number++) {
      const row = values(number);
      lists.forEach((list, player) => list.push(row?.[player] ?? null));
    }
    return lists;
  }

  /** How far each player has come, in what the game calls a lead; null where it tells nothing of the kind. */
  lead() {
    if (!this.match.players.length || !this.match.lastTurn) return null;
    const lists = this.#grow('lead', number => this.look.progress(this.match, number));
    return lists.some(list => list.some(value => value !== null)) ? lists : null;
  }

  /** The speed of each player's fastest body, in units a turn. */
  speed() {
    return this.#grow('speed', number => {
      const most = this.match.players.map(() => null);
      for (const body of this.match.turn(number).bodies.values()) {
        const owner = body.player ?? body.owner ?? this.match.descriptions.get(body.id)?.owner;
        if (owner === undefined || owner === null || body.vx === undefined) continue;
        most[owner] = Math.max(most[owner] ?? 0, Math.hypot(body.vx, body.vy));
      }
      return most;
    });
  }

  answerTimes() {
    return this.#grow('times', number => this.match.players.map((_, player) =>
      answerMs(this.match, this.match.turn(number), player)));
  }

  /** The names of what the game counts besides its scores, such as rage or magic. */
  resourceNames() {
    const names = new Set();
    for (const of of this.match.turn(this.match.lastTurn)?.resources ?? []) {
      for (const [name, value] of Object.entries(of ?? {})) if (typeof value === 'number') names.add(name);
    }
    return [...names];
  }

  resource(name) {
    return this.#grow(`resource ${name}`, number => this.match.turn(number).resources?.map(of => of?.[name] ?? null));
  }
}
