/** A worker: takes games of a league from its broker, plays them on this machine, and sends the results. */
package steward.machines.worker;
