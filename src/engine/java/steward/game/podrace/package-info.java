/** Rules of the pod race (CodinGame's Mad Pod Racing, once Coders Strike Back), free of JSON: turns, settings, maps. */
package steward.game.podrace;
