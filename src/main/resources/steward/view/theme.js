// Colours: those of the page come from its style sheet, so that light and dark have one home.

// Okabe and Ito's colours, told apart with every kind of colour vision; the darker set is for light ground.
const TEAM_ON_DARK = ['#56b4e9', '#f0a030', '#2fc79b', '#e08fbf', '#f0e442', '#ef7a45'];
const TEAM_ON_LIGHT = ['#0072b2', '#d55e00', '#00795a', '#a8417c', '#7a6a00', '#3d4a57'];
const PAINTS = ['field', 'ground', 'line', 'faint', 'zone', 'rim', 'ink', 'muted', 'flash', 'flame', 'core',
  'shield', 'wall', 'bad', 'halo'];

class Theme {
  #probe = document.createElement('i');
  paint = {};
  isDark = true;

  constructor(onChange) {
    this.onChange = onChange;
    this.#probe.hidden = true;
    document.body.append(this.#probe);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.read());
    this.read();
  }

  /** Whether decoration should keep still. */
  get isCalm() {
    return matchMedia('(prefers-reduced-motion: reduce)').matches;
  }

  toggle() {
    document.documentElement.dataset.theme = this.isDark ? 'light' : 'dark';
    this.read();
  }

  /** Asks the style sheet what its colours are now. */
  read() {
    const chosen = document.documentElement.dataset.theme;
    this.isDark = chosen ? chosen === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
    for (const name of PAINTS) {
      this.#probe.style.color = `var(--${name})`;
      this.paint[name] = getComputedStyle(this.#probe).color;
    }
    const colours = this.isDark ? TEAM_ON_DARK : TEAM_ON_LIGHT;
    colours.forEach((colour, k) => document.documentElement.style.setProperty(`--team-${k}`, colour));
    this.onChange?.();
  }

  /** The colour of a player's things; of nobody's things if null. */
  team(player) {
    const colours = this.isDark ? TEAM_ON_DARK : TEAM_ON_LIGHT;
    return player === null || player === undefined ? this.paint.muted : colours[player % colours.length];
  }
}

/** The CSS class that gives an element the colour of a player. */
function teamClass(player) {
  return player === null || player === undefined ? 'team nobody' : `team team-${player % TEAM_ON_DARK.length}`;
}
