/**
 * The pod race (CodinGame's Mad Pod Racing, once Coders Strike Back): rules free of JSON in {@code PodRace}, its
 * settings, its maps, and its frames in {@code PodRaceJson}. Processes and deadlines are not known here.
 */
package steward.game.podrace;
