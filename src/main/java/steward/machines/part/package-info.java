/** Parts of a league's schedule, played by machines that cannot reach each other, and merged into the league. */
package steward.machines.part;
