// Moments of a match and lists in the order of time.
//
// Time is counted in turns: turn n fills the time from n - 1 to n, and time 0 is the start. "At turn n" is line n
// of the replay: its commands, messages and the state it ended with.

/** A moment of the match: its time, the turn it belongs to, how far into it, and the last turn that is complete. */
export function momentAt(time) {
  const turn = Math.ceil(time);
  return { time, turn, fraction: turn === 0 ? 1 : time - (turn - 1), settled: Math.floor(time) };
}

/** The elements of a list sorted by time with from < time <= to. */
export function within(list, from, to) {
  return list.slice(firstAfter(list, from), firstAfter(list, to));
}

/** Index of the first element after a time. */
export function firstAfter(list, time) {
  let low = 0;
  let high = list.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (list[middle].time > time) high = middle;
    else low = middle + 1;
  }
  return low;
}
