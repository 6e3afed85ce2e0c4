// Puts the page together: reads the embedded replay or follows a live match, and connects clock, drawing and controls.

const PANEL_MS = 100;           // while playing, texts change no more often than this
const LINK_MS = 1000;           // nor does the link
const LONGEST_FRAME = 0.25;     // seconds; a page that was hidden goes on where it was
const TAP_PIXELS = 8;
const LOST_MS = 20_000;         // without a connection for so long, a live match is given up

const find = id => document.getElementById(id);

class Page {
  match = new Match();
  theme = new Theme(() => this.redrawAll());
  playback = new Playback(this.match, () => this.#changed());
  #lastFrame = 0;
  #lastPanels = 0;
  #lastLink = 0;
  #shownTurn = -1;
  #isAsked = false;

  /** Takes one line of a replay: from the page itself or as it is played. */
  addLine(line) {
    const hadHeader = Boolean(this.match.header);
    if (!this.match.addLine(line)) return;
    if (!hadHeader) this.#build();
    else this.#grown = true;
    this.#changed();
  }
  #grown = false;

  #build() {
    const look = LOOKS[this.match.header.game] ?? PLAIN_LOOK;
    const seek = time => this.playback.seek(time);
    this.stage = new Stage(find('field'), this.match, this.theme, look);
    this.timeline = new Timeline(find('marks'), find('scrub'), this.match, this.theme, seek);
    this.chart = new TimeChart(find('times'), this.match, this.theme, seek);
    this.scores = new Scores(find('scores'), this.match, look);
    this.cards = new Cards(find('cards'), this.match, look);
    this.table = new StateTable(find('state'), this.match, look);
    this.ending = new Ending(find('ending'), this.match);
    find('scene').textContent = `${this.match.header.scene.name} · seed ${this.match.header.seed}`;
    find('limit').textContent = Number.isFinite(limitMs(this.match, 2)) ? '' : 'no deadlines';
    new ResizeObserver(() => this.redrawAll()).observe(find('field'));
    this.redrawAll();
  }

  /** After a change of size or colours. */
  redrawAll() {
    if (!this.stage) return;
    this.stage.resize();
    this.timeline.draw();
    this.chart.draw(this.playback.time);
    this.draw();
  }

