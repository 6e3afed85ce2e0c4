/**
 * Rules of the pod race (CodinGame's Mad Pod Racing, once Coders Strike Back), free of JSON: turns, checkpoints,
 * standings, settings and maps. Frames and lines are in {@code protocol}, the fast turn in {@code simulator}.
 */
package steward.game.podrace;
