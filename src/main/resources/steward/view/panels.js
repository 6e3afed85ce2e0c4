// What is written beside the field: scores, what each player said and did in the turn shown, the state, the result.
// Texts of players only ever become text nodes, and only so much of them.

const MOST_NAME = 60;
const MOST_COMMAND = 600;
const MOST_MESSAGE = 280;
const MOST_STDERR = 6000;
const MOST_ROWS = 60;
const MOST_ACROSS = 6;          // with more bodies than this, each has a row instead of a column
const MOST_ABREAST = 6;         // with more players than this, their scores take several rows

/** An element with a class, text and children. */
function element(tag, className, text, ...children) {
  const made = document.createElement(tag);
  if (className) made.className = className;
  if (text !== undefined && text !== null) made.textContent = text;
  made.append(...children);
  return made;
}

function nameOf(match, player) {
  return shorten(match.players[player].name, MOST_NAME);
}

/** The strip above the field: a cell per player with the turn between them. */
class Scores {
  constructor(root, match, look) {
    this.root = root;
    this.match = match;
    this.look = look;
    this.clock = element('div', 'clock', null, element('span', 'clock-label', 'Turn'), element('b', '', '0'),
      element('span', 'clock-of', ''));
    this.cells = match.players.map((_, player) => this.#makeCell(player));
    const middle = Math.ceil(this.cells.length / 2);
    root.classList.toggle('many', this.cells.length > 2);
    root.classList.toggle('crowd', this.cells.length > MOST_ABREAST);
    root.replaceChildren(...this.cells.slice(0, middle), this.clock, ...this.cells.slice(middle));
  }

  #makeCell(player) {
    const cell = element('div', `score ${teamClass(player)}`, null, element('span', 'rank'),
      element('b', 'name', nameOf(this.match, player)), element('span', 'big'), element('span', 'small'));
    cell.title = this.match.players[player].bot ?? '';
    return cell;
  }

  update(moment) {
    this.clock.children[1].textContent = String(moment.turn);
    this.clock.children[2].textContent = `of ${this.match.lastTurn}`;
    const standing = this.look.standing(this.match, moment.settled);
    this.cells.forEach((cell, player) => {
      const [rank, , big, small] = cell.children;
      const isIn = this.match.isIn(player, moment.turn);
      const line = standing?.[player];
      show(rank, line && (moment.settled > 0 ? String(line.rank + 1) : '–'));
      big.textContent = isIn ? line?.big ?? '' : 'OUT';
      small.textContent = line?.warning && isIn ? line.warning : line?.small ?? '';
      cell.classList.toggle('leads', line?.rank === 0 && moment.settled > 0);
      cell.classList.toggle('warned', Boolean(line?.warning) && isIn);
      cell.classList.toggle('out', !isIn);
    });
  }
}

/** One card per player: command, message, stderr, answer time and fault of the turn shown. */
class Cards {
  constructor(root, match, look) {
    this.match = match;
    this.look = look;
    this.cards = match.players.map((_, player) => this.#makeCard(player));
    root.replaceChildren(...this.cards.map(card => card.root));
  }

  #makeCard(player) {
    const card = { time: element('span', 'answer-time'), fault: element('p', 'fault'),
      command: element('pre', 'command'), words: element('bdi'), stderr: element('pre', 'stderr') };
    card.message = element('p', 'message', null, card.words);
    card.stderr.tabIndex = 0;
    card.stderr.setAttribute('aria-label', `stderr of ${nameOf(this.match, player)}`);
    card.root = element('article', `card ${teamClass(player)}`, null,
      element('h3', '', null, element('b', 'name', nameOf(this.match, player)), card.time),
      card.fault, card.command, card.message, card.stderr);
    return card;
  }

