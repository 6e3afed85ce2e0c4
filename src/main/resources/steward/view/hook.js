// For tests and for the curious, in the console: where the page stands, and where it draws what.

import { impactsCsv, statesCsv } from './csv.js';
import { contactOf, flashRadius } from './effects.js';
import { pairOf } from './timeline.js';

/** Places are in CSS pixels of the window. */
export function hookOf(page) {
  const toWindow = (x, y) => {
    const { left, top } = page.stage.canvas.getBoundingClientRect();
    return { x: left + page.stage.view.x(x), y: top + page.stage.view.y(y) };
  };
  return {
    turn: () => page.playback.moment.turn,
    time: () => page.playback.time,
    match: () => page.match,
    lastTurn: () => page.match.lastTurn,
    seek(turn, fraction = 1) {
      page.playback.seek(turn === 0 ? 0 : turn - 1 + fraction);
      page.draw();
    },
    show(time) {
      page.playback.seek(time);
      page.draw();
    },
    commandLines: (turn, player) => page.look.commandLines(page.match.turn(turn).commands[player], player, page.match),
    go: link => page.followLink(link),
    bodies: () => page.match.bodiesAt(page.playback.moment).map(body => ({ id: body.id, owner: body.owner,
      ...toWindow(body.x, body.y), radius: body.radius * page.stage.view.scale })),
    impacts: () => page.match.impacts.map(met => {
      const { x, y } = contactOf(page.match, met);
      return { time: met.time, ...toWindow(x, y), radius: flashRadius(page.match, met) * page.stage.view.scale };
    }),
    impactWords: () => page.match.impacts.map(({ impact }) => pairOf(page.match, impact)),
    numbers: () => page.stage.numbers,
    field: () => {
      const { left, top, right, bottom } = page.stage.field;
      const [from, to] = [toWindow(left, top), toWindow(right, bottom)];
      return { left: from.x, top: from.y, right: to.x, bottom: to.y };
    },
    csv: id => (id === undefined ? { states: statesCsv(page.match), impacts: impactsCsv(page.match) } : { states: statesCsv(page.match, id) }),
    playing: () => page.playback.playing,
    follows: () => page.playback.follows,
    speed: () => page.playback.speed,
    selected: () => page.stage.selected,
    camera: () => ({ scale: page.stage.view.scale, follow: page.stage.view.follow, isHeld: page.stage.view.isHeld }),
    colourOf: player => page.theme.team(player),
    play: () => page.playback.play(),
    pause: () => page.playback.pause(),
    addTurn: line => page.addLine(line),
    /** Calls take(ms of script, turn) for each frame. */
    onFrame(take) {
      page.onFrame = take;
    },
    /** Leaves out a part of the drawing, such as drawBody, or all parts are back. */
    hide(part, isHidden = true) {
      page.stage.look = isHidden ? { ...page.stage.look, [part]() {} } : page.look;
      page.theme.read();
    },
    ready: false,
  };
}
