/**
 * Ways to advance a turn by scanning all pairs: from impact to impact at exact times, in fixed steps, and the published
 * referee's own loop.
 */
package steward.physics.event;
