/**
 * The pod race (CodinGame's Mad Pod Racing, once Coders Strike Back): rules free of JSON in {@code PodRace}, its
 * settings, its maps, its frames in {@code PodRaceJson} and CodinGame's lines in {@code PodRaceText}. Processes and
 * deadlines are not known here.
 */
package steward.game.podrace;
