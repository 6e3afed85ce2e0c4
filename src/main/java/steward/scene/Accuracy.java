package steward.scene;

import steward.physics.Arithmetic;

/**
 * With how much care a scene is computed.
 *
 * @param advance    the way to advance a turn: {@code event}, from impact to impact at exact times
 * @param arithmetic how times of impact are computed
 */
public record Accuracy(String advance, Arithmetic arithmetic) {
}
