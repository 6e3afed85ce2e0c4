package steward.lab.oracle;

/**
 * How far a turn that was computed on some rung is from the true one.
 *
 * @param position the most that the centre of a body is off at the end of the turn, in u; infinite if it is no number
 * @param missed   impacts that happen but were not computed: counted by who meets whom, whatever the time
 * @param invented impacts that were computed but do not happen
 * @param energy   the kinetic energy that is wrong, as a share of the true one; at least 0
 */
public record TurnError(double position, int missed, int invented, double energy) {
}
