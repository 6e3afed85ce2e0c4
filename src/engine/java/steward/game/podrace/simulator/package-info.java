/**
 * The official turn of the pod race for programs that play it millions of times: one race, or many in a batch, with the
 * same bits as the referee's engine and nothing allocated. Certified impact times decide quickly what is not in doubt.
 */
package steward.game.podrace.simulator;
