// The match as CSV, as far as a replay has it: normals, velocities at impacts and radii are in `steward run --csv`.

const OF_STATES = ['x', 'y', 'vx', 'vy'];
const OF_IMPACTS = ['time', 'a', 'b', 'wall', 'ax', 'ay', 'bx', 'by', 'impulse', 'energy'];

/** States of all bodies, or of one, at the start and at the end of each turn that has one. */
export function statesCsv(match, id = null) {
  const rows = [];
  const more = new Set();
  for (let number = 0; number <= match.lastTurn; number++) {
    const turn = match.turn(number);
    if (turn.isKept === false) continue;
    for (const body of turn.bodies.values()) {
      if (id !== null && body.id !== id) continue;
      rows.push([number, body]);
      for (const field in body) more.add(field);
    }
  }
  const fields = [...new Set([...OF_STATES, ...more])].filter(field => field !== 'id');
  return csv(['turn', 'id', ...fields], rows.map(([number, body]) => [number, body.id, ...fields.map(field => body[field])]));
}

/** All impacts that the replay holds; the time is that within the turn. */
export function impactsCsv(match) {
  return csv(['turn', ...OF_IMPACTS], match.impacts.map(({ turn, impact }) => [turn, ...OF_IMPACTS.map(field => impact[field])]));
}

function csv(head, rows) {
  return `${[head, ...rows].map(row => row.map(cell).join(',')).join('\n')}\n`;
}

function cell(value) {
  if (value === null || value === undefined) return '';
  const plain = typeof value === 'object' ? JSON.stringify(value) : String(value);
  const text = typeof value === 'string' && /^'*[=+@\-\t\r]/.test(plain) ? `'${plain}` : plain;       // no formula of a spreadsheet
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
