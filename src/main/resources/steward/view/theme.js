// Colours: those of the page come from its style sheet. Those of teams are for what belongs to a team alone.

// Sixteen colours: the first six are told apart with every kind of colour vision, all by their lightness and hull.
const TEAM_ON_DARK = ['#4cc2ff', '#ffa53a', '#2fd6a3', '#f08cc8', '#f2e55c', '#9c8cff', '#b7ea84', '#d3875a',
  '#5b86ff', '#d650b4', '#57ab58', '#dccaa0', '#a8f0f4', '#a6a03c', '#ffc4cc', '#90a3bd'];
const TEAM_ON_LIGHT = ['#0072b2', '#c24e00', '#007a5a', '#b03a80', '#7d6a00', '#5a45c8', '#4a7c10', '#87481d',
  '#1d4fd7', '#8e0f77', '#1f5f2a', '#6b5a33', '#0a7185', '#5c5a12', '#a1455a', '#4d6079'];
const PAINTS = ['field', 'ground', 'sky', 'abyss', 'line', 'faint', 'zone', 'lane', 'rim', 'ink', 'muted', 'flash',
  'flame', 'core', 'shield', 'water', 'wall', 'bad', 'halo', 'panel', 'hull'];
const STORED = 'steward-theme';

export class Theme {
  #probe = document.createElement('i');
  #motion = matchMedia('(prefers-reduced-motion: reduce)');
  paint = {};
  isDark = true;
  /** Counts changes of colours: what is drawn from them once is drawn anew. */
  version = 0;

  constructor(onChange) {
    this.onChange = onChange;
    this.#probe.hidden = true;
    document.body.append(this.#probe);
    const kept = remembered(STORED);
    if (kept === 'light' || kept === 'dark') document.documentElement.dataset.theme = kept;
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.read());
    addEventListener('beforeprint', () => this.#print('light'));
    addEventListener('afterprint', () => this.#print(this.#chosen));
    this.read();
  }

  /** Paper is light, whatever the screen is. */
  #print(theme) {
    const root = document.documentElement;
    if (theme === 'light') this.#chosen = root.dataset.theme;
    if (theme) root.dataset.theme = theme;
    else delete root.dataset.theme;
    this.read();
  }
  #chosen;

  /** True if decoration should keep still. */
  get isCalm() {
    return this.#motion.matches;
  }

  toggle() {
    const next = this.isDark ? 'light' : 'dark';
    document.documentElement.dataset.theme = next;
    remember(STORED, next);
    this.read();
  }

  /** Asks the style sheet for its present colours. */
  read() {
    const chosen = document.documentElement.dataset.theme;
    this.isDark = chosen ? chosen === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
    for (const name of PAINTS) {
      this.#probe.style.color = `var(--${name})`;
      this.paint[name] = getComputedStyle(this.#probe).color;
    }
    this.version++;
    teamColours(this.isDark).forEach((colour, k) =>
      document.documentElement.style.setProperty(`--team-${k}`, colour));
    this.onChange?.();
  }

  /** The colour of a player's things; of nobody's things if null. */
  team(player) {
    if (player === null || player === undefined) return this.paint.muted;
    const colours = teamColours(this.isDark);
    return colours[player % colours.length];
  }
}

/** Colours of teams on dark or light ground. */
function teamColours(isDark) {
  return isDark ? TEAM_ON_DARK : TEAM_ON_LIGHT;
}

/** One colour of many: behind the sixteen, hues by the golden angle, three times lighter and darker in turn. */
export function colourOfMany(k, isDark) {
  const colours = teamColours(isDark);
  return colours[k] ?? `oklch(${(isDark ? 0.84 : 0.58) - 0.09 * (k % 3)} 0.13 ${Math.round(k * 137.508 % 360)})`;
}

/** Gives an element the colour of a player. */
export function inTeamColour(element, player) {
  element.classList.add('team');
  if (player !== null && player !== undefined) {
    element.style.setProperty('--team', `var(--team-${player % TEAM_ON_DARK.length})`);
  }
  return element;
}

/** A computed colour, "rgb(...)" or "#rrggbb", made see-through; never wholly, for a gradient would end in grey. */
export function withAlpha(colour, alpha) {
  const key = `${colour}|${alpha}`;
  let mixed = MIXED.get(key);
  if (!mixed) {
    mixed = `color-mix(in srgb, ${colour} ${Math.max(0.4, Math.round(100 * alpha))}%, transparent)`;
    if (MIXED.size > 2000) MIXED.clear();
    MIXED.set(key, mixed);
  }
  return mixed;
}
const MIXED = new Map();

/** A choice of an earlier visit; null where the browser keeps none, as inside another page. */
export function remembered(name) {
  try {
    return localStorage.getItem(name);
  } catch {
    return null;
  }
}

export function remember(name, value) {
  try {
    localStorage.setItem(name, value);
  } catch {
    // a page inside another may be forbidden to keep anything
  }
}
