// The numbers of a long replay, unpacked: states, impacts and paths of its turns. PackedTable.java says how they are packed.

const PLANES = 4;               // bytes of a code

/** Puts the numbers of tables where they belong in the turns; the last record describes the tables. */
export function unpackTables(records, bytes) {
  const { every, tables } = records.pop();
  const turns = records.filter(record => record.type === 'turn');
  const isKept = number => number % every === 0 || number === turns.length;
  let from = 0;
  for (const table of tables) {
    const kept = table.counts.map((count, number) => (isKept(number) ? Math.max(0, count) : 0));
    const rows = kept.reduce((sum, count) => sum + count, 0);
    const columns = table.steps.map((step, k) => valuesOf(bytes.subarray(from + PLANES * rows * k, from + PLANES * rows * (k + 1)), kept, table.steady, step));
    from += PLANES * rows * table.columns.length;
    let row = 0;
    turns.forEach(({ outcome }, index) => {
      const count = kept[index + 1];
      if (table.counts[index + 1] < 0) return;
      const list = Array.from({ length: count }, (_, k) => rowOf(table.columns, columns, row + k));
      row += count;
      if (table.name === 'bodies') outcome.state.bodies = list;
      else outcome[table.name] = table.name === 'paths' ? pathsOf(list) : list;
      if (table.name === 'impacts') outcome.impactsInAll ??= table.counts[index + 1];
    });
  }
  records[0].packed = { every };
  if (every > 1) turns.forEach(({ turn, outcome }) => isKept(turn) || delete outcome.state);
  return records;
}

/** The values of a column; NaN where there is none. */
function valuesOf(planes, kept, isSteady, step) {
  const rows = planes.length / PLANES;
  const steps = new Int32Array(rows);
  const values = new Float64Array(rows);
  let row = 0;
  let [last, lastButOne] = [new Int32Array(0), new Int32Array(0)];
  for (const count of kept) {
    if (!count) continue;
    const own = steps.subarray(row, row + count);
    for (let k = 0; k < count; k++, row++) {
      const code = planes[row] | planes[rows + row] << 8 | planes[2 * rows + row] << 16 | planes[3 * rows + row] << 24;
      const before = !isSteady || k >= last.length ? (k === 0 ? 0 : own[k - 1])
        : k < lastButOne.length ? 2 * last[k] - lastButOne[k] : last[k];
      own[k] = code === 0 ? before : before + ((code - 1) >>> 1 ^ -((code - 1) & 1));
      values[row] = code === 0 ? NaN : own[k] * step;
    }
    [last, lastButOne] = [own, last];
  }
  return values;
}

function rowOf(names, columns, row) {
  const object = {};
  for (let k = 0; k < names.length; k++) if (!Number.isNaN(columns[k][row])) object[names[k]] = columns[k][row];
  return object;
}

/** Rows of knots as paths, one for each body. */
function pathsOf(rows) {
  const paths = [];
  for (const { id, t, x, y } of rows) {
    if (paths.at(-1)?.id !== id) paths.push({ id, knots: [] });
    paths.at(-1).knots.push([t, x, y]);
  }
  return paths;
}
