/** Costs of workers to the league's process, measured, and how many it could serve, simulated in virtual time. */
package steward.lab.capacity;
