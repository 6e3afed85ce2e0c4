// The panel of details: its edge is dragged, or moved by arrow keys; folded it leaves the field all of the page.

import { remember, remembered } from './theme.js';

const USUAL = 344;              // pixels, as in the style sheet
const LEAST = 260;
const MOST_SHARE = 0.75;        // of the page
const STEP = 24;                // pixels of a key
const STORED_WIDTH = 'steward-panel';

export class Side {
  /** @param {HTMLElement} grip @param {HTMLElement} button folds and unfolds */
  constructor(grip, button) {
    this.grip = grip;
    this.button = button;
    this.#set(Number(remembered(STORED_WIDTH)) || USUAL);
    grip.addEventListener('pointerdown', event => grip.setPointerCapture(event.pointerId));
    grip.addEventListener('pointermove', event => {
      if (grip.hasPointerCapture(event.pointerId)) this.#set(window.innerWidth - event.clientX);
    });
    grip.addEventListener('lostpointercapture', () => remember(STORED_WIDTH, String(this.width)));
    grip.addEventListener('dblclick', () => this.#set(USUAL));
    grip.addEventListener('keydown', event => {
      const step = { ArrowLeft: STEP, ArrowRight: -STEP }[event.key];
      if (!step) return;
      event.stopPropagation();                                // the arrow is not one of the match
      event.preventDefault();
      this.#set(this.width + step);
      remember(STORED_WIDTH, String(this.width));
    });
  }
  width = USUAL;

  #set(width) {
    this.width = Math.round(Math.max(LEAST, Math.min(MOST_SHARE * window.innerWidth, width)));
    document.documentElement.style.setProperty('--side', `${this.width}px`);
    this.grip.setAttribute('aria-valuenow', String(this.width));
    this.grip.setAttribute('aria-valuemin', String(LEAST));
    this.grip.setAttribute('aria-valuemax', String(Math.round(MOST_SHARE * window.innerWidth)));
  }

  /** Folds the panel, or unfolds it. */
  fold() {
    const isFolded = document.body.classList.toggle('folded');
    this.button.setAttribute('aria-pressed', String(!isFolded));
  }
}
