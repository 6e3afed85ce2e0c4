/**
 * Protocol of the pod race: JSON frames and answers, CodinGame's lines, the community's test protocol for simulators.
 * Other packages see the game as {@link steward.game.podrace.protocol.PodRaceType}.
 */
package steward.game.podrace.protocol;
