// To hand on: a link to the moment, a picture of it, a clip of turns.

import { Clip } from './clip.js';
import { outerPage } from './outer.js';
import { drawPoster } from './poster.js';

const ADDRESSES = /^(https?|file):$/;    // a page in a page, or one that a league opened, may be elsewhere

/** True if the page is locked up in another one, as in a notebook: it has no origin, keeps nothing and may save no file. */
function isClosed() {
  if (self.origin !== 'null') return false;
  try {
    return localStorage === null;
  } catch {
    return true;
  }
}

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
    this.#download(new Blob([text], { type: 'text/csv' }), `${name}.csv`);
  }

  /** A PNG of the field, who plays, the scores and at the end who won. */
  picture() {
    const { page } = this;
    const time = page.playback.time.toFixed(2);
    page.draw();
    const canvas = drawPoster(page, document.createElement('canvas'));
    if (isClosed()) this.#openPicture(canvas, time);
    else canvas.toBlob(blob => this.#save(blob, `${time}.png`), 'image/png');
  }

  /** Opens the picture in the page: where the page has no origin, as in a notebook, it may save nothing by itself. */
  #openPicture(canvas, time) {
    const image = document.createElement('img');
    image.src = canvas.toDataURL('image/png');
    image.alt = `The match at ${time}`;
    image.style.maxWidth = '100%';
    const words = document.createElement('p');
    words.textContent = 'Save it from here: by the menu of the picture, a right click or a long press.';
    this.page.sheet.open(`Picture at ${time}`, [words, image], image.src);
  }

  /** A clip of a range of turns. */
  clip() {
    this.#clip ??= new Clip(this.page, (blob, name) => this.#save(blob, name));
    this.#clip.ask();
  }
  #clip = null;

  /** Hands a file to the phone's own dialog of sharing, or saves it. */
  async #save(blob, what) {
    const shared = new File([blob], this.#nameOf(what), { type: blob.type });
    if (matchMedia('(pointer: coarse)').matches && navigator.canShare?.({ files: [shared] })) {
      try {
        return await navigator.share({ files: [shared] });
      } catch (problem) {
        if (problem.name === 'AbortError') return undefined;
      }
    }
    return this.#download(blob, what);
  }

  #nameOf(what) {
    return `${(this.page.match.header.scene?.name ?? 'match').replace(/[^\w-]+/g, '-')}-${what}`;
  }

  #download(blob, what) {
    const link = document.createElement('a');
    link.download = this.#nameOf(what);
    link.href = URL.createObjectURL(blob);
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
    this.page.tell(`Saved ${link.download}`);
  }
}
