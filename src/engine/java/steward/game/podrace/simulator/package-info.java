/**
 * Fast simulation of the official pod race for programs that play it millions of times, one race or many in a batch. It
 * has the same bits as the referee's engine and allocates nothing. Certified impact times decide clear cases quickly.
 */
package steward.game.podrace.simulator;
