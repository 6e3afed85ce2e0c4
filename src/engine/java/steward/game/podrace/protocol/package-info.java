/** Protocol of the pod race: JSON, CodinGame's lines, and the community's test protocol for simulators. */
package steward.game.podrace.protocol;
