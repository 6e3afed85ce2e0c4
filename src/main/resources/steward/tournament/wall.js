// The wall: the table by server-sent events, and the newest game, put together from its replay and the page of a match.
(() => {
  'use strict';
  const CHECK_MS = 250;
  const REST_MS = 2500;         // how long the end of a game stays
  const LONGEST_MS = 90000;     // a game that has not come to its end by then is left
  const find = id => document.getElementById(id);
  const shell = JSON.parse(find('data').textContent);
  const frame = find('game');
  const state = { newest: 0, title: '', shown: 0, over: false, busy: false, playing: false, ready: false };
  window.steward = state;

  async function next() {
    if (state.busy || state.over || state.newest === state.shown) return;
    state.busy = true;
    state.shown = state.newest;
    const title = state.title;
    const answer = await fetch(`replay/${state.shown}`).catch(() => null);
    if (!answer?.ok) return rest();
    const [replay, details] = (await answer.text()).split('\n');
    const page = shell.before.replaceAll('{{title}}', '') + replay + shell.after.replace('{{details}}', details);
    frame.onload = () => play(title, performance.now());
    frame.srcdoc = page;
  }

  /** Plays the match in the frame without its panels. */
  function play(title, began) {
    const match = frame.contentWindow.steward;
    const late = performance.now() - began > LONGEST_MS;
    if (late) return rest();
    if (!match?.ready) return setTimeout(() => play(title, began), CHECK_MS);
    const document = frame.contentDocument;
    for (const part of ['aside', '.transport']) document.querySelector(part).style.display = 'none';
    document.querySelector('main').style.gridTemplateColumns = 'minmax(0, 1fr)';
    frame.contentWindow.dispatchEvent(new Event('resize'));
    find('title').textContent = title;
    match.play();
    state.playing = true;
    const timer = setInterval(() => {
      if (match.time() < match.lastTurn() && performance.now() - began < LONGEST_MS) return;
      clearInterval(timer);
      setTimeout(rest, REST_MS);
    }, CHECK_MS);
  }

  function rest() {
    state.busy = state.playing = false;
    next();
  }

  function draw({ rows }) {
    find('rows').replaceChildren(...rows.map(row => {
      const line = document.createElement('tr');
      for (const cell of [row.place, row.name, Math.round(row.points * 100) / 100, row.games, row.won, row.drawn, row.lost]) {
        line.append(document.createElement('td'));
        line.lastChild.textContent = cell;
      }
      return line;
    }));
  }

  const source = new EventSource('feed');
  source.onmessage = event => {
    const now = JSON.parse(event.data);
    Object.assign(state, { newest: now.game, title: now.title, over: now.over });
    find('says').textContent = now.says;
    draw(now);
    state.ready = true;
    next();
  };
  source.addEventListener('end', () => source.close());
  source.addEventListener('refused', event => {
    source.close();
    find('says').textContent = event.data;
  });
  source.onerror = () => {
    if (!state.over) find('says').textContent = 'The tournament is not being played at the moment, or this page cannot reach it.';
  };
  addEventListener('keydown', event => {
    if (event.key.toLowerCase() !== 'f' || event.ctrlKey || event.metaKey || event.altKey) return;
    if (document.fullscreenElement) document.exitFullscreen();
    else document.documentElement.requestFullscreen();
  });
})();
