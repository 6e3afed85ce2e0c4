package steward.lab.oracle;

/**
 * Error of a turn computed on some rung, compared with the true turn.
 *
 * @param position largest error of a body's centre at the end of the turn, in u; infinite if it is not a number
 * @param missed   true impacts that were not computed: counted per pair, whatever the time
 * @param invented computed impacts that do not happen
 * @param energy   error of the kinetic energy, as a share of the true one; at least 0
 */
public record TurnError(double position, int missed, int invented, double energy) { }
