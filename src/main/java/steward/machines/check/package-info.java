/**
 * Checks of a game that was played elsewhere before it is believed: its replay is played again, and its result is read
 * from that alone; and a share of the games is asked of the bots again, answer by answer.
 */
package steward.machines.check;
