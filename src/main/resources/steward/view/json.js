// JSON for people: broken at its fields. Numbers stay as they are written.

const LINE = 84;                // characters that stay on one line
const TOKEN = /"(?:[^"\\]|\\.)*"|[[\]{}:,]|[^\s[\]{}:,"]+/g;

/** Lines of text, each that is JSON and longer than a line broken at its fields. */
export function broken(text) {
  return text.split('\n').map(line => (line.length > LINE && isJson(line) ? brokenLine(line) : line)).join('\n');
}

function isJson(line) {
  if (!/^\s*[[{]/.test(line)) return false;
  try {
    JSON.parse(line);
    return true;
  } catch {
    return false;
  }
}

function brokenLine(line) {
  const tokens = line.match(TOKEN);
  let at = 0;
  const value = indent => {
    const open = tokens[at++];
    if (open !== '{' && open !== '[') return open;
    const parts = [];
    while (tokens[at] !== '}' && tokens[at] !== ']') {
      let part = value(`${indent}  `);
      if (tokens[at] === ':') {
        at++;
        part += `: ${value(`${indent}  `)}`;
      }
      parts.push(part);
      if (tokens[at] === ',') at++;
    }
    const close = tokens[at++];
    const flat = open + parts.join(', ') + close;
    if (indent.length + flat.length <= LINE && !flat.includes('\n')) return flat;
    return `${open}\n${parts.map(part => `${indent}  ${part}`).join(',\n')}\n${indent}${close}`;
  };
  return value('');
}
