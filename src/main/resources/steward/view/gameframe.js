// A game within a page of many: over all of it, with an address, #game=276&t=20, so that Back closes it.

const ADDRESS = /^#game=(\d+)(?:&(.+))?$/;
const COVER = { position: 'fixed', inset: '0', zIndex: '20', display: 'grid', gridTemplateRows: 'auto 1fr', background: 'Canvas' };
const BAR = { display: 'flex', gap: '12px', alignItems: 'center', padding: '4px 12px', font: '14px system-ui, sans-serif', color: 'CanvasText' };
const BACK = { font: 'inherit', padding: '4px 12px', cursor: 'pointer' };

const escaped = text => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');

/** The page of a match, put together from the page without one and what a page of many holds of it. */
export function pageOf(shell, [replay, details], title) {
  return shell.before.replaceAll('{{title}}', escaped(title)) + replay + shell.after.replace('{{details}}', details);
}

function styled(tag, style, text = '') {
  const made = document.createElement(tag);
  Object.assign(made.style, style);
  made.textContent = text;
  return made;
}

export class GameFrame {
  /** @param {{ data: () => any, title: (game: string) => string, missing: (game: string) => void }} source of games */
  constructor(source) {
    this.source = source;
    addEventListener('hashchange', () => this.follow());
    addEventListener('message', ({ source: from, data }) => {
      if (!this.frame || from !== this.frame.contentWindow || typeof data?.moment !== 'string') return;
      history.replaceState(null, '', `#game=${this.game}&${data.moment.slice(1)}`);
    });
  }
  source; frame = null; cover = null; game = null; heading = '';

  /** Opens the game that the address names, at the moment that it names, or closes the one that is open. */
  follow() {
    const [, game, moment] = ADDRESS.exec(location.hash) ?? [];
    if (game === undefined) return this.close();
    const link = moment ? `#${moment}` : '';
    if (game === this.game) return this.frame.contentWindow.postMessage({ go: link }, '*');
    const { replays, linked, shell } = this.source.data();
    if (linked?.[game]) return location.replace(linked[game] + link);
    this.close();
    if (replays?.[game]) this.#open(game, link, pageOf(shell, replays[game], this.source.title(game)));
    else this.source.missing(game);
  }

  #open(game, link, page) {
    const title = this.source.title(game);
    const back = styled('button', BACK, '\u2039 All games');
    back.addEventListener('click', () => this.#leave());
    this.frame = styled('iframe', { width: '100%', height: '100%', border: '0' });
    this.frame.title = title;
    this.frame.name = JSON.stringify({ steward: `${location.href.split('#')[0]}#game=${game}`, link });
    this.frame.srcdoc = page;
    this.frame.addEventListener('load', () => this.frame?.contentWindow.focus());
    this.cover = styled('section', COVER);
    const bar = styled('header', BAR);
    bar.append(back, styled('b', {}, `Game ${game}`));
    this.cover.append(bar, this.frame);
    document.body.append(this.cover);
    document.documentElement.style.overflow = 'hidden';
    this.heading = document.title;
    document.title = title;
    this.game = game;
  }

  /** As Back does it; a page that was opened with a game in its address has nothing to go back to. */
  #leave() {
    history.replaceState(null, '', location.href.split('#')[0]);
    this.close();
  }

  close() {
    if (!this.cover) return;
    this.cover.remove();
    document.documentElement.style.overflow = '';
    document.title = this.heading;
    this.frame = this.cover = this.game = null;
  }
}
