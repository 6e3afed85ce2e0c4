// The look of the search race: a course like that of the pod race, and one car with its heading and flame.

const SEARCH_RACE_LOOK = {
  drawGround: POD_RACE_LOOK.drawGround,

  drawBelow(scene) {
    scene.bodies.forEach(car => {
      if (scene.show.targets) drawCarTarget(scene, car);
      drawCarFlame(scene, car);
    });
  },

  /** A hull alone: the car is a point and has no true size. */
  drawBody(scene, car) {
    const { ctx, theme, match, moment, paint } = scene;
    withPod(scene, car, headingOf(scene, car), radius => {
      traceHull(ctx, 1.5 * radius, car.owner);
      ctx.fillStyle = match.isIn(car.owner, moment.turn) ? theme.team(car.owner) : paint.muted;
      ctx.fill();
      circle(ctx, 0, 0, Math.max(1.5, 0.16 * radius));
      ctx.fillStyle = paint.field;
      ctx.fill();
    });
  },

  drawAbove() {},

  /** The laps and checkpoints, and the time: of full turns while it goes on, the result at the end. */
  standing(match, number) {
    const { state } = match.turn(number);
    const laps = match.header.scene.race.laps;
    const all = laps * match.header.drawing.zones.length;
    const { passed } = state.bodies[0];
    const timer = state.timer + (passed >= all ? state.passTime : 0);
    return [{
      rank: 0,
      body: 0,
      big: passed >= all ? `${timer.toFixed(2)} turns`
        : `Lap ${Math.min(laps, Math.floor(passed * laps / all) + 1)}/${laps}`,
      small: `${passed} of ${all} checkpoints`,
      warning: warningOfTurns(match.header.scene.race.maximumTurns - state.timer),
    }];
  },

  commandLines: command => [(command.turn === undefined
    ? `(${plainNumber(command.x)}, ${plainNumber(command.y)})` : `turn ${command.turn}°`)
    + ` thrust ${command.thrust}`],

  field(name, value) {
    if (name === 'heading') return `${positiveDegrees(value).toFixed(0)}°`;
    return PLAIN_LOOK.field(name, value);
  },
};

LOOKS['search-race'] = SEARCH_RACE_LOOK;

function warningOfTurns(left) {
  return left > 0 && left < WARNING_TURNS ? `${left} turns left` : '';
}

/** What the car was told for the turn shown, or null. */
function carOrderOf({ match, moment }, car) {
  return match.turn(moment.turn)?.commands?.[car.owner] ?? null;
}

function drawCarTarget(scene, car) {
  const order = carOrderOf(scene, car);
  if (order?.x === undefined) return;
  const { ctx, view, theme } = scene;
  ctx.strokeStyle = theme.team(car.owner);
  ctx.globalAlpha = 0.5;
  ctx.lineWidth = 1;
  ctx.setLineDash([5, 5]);
  ctx.beginPath();
  moveTo(ctx, view, car.x, car.y);
  lineTo(ctx, view, order.x, order.y);
  ctx.stroke();
  ctx.setLineDash([]);
  ctx.globalAlpha = 1;
}

/** As long as the thrust is strong. */
function drawCarFlame(scene, car) {
  const { ctx, paint, theme, moment, turnsPerSecond } = scene;
  const thrust = carOrderOf(scene, car)?.thrust ?? 0;
  if (thrust <= 0) return;
  const flicker = theme.isCalm || !turnsPerSecond ? 1 : 1 + 0.08 * Math.sin(moment.time * 37);
  const length = (0.5 + thrust / 130) * flicker;
  withPod(scene, car, headingOf(scene, car), radius => {
    ctx.globalCompositeOperation = theme.isDark ? 'lighter' : 'source-over';
    fillFlame(ctx, radius, 0.5, length, withAlpha(paint.flame, 0.8));
    fillFlame(ctx, radius, 0.26, 0.6 * length, paint.core);
  });
}
