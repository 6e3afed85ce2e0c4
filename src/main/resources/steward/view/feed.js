// Where turns come from: the replay that is embedded in the page, or a live match.

import { unpackTables } from './packed.js';
import { unpacked, unpackedBytes } from './unpack.js';

const LOST_MS = 20_000;         // without a connection for so long, a live match is given up

/** The records of the replay that is embedded in the page; a long one has the numbers of its turns in tables. */
export async function embeddedRecords(source) {
  const bytes = await unpackedBytes(source);
  const end = bytes.indexOf(0);
  const records = new TextDecoder().decode(end < 0 ? bytes : bytes.subarray(0, end)).split('\n').filter(line => line)
    .map(line => JSON.parse(line));
  return end < 0 ? records : unpackTables(records, bytes.subarray(end + 1));
}

/** The lines of text that is embedded in the page. */
export async function embeddedLines(source) {
  return (await unpacked(source)).split('\n').filter(line => line);
}

/** Whoever serves the match goes when it is over: what Save gives is fetched before, and kept by the page. */
async function keepCopy() {
  const save = document.querySelector('a[download]');
  const answer = save && await fetch(save.href);
  if (!answer || !answer.ok) return;
  save.download = save.getAttribute('href');
  save.href = URL.createObjectURL(await answer.blob());
}

/** Follows a match as server-sent events: each message is one line of the replay; "end" closes. */
export function followFeed(page, feed) {
  page.playback.live = true;
  document.body.classList.add('live');
  const events = new EventSource(feed);
  let lostSince = null;
  const close = () => {
    events.close();
    page.playback.live = false;
    document.body.classList.remove('live');
  };
  const stop = () => {
    close();
    keepCopy().catch(() => page.say('The connection is lost: this match can be watched, but no longer saved.'));
  };
  const giveUp = words => {                      // what Save gives would be nothing, or another match
    close();
    document.querySelector('a[download]')?.remove();
    page.say(words);
  };
  events.addEventListener('message', event => {
    lostSince = null;
    page.say('');
    page.addLine(event.data);
    if (page.match.isAnotherPlayed) giveUp('Another match is played here now; reload to see it.');
    else if (page.match.result) stop();
  });
  events.addEventListener('end', stop);
  events.addEventListener('refused', event => {
    close();
    page.say(event.data, () => {
      page.say('');
      followFeed(page, feed);
    });
  });
  events.addEventListener('error', () => {
    lostSince ??= performance.now();
    const isOver = events.readyState === EventSource.CLOSED || performance.now() - lostSince > LOST_MS;
    if (isOver) giveUp('The match has ended early.');
    else page.say('The connection is lost; trying again.');
  });
  page.playback.followLive();
}
