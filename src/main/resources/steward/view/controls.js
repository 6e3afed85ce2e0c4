// Keys, buttons, menus and the pointer.

import { SPEEDS } from './playback.js';

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
    '[': () => page.step('impact', -1),
    ']': () => page.step('impact', 1),
    i: isBack => page.step('impact', isBack ? -1 : 1),
    e: isBack => page.step('event', isBack ? -1 : 1),
    x: isBack => page.step('fault', isBack ? -1 : 1),
    Home: () => playback.seek(0),
    End: () => playback.toEnd(),
    l: () => playback.live && playback.followLive(),
    f: () => page.pointer.nextFollow(),
    v: () => toggleShown(page, 'vectors'),
    s: () => page.share.link(),
    p: () => page.share.picture(),
    r: () => page.share.clip(),
    '+': () => zoomMiddle(page, -ZOOM_STEP),
    '-': () => zoomMiddle(page, ZOOM_STEP),
    0: () => page.pointer.follow('field'),
    Escape: () => page.pointer.select(null),
    d: () => page.side.fold(),
    '/': () => control('search').focus(),
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
  page.pointer.cameraMoved();
}

export function connectControls(page) {
  const actions = actionsOf(page);
  document.querySelectorAll('[data-key]').forEach(button => {
    button.addEventListener('click', () => page.stage && actions[button.dataset.key](button.hasAttribute('data-back')));
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
  page.pointer.connect(control('field'));
  addEventListener('hashchange', ({ newURL }) => page.followLink(new URL(newURL).hash));  // playing may have set another
}

function onKey(event, actions, page) {
  if (document.querySelector('dialog[open]') || !page.stage) return;
  const { target, key } = event;
  const menu = target.closest?.('details[open]');
  if (key === 'Escape' && menu) {
    menu.open = false;
    menu.querySelector('summary').focus();
    return;
  }
  const name = key.length === 1 ? key.toLowerCase() : key;
  const isElsewhere = target.matches?.('input:not([type=range], [type=checkbox]), textarea')
    || key === ' ' && target.matches?.('select, summary, [type=checkbox], button:focus-visible')    // it presses them
    || /^Arrow(Up|Down)$/.test(key) && target.closest?.('[tabindex="0"]');
  if (event.ctrlKey || event.altKey || event.metaKey || isElsewhere || !actions[name]) return;
  event.preventDefault();
  actions[name](event.shiftKey);
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
