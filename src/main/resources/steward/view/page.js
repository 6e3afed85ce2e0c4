// Puts the page together: reads the embedded replay or follows a live match, and connects clock, drawing and controls.

import { Cards } from './cards.js';
import { Charts } from './charts.js';
import { connectControls } from './controls.js';
import { impactsCsv, statesCsv } from './csv.js';
import { embeddedLines, embeddedRecords, followFeed } from './feed.js';
import { Happened } from './happened.js';
import { lookOf } from './looks.js';
import { Match } from './match.js';
import { BodyList, StateTable } from './panels.js';
import { Playback } from './playback.js';
import { Pointer } from './pointer.js';
import { Ending, Scores } from './scores.js';
import { Search } from './search.js';
import { Series } from './series.js';
import { Share } from './share.js';
import { Sheet } from './sheet.js';
import { Side } from './side.js';
import { Stage } from './stage.js';
import { Theme } from './theme.js';
import { nameOf } from './text.js';
import { Timeline } from './timeline.js';
import { loadLibrary } from './unpack.js';
import './podrace.js';
import './searchrace.js';
import './meanmax.js';
import './fantasticbits.js';
import './pokerchiprace.js';
import './bodies.js';
import { hookOf } from './hook.js';
import { outerPage } from './outer.js';

const PANEL_MS = 100;           // while playing, texts change no more often than this
const LINK_MS = 1000;           // nor does the link
const TOLD_MS = 2500;           // how long a short word stays
const MOST_FOLLOWED = 12;       // bodies whose state is followed within a turn while it plays
const PICTURE = '&picture';     // end of a link to a moment without controls
const LONGEST_FRAME = 0.25;     // seconds; a page that was hidden goes on where it was

const find = id => document.getElementById(id);

const outer = outerPage();
if (outer) addEventListener('message', ({ source, data }) => source === parent && typeof data?.go === 'string' && window.steward.go(data.go));

export class Page {
  match = new Match();
  theme = new Theme(() => this.redrawAll());
  playback = new Playback(this.match, () => this.changed());
  share = new Share(this);
  sheet = new Sheet(find('sheet'), this.share);
  side = new Side(find('grip'), find('fold'));
  pointer = new Pointer(this);
  #lastFrame = 0;
  #lastPanels = 0;
  #lastLink = 0;
  #isAsked = false;
  #wasPlaying = false;
  #grown = false;
  differsFrom = NaN;              // the first turn in which a server has shown another game
  look; series; stage; timeline; charts; scores; cards; bodies; happened; table; ending; isLinkKept; onFrame; onDrawn;

  /** Takes one line of a replay: from the page itself or as it is played. */
  addLine(line) {
    this.#addRecord(JSON.parse(line));
  }

  addRecords(records) {
    records.forEach(record => this.#addRecord(record));
  }

  #addRecord(record) {
    const hadHeader = Boolean(this.match.header);
    const wasSparse = this.match.isSparse;
    if (!this.match.addRecord(record)) return;
    if (this.match.isSparse && !wasSparse) find('scene').textContent += ' · sparse: straight lines between kept states';
    if (!hadHeader) this.#build();
    else this.#grown = true;
    this.changed();
  }

  #build() {
    const { match, theme } = this;
    const look = lookOf(match.header.game);
    const seek = time => this.playback.seek(time);
    this.look = look;
    this.series = new Series(match, look);
    this.stage = new Stage(find('field'), match, theme, look);
    this.timeline = new Timeline({ canvas: find('marks'), range: find('scrub'), tip: find('tip') }, match, theme, this.series, look);
    this.timeline.connect(this.playback);
    this.charts = new Charts(find('charts'), match, theme, this.series, look, seek);
    this.scores = new Scores(find('scores'), match, look, this.series);
    this.cards = new Cards(find('cards'), match, look, this.sheet, player => {
      this.#chosen = player === this.mine ? null : player;
      this.refresh();
    });
    this.search = new Search({ input: /** @type {HTMLInputElement} */ (find('search')), list: find('found'), count: find('found-count') }, match, look, sought => {
      this.cards.sought = sought;
      this.refresh();
    }, place => this.#goTo(place));
    this.search.time = () => this.playback.time;
    this.#connectExports();
    this.bodies = new BodyList(find('bodies'), match, look, id => this.pointer.choose(id));
    this.happened = new Happened(find('happened'), match, this.timeline, seek);
    this.table = new StateTable(find('state'), find('state-when'), match, look);
    this.ending = new Ending(find('ending'), match, this.series, seek);
    find('scene').textContent = `${match.header.scene?.name ?? match.header.game} · seed ${match.header.seed}${packedWords(match.header)}`;
    if (!match.players.length) document.title = find('title').textContent = match.header.scene?.name ?? match.header.game;
    document.body.classList.toggle('drawingless', look.isUndrawn);
    new ResizeObserver(() => this.redrawAll()).observe(find('field'));
    this.redrawAll();
  }

