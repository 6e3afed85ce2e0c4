// The clock of the page: where in the match it stands and how fast it goes.

const TURNS_PER_SECOND = 5;
const SPEEDS = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20];
const LIVE_BACKLOG = 3;         // turns that a live match may run ahead before playback hurries
const SAME = 1e-9;

class Playback {
  time = 0;
  speed = 1;
  playing = false;
  live = false;

  constructor(match, onChange) {
    this.match = match;
    this.onChange = onChange;
  }

  get end() {
    return this.match.lastTurn;
  }

  get moment() {
    return momentAt(this.time);
  }

  get turnsPerSecond() {
    if (!this.playing) return 0;
    const backlog = this.live ? this.end - this.time - LIVE_BACKLOG : 0;
    return Math.max(TURNS_PER_SECOND * this.speed, backlog);
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
    if (this.time >= this.end && !this.live) this.playing = false;
    this.onChange();
  }

  /** Stops at a time. */
  seek(time) {
    this.playing = false;
    this.time = Math.min(this.end, Math.max(0, time));
    this.onChange();
  }

  /** To the next or last end of a turn. */
  stepTurn(direction) {
    this.seek(direction > 0 ? Math.floor(this.time + SAME) + 1 : Math.ceil(this.time - SAME) - 1);
  }

  /** To the next or last impact; stays where there is none. */
  stepImpact(direction) {
    const impacts = this.match.impacts;
    const next = direction > 0 ? firstAfter(impacts, this.time + SAME)
      : firstAfter(impacts, this.time - SAME) - 1;
    if (impacts[next]) this.seek(impacts[next].time);
  }

  setSpeed(speed) {
    this.speed = speed;
    this.onChange();
  }

  changeSpeed(direction) {
    const next = SPEEDS.indexOf(this.speed) + direction;
    if (SPEEDS[next]) this.setSpeed(SPEEDS[next]);
  }
}
