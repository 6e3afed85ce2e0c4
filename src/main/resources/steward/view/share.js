// To hand on: a link to the moment, a picture of it, a clip of the next seconds.

import { outerPage } from './outer.js';
import { pictureOf } from './stage.js';
import { nameOf } from './text.js';

const CLIP_SECONDS = 6;
const CLIP_RATE = 60;
const ADDRESSES = /^(https?|file):$/;    // a page in a page, or one that a league opened, may be elsewhere
const CLIP_TYPES = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'];

export class Share {
  constructor(page) {
    this.page = page;
  }

  /** The address of the page with the moment in it, copied. */
  async link() {
    const { page } = this;
    const moment = `#t=${page.playback.time.toFixed(2)}`;
    const outer = outerPage();
    if (!outer && !ADDRESSES.test(location.protocol)) {
      page.tell(`This page has no address of its own; the moment is ${moment}`);
      return;
    }
    const address = outer ? `${outer.address}&${moment.slice(1)}` : location.href.split('#')[0] + moment;
    page.tell(await this.copy(address) ? 'Link copied' : address);
  }

  /** Copies a text; returns whether it could. */
  async copy(text) {
    try {
      await navigator.clipboard.writeText(text);
      return true;
    } catch {
      const field = document.createElement('textarea');     // where the clipboard is closed to pages, as in a file
      field.value = text;
      (document.querySelector('dialog[open]') ?? document.body).append(field);
      field.select();
      const isCopied = document.execCommand('copy');
      field.remove();
      return isCopied;
    }
  }

  /** Saves a table. */
  csv(name, text) {
    this.#save(new Blob([text], { type: 'text/csv' }), `${name}.csv`);
  }

  /** A PNG of the field and who plays. */
  picture() {
    const { match, playback, stage } = this.page;
    const names = match.players.map((_, player) => nameOf(match, player)).join(' – ');
    pictureOf(stage, names, `${match.header.scene?.name ?? match.header.game} · ${playback.time.toFixed(2)}`)
      .toBlob(blob => this.#save(blob, `${playback.time.toFixed(2)}.png`), 'image/png');
  }

  /** A WebM of the next seconds, played at the present speed. */
  clip() {
    const { page } = this;
    if (this.#recorder) {
      this.#recorder.stop();
      return;
    }
    const type = CLIP_TYPES.find(each => window.MediaRecorder?.isTypeSupported(each));
    if (!type) {
      page.tell('This browser records no clips');
      return;
    }
    const parts = [];
    const stream = page.stage.canvas.captureStream(CLIP_RATE);
    const recorder = new MediaRecorder(stream, { mimeType: type, videoBitsPerSecond: 8e6 });
    const timer = setTimeout(() => recorder.state === 'recording' && recorder.stop(), CLIP_SECONDS * 1000);
    this.#recorder = recorder;
    document.body.classList.add('recording');
    recorder.addEventListener('dataavailable', event => parts.push(event.data));
    recorder.addEventListener('stop', () => {
      clearTimeout(timer);
      stream.getTracks().forEach(track => track.stop());
      document.body.classList.remove('recording');
      this.#recorder = null;
      this.#save(new Blob(parts, { type: 'video/webm' }), `${page.playback.time.toFixed(2)}.webm`);
    });
    recorder.start();
    page.playback.play();
    page.tell(`Recording ${CLIP_SECONDS} seconds`);
  }
  #recorder = null;

  #save(blob, what) {
    const link = document.createElement('a');
    const name = (this.page.match.header.scene?.name ?? 'match').replace(/[^\w-]+/g, '-');
    link.download = `${name}-${what}`;
    link.href = URL.createObjectURL(blob);
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
    this.page.tell(`Saved ${link.download}`);
  }
}
