// Keys, buttons, menus and the pointer.

import { SPEEDS } from './playback.js';

const TAP_PIXELS = 8;
const ZOOM_STEP = 260;          // of a key, in pixels of a wheel

const control = id => document.getElementById(id);

/** What each key does; the buttons do the same. */
function actionsOf(page) {
  const { playback } = page;
  return {
    ' ': () => playback.toggle(),
    ArrowLeft: () => playback.stepTurn(-1),
    ArrowRight: () => playback.stepTurn(1),
    ArrowUp: () => playback.changeSpeed(1),
    ArrowDown: () => playback.changeSpeed(-1),
    '[': () => playback.stepImpact(-1),
    ']': () => playback.stepImpact(1),
    Home: () => playback.seek(0),
    End: () => playback.toEnd(),
    l: () => playback.live && playback.followLive(),
    f: () => page.nextFollow(),
    v: () => toggleShown(page, 'vectors'),
    s: () => page.share.link(),
    p: () => page.share.picture(),
    r: () => page.share.clip(),
    '+': () => zoomMiddle(page, -ZOOM_STEP),
    '-': () => zoomMiddle(page, ZOOM_STEP),
    0: () => page.follow('field'),
    Escape: () => page.select(null),
    '?': () => control('help').showModal(),
  };
}

function toggleShown(page, name) {
  const box = document.querySelector(`[data-show="${name}"]`);
  box.checked = !box.checked;
  box.dispatchEvent(new Event('change'));
}

function zoomMiddle(page, pixels) {
  const { view } = page.stage;
  view.zoom(view.width / 2, view.height / 2, pixels);
  page.cameraMoved();
}

export function connectControls(page) {
  const actions = actionsOf(page);
  document.querySelectorAll('[data-key]').forEach(button => {
    button.addEventListener('click', () => page.stage && actions[button.dataset.key]());
  });
  document.addEventListener('keydown', event => onKey(event, actions, page));
  control('speed').append(...SPEEDS.map(speed => new Option(`${speed}×`, String(speed))));
  control('speed').addEventListener('change', event => {
    page.playback.setSpeed(Number(event.target.value));
    event.target.blur();
  });
  control('theme').addEventListener('click', () => page.theme.toggle());
  document.querySelectorAll('[data-show]').forEach(box => {
    box.addEventListener('change', () => {
      page.stage.show[box.dataset.show] = box.checked;
      page.draw();
    });
  });
  connectMenus();
  connectField(control('field'), page);
  addEventListener('hashchange', () => page.followLink());
}

function onKey(event, actions, page) {
  if (control('help').open || !page.stage) return;
  const { target, key } = event;
  const menu = target.closest?.('details[open]');
  if (key === 'Escape' && menu) {
    menu.open = false;
    menu.querySelector('summary').focus();
    return;
  }
  const name = key.length === 1 ? key.toLowerCase() : key;
  const isArrow = key.startsWith('Arrow');
  const isElsewhere = target.matches?.('input:not([type=range]), textarea')
    || !isArrow && target.matches?.('select, summary')
    || key === ' ' && target.matches?.('button:focus-visible')
    || isArrow && /^Arrow(Up|Down)$/.test(key) && target.closest?.('[tabindex="0"]');
  if (event.ctrlKey || event.altKey || event.metaKey || isElsewhere || !actions[name]) return;
  event.preventDefault();
  actions[name]();
}

/** Menus close by Escape and by a click outside of them. */
function connectMenus() {
  document.addEventListener('pointerdown', event => {
    document.querySelectorAll('details.menu[open]').forEach(menu => {
      if (!event.composedPath().includes(menu)) menu.removeAttribute('open');
    });
  });
  document.addEventListener('keydown', event => {
    if (event.key === 'Escape') document.querySelectorAll('details.menu[open]').forEach(menu => menu.removeAttribute('open'));
  });
}

/** A tap selects a body, or plays and pauses; the wheel zooms, dragging moves, a double click goes back. */
function connectField(field, page) {
  let down = null;
  let last = null;
  const placeOf = event => {
    const { left, top } = field.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  };
  field.addEventListener('pointerdown', event => {
    down = last = event;
    if (event.pointerType === 'mouse') field.setPointerCapture(event.pointerId);
  });
  field.addEventListener('pointermove', event => {
    if (!page.stage) return;
    const isDrag = down && Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) >= TAP_PIXELS;
    if (isDrag && (event.pointerType === 'mouse' || page.stage.view.isMoved)) {
      page.stage.view.pan(event.clientX - last.clientX, event.clientY - last.clientY);
      page.cameraMoved();
    } else if (!down && event.pointerType === 'mouse') page.hover(...placeOf(event));
    if (down) last = event;
  });
  field.addEventListener('pointerup', event => {
    const isTap = down && Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) < TAP_PIXELS;
    down = null;
    if (isTap && page.stage) page.tap(...placeOf(event));
  });
  field.addEventListener('pointercancel', () => (down = null));
  field.addEventListener('pointerleave', () => page.stage && page.hover(-1e6, -1e6));
  field.addEventListener('dblclick', () => page.stage && page.follow('field'));
  field.addEventListener('wheel', event => {
    if (!page.stage || inFrame() && !event.ctrlKey && !page.stage.view.isHeld) return;   // a notebook goes on scrolling
    event.preventDefault();
    page.stage.view.zoom(...placeOf(event), event.deltaY);
    page.cameraMoved();
  }, { passive: false });
}

/** True if the page is shown inside another. */
export function inFrame() {
  return window.parent !== window;
}

