// The pointer on the field: what it points at, what it selects, and the camera, which it moves.

import { FOLLOW_MODES } from './camera.js';
import { grouped, nameOf } from './text.js';

const TAP_PIXELS = 8;
const FOLLOW_WORDS = { field: 'The whole field', leader: 'Following the leader', selected: 'Following the selected one',
  all: 'Following all' };
const FAR = -1e6;               // pixels: where nothing is

const part = id => document.getElementById(id);

export class Pointer {
  constructor(page) {
    this.page = page;
  }

  get #view() {
    return this.page.stage.view;
  }

  /** A tap selects a body, or plays and pauses; the wheel zooms, dragging moves, a double click goes back. */
  connect(field) {
    let down = null;
    let last = null;
    const far = event => down && Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY);
    const placeOf = event => {
      const { left, top } = field.getBoundingClientRect();
      return [event.clientX - left, event.clientY - top];
    };
    const on = (name, action, options) =>
      field.addEventListener(name, event => this.page.stage && action(event), options);
    on('pointerdown', event => {
      down = last = event;
      if (event.pointerType === 'mouse') field.setPointerCapture(event.pointerId);
    });
    on('pointermove', event => {
      const isMouse = event.pointerType === 'mouse';
      if (down && far(event) >= TAP_PIXELS && (isMouse || this.#view.isMoved)) {
        this.#view.pan(event.clientX - last.clientX, event.clientY - last.clientY);
        this.cameraMoved();
      } else if (!down && isMouse) this.#pointAt(...placeOf(event));
      if (down) last = event;
    });
    on('pointerup', event => {
      const isTap = down && far(event) < TAP_PIXELS;
      down = null;
      if (isTap) this.#tap(...placeOf(event));
    });
    on('pointercancel', () => (down = null));
    on('pointerleave', () => this.#pointAt(FAR, FAR));
    on('dblclick', () => this.follow('field'));
    on('wheel', event => {
      if (inFrame() && !event.ctrlKey && !this.#view.isHeld) return;      // a notebook goes on scrolling
      event.preventDefault();
      this.#view.zoom(...placeOf(event), event.deltaY);
      this.cameraMoved();
    }, { passive: false });
  }

  #tap(x, y) {
    const { stage, playback } = this.page;
    const body = stage.bodyAt(playback.moment, x, y);
    if (body) this.choose(body.id);
    else playback.toggle();
  }

  /** Selects a body, or none if it is the selected one. */
  choose(id) {
    this.select(id === this.page.stage.selected ? null : id);
  }

  select(id) {
    this.page.stage.selected = id;
    if (id === null && this.#view.follow === 'selected') this.follow('field');
    this.page.refresh();
  }

  /** Says of the body at a place who it is, how fast and how heavy, and its command. */
  #pointAt(x, y) {
    const { match, look, playback, stage } = this.page;
    const moment = playback.moment;
    const body = stage.bodyAt(moment, x, y);
    const box = part('body-tip');
    box.hidden = !body;
    if (stage.hovered !== (body?.id ?? null)) {
      stage.hovered = body?.id ?? null;
      this.page.changed();
    }
    if (!body) return;
    const { vx, vy, now: { mass } } = body;
    const lines = [`${body.owner === null ? '' : `${nameOf(match, body.owner)} · `}${body.kind} ${body.id}`];
    if (vx !== undefined) lines.push(`${grouped(Math.hypot(vx, vy))} u a turn`);
    if (mass !== undefined) lines.push(`mass ${grouped(mass)}`);
    const command = look.commandOf(body, match, moment.turn);
    if (command) lines.push(command);
    box.textContent = lines.join('\n');
    box.style.left = `${Math.max(4, Math.min(x + 16, this.#view.width - box.offsetWidth - 4))}px`;
    box.style.top = `${Math.max(4, Math.min(y + 16, this.#view.height - box.offsetHeight - 4))}px`;
  }

  nextFollow() {
    const modes = FOLLOW_MODES.filter(mode => mode !== 'selected' || this.page.stage.selected !== null);
    const { isHeld, follow } = this.#view;
    this.follow(isHeld ? 'field' : modes[(modes.indexOf(follow) + 1) % modes.length]);
  }

  follow(mode) {
    this.#view.setFollow(mode);
    this.page.tell(FOLLOW_WORDS[mode]);
    this.cameraMoved();
  }

  cameraMoved() {
    const { isMoved, isHeld, follow } = this.#view;
    part('follow').setAttribute('aria-pressed', String(isMoved));
    part('follow-mode').textContent = isHeld ? 'free' : follow;
    this.page.changed();
  }
}

/** True if the page is shown inside another. */
export function inFrame() {
  return window.parent !== window;
}
