// The look of the Poker Chip Race: chips with a notched rim in the colour of their owner, grey where they are neutral.

const RIM = 0.82;               // of the radius: where the rim begins
const NOTCHES = 8;
const SMALL_CHIP = 5;           // up to this radius a chip cannot push itself
const CHIP_NAME_PIXELS = 8;     // chips drawn smaller than this have no letters

const POKER_CHIP_RACE_LOOK = {
  drawGround() {},

  drawBelow(scene) {
    if (scene.show.targets) scene.match.players.forEach((_, player) => drawPushes(scene, player));
  },

  drawBody: drawChip,

  /** Per player: rank by the area of its chips, their number, and the biggest of them. */
  standing(match, number) {
    const chips = match.players.map((_, player) => chipsOf(match, number, player));
    const areas = chips.map(own => own.reduce((sum, chip) => sum + Math.PI * chip.radius ** 2, 0));
    return areas.map((area, player) => ({
      rank: areas.filter(other => other > area).length,
      body: biggest(chips[player])?.id ?? null,
      big: `${Math.round(area)} u²`,
      small: chips[player].length === 1 ? '1 chip' : `${chips[player].length} chips`,
      warning: '',
    }));
  },

  commandLines: command => command.map((order, k) => `chip ${k + 1}: ${pushWords(order)}`),

  field: (name, value) => PLAIN_LOOK.field(name, value),
};

LOOKS['poker-chip-race'] = POKER_CHIP_RACE_LOOK;

function pushWords(order) {
  if (!order) return 'nothing';
  return order.wait ? 'WAIT' : `push toward (${plainNumber(order.x)}, ${plainNumber(order.y)})`;
}

/** The chips of a player at the end of a turn, in the order of its commands. */
function chipsOf(match, number, player) {
  return [...match.turn(number).bodies.values()].filter(chip => chip.player === player);
}

function biggest(chips) {
  return chips.reduce((best, chip) => (best && best.radius >= chip.radius ? best : chip), null);
}

function drawChip(scene, body) {
  const { ctx, view, paint, theme, show } = scene;
  const [x, y, radius] = [view.x(body.x), view.y(body.y), Math.max(1.5, body.radius * view.scale)];
  const isNeutral = body.after.player === undefined;      // the drawing knows who owned it at the start
  const colour = isNeutral ? paint.muted : theme.team(body.after.player);
  circle(ctx, x, y, radius);
  ctx.fillStyle = paint.field;                            // hides the trail below
  ctx.fill();
  ctx.fillStyle = withAlpha(colour, isNeutral ? 0.3 : 0.75);
  ctx.fill();
  ctx.strokeStyle = colour;
  ctx.lineWidth = isNeutral ? 1 : 2;
  ctx.stroke();
  if (radius < CHIP_NAME_PIXELS) return;
  drawNotches(ctx, x, y, radius, isNeutral ? colour : paint.halo);
  if (show.names && !isNeutral) {
    write({ ctx, paint }, String(body.id), x, y, Math.max(9, Math.min(16, radius * 0.6)), paint.ink, '800');
  }
}

/** The marks around the rim by which one knows a poker chip. */
function drawNotches(ctx, x, y, radius, colour) {
  const middle = radius * (1 + RIM) / 2;
  ctx.lineCap = 'butt';
  ctx.lineWidth = radius * (1 - RIM);
  ctx.strokeStyle = withAlpha(colour, 0.7);
  for (let k = 0; k < NOTCHES; k++) {
    const angle = (k + 0.25) * 2 * Math.PI / NOTCHES;
    ctx.beginPath();
    ctx.arc(x, y, middle, angle, angle + Math.PI / NOTCHES);
    ctx.stroke();
  }
}

/** A line from each chip that pushes itself in the turn shown, in its direction. */
function drawPushes({ ctx, view, theme, match, moment }, player) {
  const turn = match.turn(moment.turn);
  if (!turn?.commands || moment.turn === 0) return;
  const before = chipsOf(match, moment.turn - 1, player);
  ctx.strokeStyle = theme.team(player);
  ctx.globalAlpha = 0.6;
  ctx.lineWidth = 1.5;
  ctx.setLineDash([5, 5]);
  (turn.commands[player] ?? []).forEach((order, k) => {
    const chip = before[k];
    if (order?.x === undefined || !chip || chip.radius <= SMALL_CHIP) return;
    const far = Math.hypot(order.x - chip.x, order.y - chip.y);
    const share = Math.min(1, 4 * chip.radius / Math.max(1e-9, far));     // only the direction counts
    ctx.beginPath();
    moveTo(ctx, view, chip.x, chip.y);
    lineTo(ctx, view, chip.x + (order.x - chip.x) * share, chip.y + (order.y - chip.y) * share);
    ctx.stroke();
  });
  ctx.setLineDash([]);
  ctx.globalAlpha = 1;
}
