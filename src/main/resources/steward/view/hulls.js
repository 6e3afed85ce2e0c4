// Hulls: the outline tells the team, also without colours. Eight outlines; later teams have a stripe.

import { circle, fillWith, polygon, ramp, regular, sprites, strokeWith } from './draw.js';
import { withAlpha } from './theme.js';

// Unit outlines of ships, nose to the right.
const SHIPS = [
  [[1, 0], [0.25, 0.3], [-0.1, 0.8], [-0.62, 0.72], [-0.4, 0.2], [-0.66, 0], [-0.4, -0.2], [-0.62, -0.72],
    [-0.1, -0.8], [0.25, -0.3]],
  [[0.86, 0.62], [0.5, 0.2], [0.62, 0], [0.5, -0.2], [0.86, -0.62], [0, -0.66], [-0.78, -0.42], [-0.5, 0],
    [-0.78, 0.42], [0, 0.66]],
  [[0.92, 0.18], [0.92, -0.18], [0.2, -0.34], [-0.2, -0.86], [-0.5, -0.8], [-0.34, -0.3], [-0.82, -0.24],
    [-0.82, 0.24], [-0.34, 0.3], [-0.5, 0.8], [-0.2, 0.86], [0.2, 0.34]],
  [[0.95, 0], [0.35, 0.62], [-0.45, 0.62], [-0.8, 0.2], [-0.8, -0.2], [-0.45, -0.62], [0.35, -0.62]],
  [[0.95, 0], [-0.1, 0.28], [-0.75, 0.85], [-0.55, 0], [-0.75, -0.85], [-0.1, -0.28]],
  [[0.7, 0.34], [0.95, 0], [0.7, -0.34], [0.05, -0.3], [0.3, -0.85], [-0.75, -0.6], [-0.55, 0], [-0.75, 0.6],
    [0.3, 0.85], [0.05, 0.3]],
  [[0.9, 0.3], [0.9, -0.3], [-0.1, -0.75], [-0.85, -0.3], [-0.55, 0], [-0.85, 0.3], [-0.1, 0.75]],
  [[0.95, 0], [0.42, 0.2], [0.3, 0.78], [0, 0.3], [-0.72, 0.62], [-0.42, 0], [-0.72, -0.62], [0, -0.3],
    [0.3, -0.78], [0.42, -0.2]],
];
const SIDES = [0, 4, 3, 6, 5, 8, 4, 3];         // of badges; the seventh and eighth stand turned

/** A form that tells the team of things that have no nose: disc, diamond, triangle, hexagon, ... */
export function traceBadge(ctx, x, y, radius, team) {
  const form = (team ?? 0) % SIDES.length;
  const sides = SIDES[form];
  if (!sides) circle(ctx, x, y, radius * 0.94);
  else regular(ctx, x, y, radius * (sides === 3 ? 1.16 : 1.04), sides, form === 6 ? Math.PI / 4 : form === 7 ? Math.PI : 0);
}

/** A ship in its team's colours: glow, true radius as a thin ring, hull, cockpit. Nose to the right. */
export function putShip(scene, body, angle, isIn, size = 1) {
  const { view, theme, paint } = scene;
  const radius = Math.max(3, body.radius * view.scale * size);
  const colour = isIn ? theme.team(body.owner) : paint.muted;
  sprites.put(scene, `ship ${body.owner} ${isIn} ${size}`, view.x(body.x), view.y(body.y), radius, angle, 2,
    (ctx, r) => {
      if (isIn) paintGlow(ctx, r * 1.9, colour, theme.isDark ? 0.34 : 0.16);
      circle(ctx, 0, 0, r);
      fillWith(ctx, theme.isDark ? withAlpha(paint.abyss, 0.82) : withAlpha(paint.field, 0.7));
      if (size === 1) {
        strokeWith(ctx, colour, Math.max(1, r * 0.055));
      }
      paintHull(ctx, r, body.owner, colour, paint, theme.isDark);
    });
}

