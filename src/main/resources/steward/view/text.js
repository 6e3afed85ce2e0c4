// Words and numbers for people. Texts of players only ever become text nodes, and only so much of them.

export const MOST_NAME = 60;

const GROUPED = new Intl.NumberFormat('en-US', { maximumFractionDigits: 2 });

/** An element with a class, text and children. */
export function element(tag, className, text, ...children) {
  const made = document.createElement(tag);
  if (className) made.className = className;
  if (text !== undefined && text !== null) made.textContent = text;
  made.append(...children);
  return made;
}

/** Puts text into an element, or hides it when there is none. */
export function show(target, text) {
  const words = text || '';
  if (target.textContent !== words) target.textContent = words;
  target.hidden = !words;
}

/** At most so many characters (emoji are not cut in half), with the number of those left out. */
export function shorten(text, most) {
  if (text.length <= most) return text;
  const kept = Array.from(text.slice(0, 2 * most)).slice(0, most).join('');
  return kept.length === text.length ? text : `${kept}… (${text.length - kept.length} more)`;
}

/** A number as the replay has it, with at most three decimals. */
export function plainNumber(value) {
  return Number.isInteger(value) ? String(value) : value.toFixed(3);
}

/** A number to be read: groups of three digits, two decimals where it is small. */
export function grouped(value) {
  if (!Number.isFinite(value)) return '–';
  const rounded = Math.abs(value) >= 100 ? Math.round(value) : Math.round(100 * value) / 100;
  return GROUPED.format(rounded + 0).replaceAll(',', '\u2009');       // without a sign where it is 0
}

/** The size of an impulse: whole, or two digits of a small one. */
export function impulseWords({ impulse }) {
  const size = Math.abs(impulse ?? 0);
  return size >= 10 ? grouped(Math.round(size)) : String(Number(size.toPrecision(2)));
}

export function nameOf(match, player) {
  return shorten(match.players[player]?.name ?? `player ${player}`, MOST_NAME);
}

/** Words of a game, with the names of bots where it counts players. */
export function withNames(match, words) {
  return words.replace(/\bplayer (\d+)\b/g, (all, player) => (match.players[player] ? nameOf(match, player) : all));
}

/** Words of an event of the match; a body that ceased to be is named, with its owner. */
export function eventWords(match, { event, turn }) {
  const words = withNames(match, event.text);
  if (event.kind !== 'death' || event.body === undefined) return words;
  const { kind, owner } = match.describeIn(event.body, turn);
  return `${owner === null ? '' : `${nameOf(match, owner)}, `}${kind} ${event.body}: ${words}`;
}
