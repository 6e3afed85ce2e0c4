// Clips of the match: a WebM recorded while it plays, or a GIF drawn moment by moment; of a range of turns or the whole.

import { drawPoster, sizeOf } from './poster.js';

const CLIP_RATE = 60;
const CLIP_BITS = 8e6;
const CLIP_TYPES = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'];
const USUAL_TURNS = 30;
const GIF_WIDTH = 640;          // pixels at most
const GIF_MS = 80;              // of a picture
const GIF_MOST = 500;           // pictures; a longer match is drawn faster
const GIF_COLOURS = 128;
const GIF_END_MS = 1500;

const clipPart = id => document.getElementById(id);

export class Clip {
  /** @param {(blob: Blob, name: string) => void} save */
  constructor(page, save) {
    this.page = page;
    this.save = save;
    this.dialog = /** @type {HTMLDialogElement} */ (clipPart('clip-of'));
    clipPart('clip-whole').addEventListener('click', () => this.#range(0, page.match.lastTurn));
    this.dialog.addEventListener('close', () => this.dialog.returnValue === 'make' && this.#make());
  }
  stop = null;                  // ends what is being made

  #range(from, to) {
    Object.assign(clipPart('clip-from'), { value: String(from), max: String(this.page.match.lastTurn) });
    Object.assign(clipPart('clip-to'), { value: String(to), max: String(this.page.match.lastTurn) });
  }

  /** Asks what to make, or ends what is being made. */
  ask() {
    if (this.stop) return this.stop();
    const from = Math.floor(this.page.playback.time);
    const end = this.page.match.lastTurn;
    this.#range(from >= end ? 0 : from, from >= end ? end : Math.min(end, from + USUAL_TURNS));
    this.dialog.returnValue = '';
    this.dialog.showModal();
  }

  #make() {
    const value = id => Number(/** @type {HTMLInputElement} */ (clipPart(id)).value);
    const end = this.page.match.lastTurn;
    const from = Math.max(0, Math.min(end, value('clip-from')));
    const to = Math.max(from, Math.min(end, value('clip-to')));
    if (!(to > from)) return this.page.tell('A clip ends after it begins');
    const isGif = /** @type {HTMLSelectElement} */ (clipPart('clip-as')).value === 'gif';
    return isGif ? this.gif(from, to) : this.webm(from, to);
  }

  #begin(stop) {
    this.stop = stop;
    document.body.classList.add('recording');
  }

  #end() {
    this.stop = null;
    document.body.classList.remove('recording');
  }

  /** Records the turns as they are played, at the present speed. */
  webm(from, to) {
    const { page } = this;
    const type = CLIP_TYPES.find(each => window.MediaRecorder?.isTypeSupported(each));
    if (!type) return page.tell('This browser records no WebM; a GIF can be made');
    const canvas = document.createElement('canvas');
    page.playback.seek(from);
    page.draw();
    drawPoster(page, canvas);
    const parts = [];
    const stream = canvas.captureStream(CLIP_RATE);
    const recorder = new MediaRecorder(stream, { mimeType: type, videoBitsPerSecond: CLIP_BITS });
    const stop = () => recorder.state === 'recording' && recorder.stop();
    recorder.addEventListener('dataavailable', event => parts.push(event.data));
    recorder.addEventListener('stop', () => {
      page.onDrawn = null;
      page.playback.pause();
      stream.getTracks().forEach(track => track.stop());
      this.#end();
      this.save(new Blob(parts, { type: 'video/webm' }), `${from}-${to}.webm`);
    });
    page.onDrawn = () => {
      drawPoster(page, canvas);
      if (page.playback.time < to - 1e-9 && page.playback.playing) return;
      page.onDrawn = null;
      setTimeout(stop, to >= page.match.lastTurn ? GIF_END_MS : 100);      // the end is seen
    };
    this.#begin(stop);
    recorder.start();
    page.playback.play();
    page.tell(`Recording turns ${from} to ${to}; Clip ends it`);
  }

  /** Draws the turns one picture after the other. */
  async gif(from, to) {
    const { page } = this;
    const { GIFEncoder, applyPalette, quantize } = window['gifenc'];
    const encoder = GIFEncoder();
    const canvas = document.createElement('canvas');
    const width = Math.min(GIF_WIDTH, sizeOf(page).width);
    const step = Math.max((to - from) / GIF_MOST, 5 * page.playback.speed * GIF_MS / 1000);
    let isStopped = false;
    this.#begin(() => (isStopped = true));
    for (let time = from; !isStopped; time = Math.min(to, time + step)) {
      page.playback.seek(time);
      page.draw();
      drawPoster(page, canvas, width);
      const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
      const palette = quantize(data, GIF_COLOURS, { format: 'rgb444' });
      const isLast = time >= to;
      encoder.writeFrame(applyPalette(data, palette, 'rgb444'), canvas.width, canvas.height, { palette, delay: isLast ? GIF_END_MS : GIF_MS });
      if (isLast) break;
      page.tell(`GIF: turn ${Math.floor(time)} of ${to}; Clip ends it`);
      await new Promise(done => setTimeout(done));
    }
    encoder.finish();
    this.#end();
    this.save(new Blob([encoder.bytes()], { type: 'image/gif' }), `${from}-${to}.gif`);
  }
}
