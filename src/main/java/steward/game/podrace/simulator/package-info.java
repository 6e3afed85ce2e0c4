/**
 * The official turn of the pod race for those who play it millions of times: one race, or many in a batch, with the
 * bits of the engine that referees and nothing allocated. Certified impact times decide quickly what is not in doubt.
 */
package steward.game.podrace.simulator;
