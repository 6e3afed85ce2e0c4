/** A worker: takes games of a league from its broker, plays them here, and sends what came of them. */
package steward.machines.worker;