  update(number) {
    const turn = this.match.turn(number);
    this.cards.forEach((card, player) => {
      const command = turn.commands?.[player];
      const message = turn.messages?.[player];
      show(card.time, this.#timeText(turn, player));
      show(card.fault, turn.faults?.[player] && shorten(turn.faults[player], MOST_MESSAGE));
      show(card.command, this.#commandText(turn, player, command));
      show(card.words, message && shorten(message, MOST_MESSAGE));
      card.message.hidden = card.words.hidden;
      show(card.stderr, shorten(readNotes(turn.stderr?.[player]).text, MOST_STDERR));
    });
  }

  #commandText(turn, player, command) {
    if (turn.number === 0) return 'before the first turn';
    if (!command) return turn.faults[player] ? '' : 'out: not asked any more';
    return shorten(this.look.commandLines(command, player, this.match).join('\n'), MOST_COMMAND);
  }

  #timeText(turn, player) {
    const nanos = turn.answerNanos?.[player];
    if (nanos === null || nanos === undefined) return '';
    const limit = limitMs(this.match, turn.number);
    const ms = nanos / NANOS_PER_MS;
    return `${ms.toFixed(ms < 10 ? 2 : 1)} ms${Number.isFinite(limit) ? ` of ${plainNumber(limit)}` : ''}`;
  }
}

/** Puts text into an element, or hides it when there is none. */
function show(target, text) {
  target.textContent = text ?? '';
  target.hidden = !text;
}

/** The state at the end of the turn shown, as the replay has it. */
class StateTable {
  constructor(root, match, look) {
    this.root = root;
    this.match = match;
    this.look = look;
  }

  update(number) {
    const turn = this.match.turn(number);
    const bodies = [...turn.bodies.values()];
    const fields = [...new Set(bodies.slice(0, MOST_ROWS).flatMap(body => Object.keys(body)))]
      .filter(field => field !== 'id');
    const table = bodies.length <= MOST_ACROSS ? this.#across(bodies, fields) : this.#down(bodies, fields);
    this.root.replaceChildren(table, this.#rest(turn));
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
    return element('th', teamClass(this.match.describe(body.id, body).owner), String(body.id));
  }

  #text(field, body) {
    return body[field] === undefined ? '' : shorten(this.look.field(field, body[field]), 24);
  }

  #rest(turn) {
    const rest = element('dl', 'rest');
    for (const [name, value] of Object.entries(turn.state)) {
      if (name === 'bodies') continue;
      rest.append(element('dt', '', name), element('dd', '', shorten(JSON.stringify(value), 200)));
    }
    if (turn.impactsInAll) rest.append(element('dt', '', 'impacts'), element('dd', '', String(turn.impactsInAll)));
    if (turn.impactLimit) {
      rest.append(element('dt', '', 'impact limit'), element('dd', 'fault', `reached at ${turn.impactLimit.time}`));
    }
    if (turn.hash) rest.append(element('dt', '', 'hash'), element('dd', '', turn.hash));
    return rest;
  }
}

/** The lower third at the end: who won, why, and everybody's rank. */
class Ending {
  isDismissed = false;

  constructor(root, match) {
    this.root = root;
    this.match = match;
  }

  update(isAtEnd) {
    const isShown = isAtEnd && Boolean(this.match.result);
    if (!isShown) this.isDismissed = false;
    const wasHidden = this.root.hidden;
    this.root.hidden = !isShown || this.isDismissed;
    if (wasHidden && !this.root.hidden) this.#fill(this.match.result);
  }

  #fill(result) {
    const close = element('button', 'close', '×');
    close.setAttribute('aria-label', 'Close');
    close.addEventListener('click', () => {
      this.isDismissed = true;
      this.root.hidden = true;
    });
    const ranks = result.standing
      .map((standing, player) => ({ ...standing, player }))
      .sort((one, other) => one.rank - other.rank)
      .map(line => this.#rankLine(line, result));
    this.root.replaceChildren(
      element('p', 'headline', this.#headline(result)),
      element('p', 'reason', `${shorten(result.ending, MOST_MESSAGE)}, turn ${result.turns}`),
      element('ol', '', null, ...ranks), close);
  }

  #headline(result) {
    const best = result.standing.flatMap((standing, player) => (standing.rank === 0 ? [player] : []));
    if (result.standing.length === 1) return nameOf(this.match, 0);
    return best.length === 1 ? `${nameOf(this.match, best[0])} wins`
      : `Draw: ${best.map(player => nameOf(this.match, player)).join(' and ')}`;
  }

  #rankLine({ player, rank, score, out }, result) {
    const fault = result.players[player]?.fault;
    const why = fault ?? out;
    return element('li', teamClass(player), null, element('span', 'rank', String(rank + 1)),
      element('b', 'name', nameOf(this.match, player)), element('span', 'points', plainNumber(score)),
      element('span', 'why', why ? `out: ${shorten(why, MOST_MESSAGE)}` : ''));
  }
}
