// A sheet over the page: texts and tables whole, to be read, copied and saved.

import { element } from './text.js';
import { fillMarked, tool } from './textbox.js';

const MOST_IN_SHEET = 2_000_000;    // characters
const COPIED_MS = 1200;

export class Sheet {
  constructor(dialog, share) {
    this.dialog = dialog;
    this.share = share;
    this.title = dialog.querySelector('h2');
    this.tools = dialog.querySelector('.sheet-tools');
    this.content = dialog.querySelector('.sheet-content');
  }

  /** Opens with a text, whole, and what is marked in it in view. */
  openText(title, text, mark) {
    const pre = element('pre');
    fillMarked(pre, text, mark, true, MOST_IN_SHEET);
    this.open(title, [pre], text);
    pre.querySelector('mark')?.scrollIntoView({ block: 'center' });
  }

  /**
   * Opens with elements.
   * @param {string} title
   * @param {Node[]} nodes
   * @param {string} text what is copied
   * @param {HTMLElement[]} tools further buttons
   */
  open(title, nodes, text, tools = []) {
    this.title.textContent = title;
    this.tools.replaceChildren(tool('Copy', `Copy ${title}`, ({ target }) => this.copy(text, target)), ...tools);
    this.content.replaceChildren(...nodes);
    this.dialog.showModal();
    this.content.scrollTop = 0;
  }

  /** Copies, and the button says for a moment whether it did. */
  async copy(text, button) {
    const words = button.textContent;
    button.textContent = await this.share.copy(text) ? 'Copied' : 'Not copied';
    setTimeout(() => (button.textContent = words), COPIED_MS);
  }
}
