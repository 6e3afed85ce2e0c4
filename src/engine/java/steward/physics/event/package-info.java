/**
 * Ways to advance a turn. {@code EventLoop} goes from impact to impact at exact times, for few bodies in {@code
 * EventAdvance} and for many in {@code QueueAdvance}; {@code BatchLoop} is for impacts that react in batches; {@code
 * StepAdvance} goes in fixed steps. Two forms reproduce the bits of published referees: {@code OfficialLoop}, which a
 * game fills in with its referee's expressions, and {@code OfficialAdvance}, the fast form for equal circles without
 * walls, which leaves other scenes to {@code EventAdvance}. The packages below hold the parts of the loop: {@code
 * flight}, and neighbours by {@code pairs} and by {@code cells}.
 */
package steward.physics.event;
