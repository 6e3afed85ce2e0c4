/** Permission to play for a league: the broker's key, the workers and their tokens, in private files. */
package steward.machines.token;
