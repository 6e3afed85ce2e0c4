/**
 * Protocol of the pod race: JSON frames and answers, CodinGame's lines, the community's test protocol for simulators;
 * and {@link steward.game.podrace.protocol.PodRaceType}, the game as the other rooms see it.
 */
package steward.game.podrace.protocol;