  /** Something moved: draw with the next frame, and go on drawing while it plays. */
  #changed() {
    if (this.#isAsked || !this.stage) return;
    this.#isAsked = true;
    requestAnimationFrame(now => this.#frame(now));
  }

  #frame(now) {
    const seconds = Math.min(LONGEST_FRAME, (now - this.#lastFrame) / 1000);
    this.#lastFrame = now;
    if (this.#wasPlaying && this.playback.playing) this.playback.advance(seconds);
    this.#wasPlaying = this.playback.playing;
    this.#isAsked = false;
    if (this.#grown) this.#showGrowth();
    this.draw();
    if (this.playback.playing) this.#changed();
  }
  #wasPlaying = false;

  /** More turns than before. */
  #showGrowth() {
    this.#grown = false;
    this.stage.resize();
    this.timeline.draw();
  }

  /** Draws the present moment. */
  draw() {
    const { playback } = this;
    const moment = playback.moment;
    this.stage.draw(moment, playback.turnsPerSecond);
    this.timeline.move(playback.time);
    this.scores.update(moment);
    this.ending.update(playback.time >= playback.end);
    find('play').setAttribute('aria-pressed', String(playback.playing));
    find('play').setAttribute('aria-label', playback.playing ? 'Pause' : 'Play');
    find('speed').value = String(playback.speed);
    find('time').textContent = playback.time.toFixed(2);
    const now = performance.now();
    if (!playback.playing || now - this.#lastPanels >= PANEL_MS) this.#drawPanels(moment, now);
    if (!playback.playing || now - this.#lastLink >= LINK_MS) this.#updateLink(moment, now);
  }

  #drawPanels(moment, now) {
    this.#lastPanels = now;
    this.chart.draw(this.playback.time);
    if (moment.turn === this.#shownTurn) return;
    this.#shownTurn = moment.turn;
    find('turn-shown').textContent = moment.turn === 0 ? 'Start' : `Turn ${moment.turn}`;
    this.cards.update(moment.turn);
    this.table.update(moment.turn);
  }

  #updateLink(moment, now) {
    const link = `#turn=${moment.turn}`;
    if (location.hash === link || this.isLinkKept) return;
    this.#lastLink = now;
    history.replaceState(null, '', link);
  }

  /** Goes to the turn that the link names; returns whether it names one. */
  followLink() {
    const turn = /^#turn=(\d+)$/.exec(location.hash);
    if (turn) this.playback.seek(Number(turn[1]));
    return Boolean(turn);
  }

  /** Shows words; with a button that connects again where there is something to connect to. */
  say(words, connect) {
    const notice = find('notice');
    notice.textContent = words;
    notice.hidden = !words;
    if (!connect) return;
    const button = document.createElement('button');
    button.textContent = 'Connect again';
    button.addEventListener('click', connect);
    notice.append(' ', button);
  }
}

// ---- controls ------------------------------------------------------------------------------------

/** What each key does; the buttons do the same. */
function actionsOf(page) {
  const { playback } = page;
  return {
    ' ': () => playback.toggle(),
    ArrowLeft: () => playback.stepTurn(-1),
    ArrowRight: () => playback.stepTurn(1),
    ArrowUp: () => playback.changeSpeed(1),
    ArrowDown: () => playback.changeSpeed(-1),
    '[': () => playback.stepImpact(-1),
    ']': () => playback.stepImpact(1),
    Home: () => playback.seek(0),
    End: () => playback.seek(playback.end),
    '?': () => find('help').showModal(),
  };
}

function connectControls(page) {
  const actions = actionsOf(page);
  document.querySelectorAll('[data-key]').forEach(button => {
    button.addEventListener('click', () => actions[button.dataset.key]());
  });
  document.addEventListener('keydown', event => onKey(event, actions));
  find('speed').append(...SPEEDS.map(speed => new Option(`${speed}×`, String(speed))));
  find('speed').addEventListener('change', event => page.playback.setSpeed(Number(event.target.value)));
  find('theme').addEventListener('click', () => page.theme.toggle());
  document.querySelectorAll('[data-show]').forEach(box => {
    box.addEventListener('change', () => {
      page.stage.show[box.dataset.show] = box.checked;
      page.draw();
    });
  });
  connectTap(find('field'), () => page.playback.toggle());
  addEventListener('hashchange', () => page.followLink());
}

function onKey(event, actions) {
  if (find('help').open) return;
  const { target, key } = event;
  const isElsewhere = target.matches('select, summary, input:not([type=range])')
    || (key === ' ' && target.matches('button:focus-visible'));
  if (event.ctrlKey || event.altKey || event.metaKey || isElsewhere || !actions[key]) return;
  event.preventDefault();
  actions[key]();
}

/** A tap, not the beginning of scrolling. */
function connectTap(target, action) {
  let down = null;
  target.addEventListener('pointerdown', event => {
    down = event;
  });
  target.addEventListener('pointerup', event => {
    if (down && Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) < TAP_PIXELS) action();
    down = null;
  });
  target.addEventListener('pointercancel', () => {
    down = null;
  });
}

// ---- where turns come from -----------------------------------------------------------------------

/** The lines of the replay that is embedded in the page, gzip in base64. */
async function embeddedLines(source) {
  const bytes = Uint8Array.from(atob(source.textContent.trim()), letter => letter.charCodeAt(0));
  const plain = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return (await new Response(plain).text()).split('\n').filter(line => line);
}

/** Whoever serves the match goes when it is over: what Save gives is fetched before, and kept by the page. */
async function keepCopy() {
  const save = document.querySelector('a[download]');
  const answer = save && await fetch(save.href);
  if (!answer || !answer.ok) return;
  save.download = save.getAttribute('href');
  save.href = URL.createObjectURL(await answer.blob());
}

/** Follows a match as server-sent events: each message is one line of the replay; "end" closes. */
function followLive(page, feed) {
  page.playback.live = true;
  document.body.classList.add('live');
  const events = new EventSource(feed);
  let lostSince = null;
  const close = () => {
    events.close();
    page.playback.live = false;
    document.body.classList.remove('live');
  };
  const stop = () => {
    close();
    keepCopy().catch(() => page.say('The connection is lost: this match can be watched, but no longer saved.'));
  };
  const giveUp = words => {                      // what Save gives would be nothing, or another match
    close();
    document.querySelector('a[download]')?.remove();
    page.say(words);
  };
  events.addEventListener('message', event => {
    lostSince = null;
    page.say('');
    page.addLine(event.data);
    if (page.match.isAnotherPlayed) giveUp('Another match is played here now; reload to see it.');
    else if (page.match.result) stop();
  });
  events.addEventListener('end', stop);
  events.addEventListener('refused', event => {
    close();
    page.say(event.data, () => {
      page.say('');
      followLive(page, feed);
    });
  });
  events.addEventListener('error', () => {
    lostSince ??= performance.now();
    const isOver = events.readyState === EventSource.CLOSED || performance.now() - lostSince > LOST_MS;
    if (isOver) giveUp('The match has ended early.');
    else page.say('The connection is lost; trying again.');
  });
  page.playback.play();
}

async function showEmbedded(page, source) {
  const lines = await embeddedLines(source);
  page.isLinkKept = true;
  lines.forEach(line => page.addLine(line));
  page.isLinkKept = false;
  page.say(source.dataset.warning ?? '');
  if (!page.followLink() && page.match.lastTurn && !page.theme.isCalm) page.playback.play();
}

/**
 * For tests and for the curious, in the console: where the page stands, and where it draws what. Places are in CSS
 * pixels of the window.
 */
function hookOf(page) {
  const toWindow = (x, y) => {
    const { left, top } = find('field').getBoundingClientRect();
    return { x: left + page.stage.view.x(x), y: top + page.stage.view.y(y) };
  };
  return {
    turn: () => page.playback.moment.turn,
    time: () => page.playback.time,
    lastTurn: () => page.match.lastTurn,
    seek(turn, fraction = 1) {
      page.playback.seek(turn === 0 ? 0 : turn - 1 + fraction);
      page.draw();
    },
    bodies: () => page.match.bodiesAt(page.playback.moment).map(body => ({ id: body.id, owner: body.owner,
      ...toWindow(body.x, body.y), radius: body.radius * page.stage.view.scale })),
    impacts: () => page.match.impacts.map(met => {
      const { x, y } = contactOf(page.match, met);
      return { time: met.time, ...toWindow(x, y), radius: flashRadius(page.match, met) * page.stage.view.scale };
    }),
    field: () => {
      const { left, top, right, bottom } = page.stage.field;
      const [from, to] = [toWindow(left, top), toWindow(right, bottom)];
      return { left: from.x, top: from.y, right: to.x, bottom: to.y };
    },
    playing: () => page.playback.playing,
    speed: () => page.playback.speed,
    colourOf: player => page.theme.team(player),
    play: () => page.playback.play(),
    pause: () => page.playback.pause(),
    addTurn: line => page.addLine(line),
    ready: false,
  };
}

async function start() {
  const page = new Page();
  window.steward = hookOf(page);
  connectControls(page);
  const source = find('replay');
  try {
    if (source.dataset.feed) followLive(page, source.dataset.feed);
    else await showEmbedded(page, source);
  } catch (problem) {
    page.say(`This replay cannot be shown: ${problem.message}`);
    throw problem;
  } finally {
    page.redrawAll();
    window.steward.ready = true;
  }
}

start();
