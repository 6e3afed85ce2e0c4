/** The official turn of the pod race for programs that play millions: the referee's bits, nothing allocated. */
package steward.game.podrace.simulator;
