// The clock of the page: where in the match it stands and how fast it goes.

import { remember, remembered } from './theme.js';
import { firstAfter, momentAt } from './times.js';

const TURNS_PER_SECOND = 5;
export const SPEEDS = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20];
const LIVE_BACKLOG = 1;         // turns that a live match may run ahead before playback hurries
const HURRY = 16;               // times a second that the backlog is made up
const LIVE_MOST = 1.5;          // turns that a follower is behind at most when a frame is drawn; more may come meanwhile
const SLOW = 0.45;              // the speed shortly before and after the strongest impacts
const SLOW_TURNS = 0.45;
const STRONG = 0.6;             // of the strongest impulse
const STORED_SPEED = 'steward-speed';
const SAME = 1e-9;

export class Playback {
  time = 0;
  speed = 1;
  playing = false;
  live = false;
  follows = false;              // a live match, to its newest turn
  isCalm = false;               // no slow motion

  constructor(match, onChange) {
    this.match = match;
    this.onChange = onChange;
    const kept = Number(remembered(STORED_SPEED));
    if (SPEEDS.includes(kept)) this.speed = kept;
  }

  get end() {
    return this.match.lastTurn;
  }

  get moment() {
    return momentAt(this.time);
  }

  get turnsPerSecond() {
    if (!this.playing) return 0;
    const backlog = this.follows ? HURRY * Math.max(0, this.end - this.time - LIVE_BACKLOG) : 0;
    const slow = this.follows || this.isCalm || this.speed > 1 || !this.#isNearStrongImpact() ? 1 : SLOW;
    return Math.max(TURNS_PER_SECOND * this.speed * slow, backlog);
  }

  #isNearStrongImpact() {
    const { impacts, largestImpulse } = this.match;
    for (let k = firstAfter(impacts, this.time - SLOW_TURNS); k < impacts.length; k++) {
      if (impacts[k].time > this.time + SLOW_TURNS) return false;
      if (Math.abs(impacts[k].impact.impulse ?? 0) > STRONG * largestImpulse) return true;
    }
    return false;
  }

  /** Goes on; from the start if it stands at the end. While a match is live it waits at the end instead. */
  play() {
    if (this.time >= this.end && !this.live) this.time = 0;
    this.playing = true;
    this.onChange();
  }

  pause() {
    this.playing = false;
    this.onChange();
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  /** Lets time pass. */
  advance(seconds) {
    this.time = Math.min(this.end, this.time + seconds * this.turnsPerSecond);
    if (this.follows) this.time = Math.max(this.time, this.end - LIVE_MOST);
    if (this.time >= this.end && !this.live) this.playing = false;
    this.onChange();
  }

  /** Stops at a time. */
  seek(time) {
    this.playing = false;
    this.#moveTo(time);
  }

  /** Goes to a time, and goes on playing if it was. */
  scrub(time) {
    this.#moveTo(time);
  }

  #moveTo(time) {
    this.follows = false;
    this.time = Math.min(this.end, Math.max(0, time));
    this.onChange();
  }

  /** To the end; of a live match, which it then follows. */
  toEnd() {
    this.seek(this.end);
    if (this.live) this.followLive();
  }

  /** Goes to the newest turn of a live match and stays with it. */
  followLive() {
    this.time = Math.max(this.time, this.end - 1);
    this.follows = true;
    this.playing = true;
    this.onChange();
  }

  /** To the next or last end of a turn. */
  stepTurn(direction) {
    this.seek(direction > 0 ? Math.floor(this.time + SAME) + 1 : Math.ceil(this.time - SAME) - 1);
  }

  /** To the next or last of a list in the order of time; returns false, and stays, where there is none. */
  stepTo(list, direction) {
    const next = direction > 0 ? firstAfter(list, this.time + SAME) : firstAfter(list, this.time - SAME) - 1;
    if (list[next]) this.seek(list[next].time);
    return Boolean(list[next]);
  }

  setSpeed(speed) {
    this.speed = speed;
    remember(STORED_SPEED, String(speed));
    this.onChange();
  }

  changeSpeed(direction) {
    const next = SPEEDS.indexOf(this.speed) + direction;
    if (SPEEDS[next]) this.setSpeed(SPEEDS[next]);
  }
}
