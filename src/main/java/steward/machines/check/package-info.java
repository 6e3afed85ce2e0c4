/**
 * Checks of a remote game before it counts. Its commands are played again, and the result is computed from them alone;
 * for a share of the games the bots are asked again, answer by answer.
 */
package steward.machines.check;