function paintHull(ctx, r, team, colour, paint, isDark) {
  const metal = ramp(ctx.createLinearGradient(-r, -0.5 * r, r, 0.5 * r),
    [0, withAlpha(colour, 0.95)], [0.55, colour], [1, isDark ? 'white' : withAlpha(colour, 0.9)]);
  polygon(ctx, SHIPS[team % SHIPS.length], r * 0.97);
  fillWith(ctx, metal);
  ctx.lineJoin = 'round';
  strokeWith(ctx, isDark ? withAlpha('white', 0.8) : withAlpha(paint.ink, 0.75), Math.max(0.75, r * 0.05));
  ctx.save();
  ctx.clip();
  const shade = ramp(ctx.createLinearGradient(0, -r, 0, r),
    [0.5, withAlpha(paint.hull, 0)], [1, withAlpha(paint.hull, 0.75)]);
  ctx.fillStyle = shade;
  ctx.fillRect(-r, -r, 2 * r, 2 * r);
  if (team >= SHIPS.length) {
    ctx.fillStyle = withAlpha('white', 0.85);
    ctx.fillRect(-0.34 * r, -r, 0.16 * r, 2 * r);
  }
  ctx.restore();
  ctx.beginPath();
  ctx.ellipse(0.12 * r, 0, 0.26 * r, 0.12 * r, 0, 0, 2 * Math.PI);
  fillWith(ctx, paint.hull);
  strokeWith(ctx, withAlpha('white', 0.5), Math.max(0.5, r * 0.03));
}

/** A soft round light. */
export function paintGlow(ctx, radius, colour, strength) {
  const glow = ramp(ctx.createRadialGradient(0, 0, 0, 0, 0, radius),
    [0, withAlpha(colour, strength)], [0.45, withAlpha(colour, strength * 0.55)], [1, withAlpha(colour, 0)]);
  ctx.fillStyle = glow;
  circle(ctx, 0, 0, radius);
  ctx.fill();
}

/** A disc in its team's colours with the team's badge on it. */
export function putDisc(scene, body, isIn = true, name = 'disc') {
  const { view, theme, paint } = scene;
  const radius = Math.max(2, body.radius * view.scale);
  const hasOwner = body.owner !== null && body.owner !== undefined;
  const colour = isIn ? body.colour ?? theme.team(body.owner) : paint.muted;
  sprites.put(scene, `${name} ${body.owner} ${colour}`, view.x(body.x), view.y(body.y), radius, 0, 1.6, (ctx, r) => {
    if (hasOwner && r > 5) paintGlow(ctx, r * 1.55, colour, theme.isDark ? 0.4 : 0.2);
    circle(ctx, 0, 0, r);
    fillWith(ctx, theme.isDark ? paint.abyss : paint.field);
    fillWith(ctx, withAlpha(colour, 0.22));
    strokeWith(ctx, colour, Math.max(1, r * 0.07));
    paintBadge(ctx, r * 0.72, hasOwner ? body.owner : 0, colour, paint, theme.isDark);
  });
}

/** A ball: its colour to the rim, which stands out from any ground. */
export function putBall(scene, body, colour) {
  const { view, paint } = scene;
  sprites.put(scene, colour, view.x(body.x), view.y(body.y), Math.max(2, body.radius * view.scale), 0, 1.1, (ctx, r) => {
    circle(ctx, 0, 0, r);
    fillWith(ctx, colour);
    const light = ramp(ctx.createRadialGradient(-0.35 * r, -0.4 * r, 0, -0.35 * r, -0.4 * r, r),
      [0, withAlpha('white', 0.55)], [0.6, withAlpha('white', 0)]);
    fillWith(ctx, light);
    strokeWith(ctx, withAlpha(paint.ink, 0.4), Math.max(0.75, r * 0.07));
  });
}

export function paintBadge(ctx, r, team, colour, paint, isDark) {
  const light = ramp(ctx.createLinearGradient(0, -r, 0, r),
    [0, isDark ? withAlpha('white', 0.9) : withAlpha(colour, 0.75)], [0.3, colour], [1, withAlpha(colour, 0.75)]);
  traceBadge(ctx, 0, 0, r, team);
  fillWith(ctx, light);
  if (team >= SIDES.length) {
    ctx.strokeStyle = paint.hull;
    ctx.lineWidth = Math.max(1, r * 0.12);
    traceBadge(ctx, 0, 0, r * 0.6, team);
    ctx.stroke();
  }
}
