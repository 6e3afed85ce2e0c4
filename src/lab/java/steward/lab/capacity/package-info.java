/**
 * Costs of workers to the league's process, measured; and the number of workers it could serve, simulated in virtual
 * time.
 */
package steward.lab.capacity;