  #connectExports() {
    const { match, share } = this;
    const actions = { states: () => share.csv('states', statesCsv(match)), impacts: () => share.csv('impacts', impactsCsv(match)),
      body: () => share.csv(`body-${this.stage.selected}`, statesCsv(match, this.stage.selected)), whole: () => this.table.openWhole(this.sheet) };
    document.querySelectorAll('[data-export]').forEach(button =>
      button.addEventListener('click', () => actions[button.dataset.export]()));
  }

  /** The player whose events count: the one whose name was pressed, or the owner of the selected body; null for all. */
  get mine() {
    const owner = this.stage.selected === null ? null : this.match.describeIn(this.stage.selected, this.playback.moment.turn).owner;
    return this.#chosen ?? owner;
  }
  #chosen = null;

  /** To the next or last impact, event of the player that counts, or fault. */
  step(kind, direction) {
    const { match, playback, happened } = this;
    const list = kind === 'impact' ? match.impacts : kind === 'fault' ? match.faults : happened.eventsOf(this.mine);
    if (!playback.stepTo(list, direction)) this.tell(`There is no ${direction > 0 ? 'later' : 'earlier'} ${kind}`);
  }

  /** To a place that was found. */
  #goTo(place) {
    this.playback.seek(place.time);
    this.refresh();
    this.draw();
    if (place.player !== null) this.cards.reveal(place);
  }

  /** After a change of size or colours. */
  redrawAll() {
    if (!this.stage) return;
    this.#resizeStage();
    this.timeline.draw();
    this.charts.build();
    this.draw();
  }

  #resizeStage() {
    const scores = find('scores');
    const isOver = getComputedStyle(scores).position === 'absolute';
    this.stage.resize(isOver ? scores.offsetHeight + 18 : 0);
  }

  /** Something moved: draw with the next frame, and go on drawing while it plays. */
  changed() {
    if (this.#isAsked || !this.stage) return;
    this.#isAsked = true;
    requestAnimationFrame(now => this.#frame(now));
  }

  #frame(now) {
    const start = performance.now();
    const seconds = Math.min(LONGEST_FRAME, (now - this.#lastFrame) / 1000);
    this.#lastFrame = now;
    this.playback.isCalm = this.theme.isCalm;
    if (this.#wasPlaying && this.playback.playing) this.playback.advance(seconds);
    this.#wasPlaying = this.playback.playing;
    this.#isAsked = false;
    if (this.#grown && (now - this.#lastPanels >= PANEL_MS || !this.playback.playing)) this.#showGrowth();
    const isMoving = this.stage.advance(this.playback.moment, seconds || 0.016);
    this.draw();
    if (this.playback.playing || isMoving) this.changed();
    this.onFrame?.(performance.now() - start, this.playback.moment.turn);
  }

  /** More turns than before. */
  #showGrowth() {
    this.#grown = false;
    this.#resizeStage();
    this.timeline.draw();
  }

  /** Something was chosen: draw all of it with the next frame. */
  refresh() {
    this.#lastPanels = 0;
    this.changed();
  }

  /** Draws the present moment. */
  draw() {
    const { playback } = this;
    const moment = playback.moment;
    this.stage.draw(moment, playback.turnsPerSecond);
    this.timeline.move(playback.time);
    this.ending.update(playback.time >= playback.end);
    this.onDrawn?.();
    const now = performance.now();
    if (!playback.playing || now - this.#lastPanels >= PANEL_MS) this.#drawPanels(moment, now);
    if (!playback.playing || now - this.#lastLink >= LINK_MS) this.#updateLink(now);
  }

  #drawPanels(moment, now) {
    this.#lastPanels = now;
    const { playback, stage, match } = this;
    find('play').setAttribute('aria-pressed', String(playback.playing));
    find('play').setAttribute('aria-label', playback.playing ? 'Pause' : 'Play');
    find('speed').value = String(playback.speed);
    find('time').textContent = playback.time.toFixed(2);
    document.body.classList.toggle('follows', playback.follows);
    this.scores.update(moment, stage.standing(moment));
    this.charts.draw(playback.time);
    this.happened.update(moment);
    this.bodies.update(moment, stage.selected);
    const key = playback.playing && match.start.bodies.size > MOST_FOLLOWED ? moment.settled : moment.time;
    if (key !== this.#shownState) {
      this.#shownState = key;
      this.table.update(moment);
    }
    this.#showSteps();
    const shown = `${moment.turn} ${this.mine} ${this.cards.sought}`;
    if (shown === this.#shownTurn) return;                  // what is being selected or scrolled there stays
    this.#shownTurn = shown;
    find('turn-shown').textContent = moment.turn === 0 ? 'Start' : `Turn ${moment.turn}`;
    this.cards.update(moment.turn, this.mine);
    find('differs').hidden = !(moment.turn >= this.differsFrom);
  }

  /** What there is to go to, and whose events. */
  #showSteps() {
    const { match, mine, stage } = this;
    const has = { impact: match.impacts.length > 0, event: match.events.some(({ event }) => event.text), fault: match.faults.length > 0 };
    for (const [kind, isThere] of Object.entries(has)) find(`step-${kind}`).hidden = !isThere;
    find('event-of').textContent = mine === null ? 'Event' : `Event of ${nameOf(match, mine)}`;
    find('export-body').disabled = stage.selected === null;
    find('export-body').textContent = stage.selected === null ? 'Selected body' : `Body ${stage.selected}`;
  }
  #shownState = NaN;
  #shownTurn = '';

  #updateLink(now) {
    const link = `#t=${this.playback.time.toFixed(2)}`;
    if (this.isLinkKept || link === this.#shownLink) return;
    this.#lastLink = now;
    this.#shownLink = link;
    if (outer) return void parent.postMessage({ moment: link }, '*');
    try {
      history.replaceState(null, '', link);
    } catch {
      this.isLinkKept = true;       // inside another page there may be no address to change
    }
  }

  #shownLink = '';

  /** Goes to the moment that a link names, #t=28.66, #turn=57, #fault or #fault=1 of a player; returns whether it names one. */
  followLink(link = outer?.link ?? location.hash) {
    const failed = /^#fault(?:=(\d+))?$/.exec(link);
    if (failed) {
      const fault = this.match.faults.find(each => failed[1] === undefined || each.player === Number(failed[1]));
      if (fault) this.playback.seek(fault.time);
      return Boolean(fault);
    }
    const named = /^#(?:t|turn)=(\d+(?:\.\d+)?)$/.exec(link);
    if (named && Math.abs(Number(named[1]) - this.playback.time) > 0.005) this.playback.seek(Number(named[1]));
    return Boolean(named);
  }

  /** A short word that goes by itself. */
  tell(words) {
    const box = find('told');
    box.textContent = words;
    box.hidden = false;
    clearTimeout(this.#told);
    this.#told = setTimeout(() => (box.hidden = true), TOLD_MS);
  }
  #told = 0;

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

/** Only what a picture shows. */
function showBare(page) {
  document.body.classList.add('bare');
  page.isLinkKept = true;
  page.redrawAll();
}

/** What the page does not have of a long replay. */
function packedWords({ packed }) {
  return packed ? ` · ${packed.every > 1 ? `a state every ${packed.every} turns, ` : ''}numbers rounded to the screen` : '';
}

async function showEmbedded(page, source) {
  const records = await embeddedRecords(source);
  const [errors, ...sent] = find('details').textContent.trim() ? await embeddedLines(find('details')) : ['[]'];
  page.isLinkKept = true;
  page.match.sent = sent.length ? sent.map(line => JSON.parse(line)) : null;
  JSON.parse(errors).forEach(([turn, player, line]) => page.match.errors.set(`${turn} ${player}`, line));
  page.addRecords(records);
  page.isLinkKept = false;
  page.say(source.dataset.warning ?? '');
  page.differsFrom = Number(source.dataset.differsFrom ?? NaN);
  find('differs').textContent = source.dataset.differs ?? '';
  const link = outer?.link ?? location.hash;
  if (link.endsWith(PICTURE)) showBare(page);
  if (!page.followLink(link.replace(PICTURE, '')) && page.match.lastTurn && !page.theme.isCalm) page.playback.play();
}

async function start() {
  const page = new Page();
  window.steward = hookOf(page);
  connectControls(page);
  const source = find('replay');
  try {
    await loadLibrary();
    if (source.dataset.feed) followFeed(page, source.dataset.feed);
    else await showEmbedded(page, source);
    page.redrawAll();
    document.body.removeAttribute('data-problem');
  } catch (problem) {
    document.body.dataset.problem = problem.message;        // for those who only look at the elements
    page.say(`This replay cannot be shown: ${problem.message}`);
    throw problem;
  } finally {
    window.steward.ready = true;
  }
}

start();
