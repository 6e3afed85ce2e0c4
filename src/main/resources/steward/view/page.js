// Puts the page together: reads the embedded replay or follows a live match, and connects clock, drawing and controls.

import { Charts } from './charts.js';
import { connectControls } from './controls.js';
import { embeddedLines, followFeed } from './feed.js';
import { Happened } from './happened.js';
import { lookOf } from './looks.js';
import { Match } from './match.js';
import { BodyList, Cards, StateTable } from './panels.js';
import { Playback } from './playback.js';
import { Pointer } from './pointer.js';
import { Ending, Scores } from './scores.js';
import { Series } from './series.js';
import { Share } from './share.js';
import { Stage } from './stage.js';
import { Theme } from './theme.js';
import { Timeline } from './timeline.js';
import './podrace.js';
import './searchrace.js';
import './meanmax.js';
import './fantasticbits.js';
import './pokerchiprace.js';
import './bodies.js';
import { hookOf } from './hook.js';

const PANEL_MS = 100;           // while playing, texts change no more often than this
const LINK_MS = 1000;           // nor does the link
const TOLD_MS = 2500;           // how long a short word stays
const MOST_FOLLOWED = 12;       // bodies whose state is followed within a turn while it plays
const LONGEST_FRAME = 0.25;     // seconds; a page that was hidden goes on where it was

const find = id => document.getElementById(id);

export class Page {
  match = new Match();
  theme = new Theme(() => this.redrawAll());
  playback = new Playback(this.match, () => this.changed());
  share = new Share(this);
  pointer = new Pointer(this);
  #lastFrame = 0;
  #lastPanels = 0;
  #lastLink = 0;
  #isAsked = false;
  #wasPlaying = false;
  #grown = false;
  look; series; stage; timeline; charts; scores; cards; bodies; happened; table; ending; isLinkKept; onFrame;

  /** Takes one line of a replay: from the page itself or as it is played. */
  addLine(line) {
    const hadHeader = Boolean(this.match.header);
    const wasSparse = this.match.isSparse;
    if (!this.match.addLine(line)) return;
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
    this.cards = new Cards(find('cards'), match, look);
    this.bodies = new BodyList(find('bodies'), match, look, id => this.pointer.choose(id));
    this.happened = new Happened(find('happened'), match, this.timeline, seek);
    this.table = new StateTable(find('state'), find('state-when'), match, look);
    this.ending = new Ending(find('ending'), match);
    find('scene').textContent = `${match.header.scene?.name ?? match.header.game} · seed ${match.header.seed}`;
    document.body.classList.toggle('drawingless', look.isUndrawn);
    new ResizeObserver(() => this.redrawAll()).observe(find('field'));
    this.redrawAll();
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
    if (moment.turn === this.#shownTurn) return;            // what is being selected or scrolled there stays
    this.#shownTurn = moment.turn;
    find('turn-shown').textContent = moment.turn === 0 ? 'Start' : `Turn ${moment.turn}`;
    this.cards.update(moment.turn);
  }
  #shownState = NaN;
  #shownTurn = NaN;

  #updateLink(now) {
    const link = `#t=${this.playback.time.toFixed(2)}`;
    if (location.hash === link || this.isLinkKept) return;
    this.#lastLink = now;
    try {
      history.replaceState(null, '', link);
    } catch {
      this.isLinkKept = true;       // inside another page there may be no address to change
    }
  }

  /** Goes to the moment that a link names, #t=28.66 or #turn=57; returns whether it names one. */
  followLink(link = location.hash) {
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

async function showEmbedded(page, source) {
  const lines = await embeddedLines(source);
  const sent = find('sent')?.textContent.trim() ? await embeddedLines(find('sent')) : null;
  page.isLinkKept = true;
  page.match.sent = sent?.map(line => JSON.parse(line)) ?? null;
  lines.forEach(line => page.addLine(line));
  page.isLinkKept = false;
  page.say(source.dataset.warning ?? '');
  if (!page.followLink() && page.match.lastTurn && !page.theme.isCalm) page.playback.play();
}

async function start() {
  const page = new Page();
  window.steward = hookOf(page);
  connectControls(page);
  const source = find('replay');
  try {
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
