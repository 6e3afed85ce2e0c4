/**
 * Ways to advance a turn by scanning all pairs. {@code EventAdvance} goes from impact to impact at exact times, for any
 * scene and arithmetic; {@code StepAdvance} goes in fixed steps. Two forms reproduce the bits of published referees:
 * {@code OfficialLoop}, which a game fills in with its referee's expressions, and {@code OfficialAdvance}, the fast
 * form for equal circles without walls, which leaves to {@code EventAdvance} what it does not fit.
 */
package steward.physics.event;
