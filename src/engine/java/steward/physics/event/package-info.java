/** Ways to advance a turn by all pairs: at exact times, in fixed steps, and the published referee's own loop. */
package steward.physics.event;
