// Ways of bodies within a turn: corners [t, x, y] in the order of time, straight flight between them.

/** The corners of bodies' ways where only impacts are told, as in imports of earlier versions. */
export function cornersOf(impacts) {
  const corners = new Map();
  const add = (id, corner) => corners.set(id, [...corners.get(id) ?? [], corner]);
  for (const { time, a, b, ax, ay, bx, by } of impacts ?? []) {
    add(a, [time, ax, ay]);
    if (b !== undefined) add(b, [time, bx, by]);
  }
  return corners;
}

/**
 * The point of a path at a time 0..1, and the velocity that leads on from it, in units a turn; at the end of the path
 * there is none. Of several corners at that time the last counts. Null before and after the path.
 */
export function placeOn(path, t) {
  if (!path.length || t < path[0][0]) return null;
  let k = path.length - 1;
  while (k > 0 && path[k][0] > t) k--;
  const from = path[k];
  const to = path[k + 1];
  if (!to) return t <= from[0] ? { x: from[1], y: from[2] } : null;
  const [past, turns] = [t - from[0], to[0] - from[0]];
  const [vx, vy] = [(to[1] - from[1]) / turns, (to[2] - from[2]) / turns];
  return { x: from[1] + vx * past, y: from[2] + vy * past, vx, vy };
}
