// The page of many games in which this one stands, if it does.

/** Its address with the game in it, and the moment that it wants to see; null for a page of its own. */
export function outerPage() {
  if (window.parent === window || !window.name.startsWith('{')) return null;
  try {
    const { steward, link } = JSON.parse(window.name);
    return typeof steward === 'string' && typeof link === 'string' ? { address: steward, link } : null;
  } catch {
    return null;
  }
}
