/** Checks of a game that was played elsewhere: it is played again, and some bots are asked again. */
package steward.machines.check;
