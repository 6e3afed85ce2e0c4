// Marks of axes.

const TICK_PIXELS = 60;         // between two of them, at least

/** 1, 2 or 5 times a power of ten, at least as large as asked for. */
export function niceStep(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].find(factor => factor * power >= least) * power;
}

/** Marks of uPlot at whole numbers: round ones, and the last. */
export function wholeTicks(plot, _, low, high) {
  const step = niceStep(Math.max(1, (high - low) * TICK_PIXELS / Math.max(1, plot.bbox.width / devicePixelRatio)));
  const ticks = [];
  for (let tick = Math.ceil(low / step) * step; tick < high - 0.7 * step; tick += step) ticks.push(tick);
  return [...ticks, high];
}
