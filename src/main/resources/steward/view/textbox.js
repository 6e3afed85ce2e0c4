// Long text of a bot in a box: what matters is marked and in view; it can be copied, and read whole in a sheet.

import { element } from './text.js';

const MOST_IN_BOX = 20_000;      // characters in the box: of longer text those around what matters

/** A small button that does something with a text. */
export function tool(words, title, action) {
  const button = element('button', 'tool', words);
  button.type = 'button';
  button.title = title;
  button.setAttribute('aria-label', title);
  button.addEventListener('click', action);
  return button;
}

export class TextBox {
  #text = '';
  #key = null;

  /**
   * @param {string} kind its class
   * @param {string} name what it is, and whose
   * @param {import('./sheet.js').Sheet} sheet
   * @param {boolean} opensAtEnd true if the end matters most
   */
  constructor(kind, name, sheet, opensAtEnd) {
    this.opensAtEnd = opensAtEnd;
    this.pre = element('pre', `text ${kind}`);
    this.pre.tabIndex = 0;
    this.pre.setAttribute('role', 'group');
    this.pre.setAttribute('aria-label', name);
    this.root = element('div', 'text-box', null, this.pre, element('span', 'tools', null,
      tool('Copy', `Copy ${name}`, ({ target }) => sheet.copy(this.#text, target)),
      tool('Whole', `Show ${name} whole`, () => sheet.openText(name, this.#text, this.#mark))));
  }
  #mark = null;

  /**
   * Shows text, nothing if there is none.
   * @param {string} text
   * @param {any} [mark] what matters in it: from, to, and its kind
   */
  show(text, mark = null) {
    this.root.hidden = this.pre.hidden = !text;
    const key = `${mark?.from} ${mark?.to}`;
    if (text === this.#text && key === this.#key) return;
    [this.#text, this.#key, this.#mark] = [text, key, mark];
    fillMarked(this.pre, text, mark, this.opensAtEnd);
    this.scroll();
  }

  /** Brings into view what matters; of a box that is not drawn yet it cannot. */
  scroll() {
    const marked = this.pre.querySelector('mark');
    this.pre.scrollTop = marked ? marked.offsetTop - this.pre.clientHeight / 2 + 16 : this.opensAtEnd ? this.pre.scrollHeight : 0;
  }
}

/** Puts text with a mark into an element, at most so many characters of it. */
export function fillMarked(target, text, mark, atEnd, most = MOST_IN_BOX) {
  const middle = mark ? mark.from : atEnd ? text.length : 0;
  const from = text.length <= most ? 0 : Math.max(0, Math.min(text.length - most, middle - most / 2));
  const to = Math.min(text.length, from + most);
  const left = count => (count ? element('i', '', `(${count} more characters)`) : '');
  const parts = mark && mark.to > mark.from
    ? [text.slice(from, mark.from), element('mark', mark.kind, text.slice(mark.from, mark.to)), text.slice(mark.to, to)]
    : [text.slice(from, to)];
  target.replaceChildren(left(from), ...parts, left(text.length - to));
}

/** Where a line of a text begins and ends, as a mark; null where there is none. */
export function lineMark(text, line, kind) {
  const from = line ? text.lastIndexOf(line) : -1;
  return from < 0 ? null : { from, to: from + line.length, kind };
}
