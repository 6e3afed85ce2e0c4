package steward.lab.oracle;

import java.math.BigDecimal;

/**
 * One impact computed by the oracle.
 *
 * @param time    within the turn
 * @param a       index of the first body
 * @param b       index of the second body, or {@code ~w} for the wall with index w
 * @param impulse along the normal from a to b
 * @param ax      centre of a at the impact
 * @param bx      centre of b; of a itself for a wall
 * @param vax     velocity of a afterwards
 * @param vbx     velocity of b afterwards; 0 for a wall
 */
public record OracleImpact(BigDecimal time, int a, int b, BigDecimal impulse, BigDecimal ax, BigDecimal ay,
                    BigDecimal bx, BigDecimal by, BigDecimal vax, BigDecimal vay, BigDecimal vbx, BigDecimal vby) {

    /** With more impulse, and the velocities that the bodies have by that. */
    OracleImpact with(BigDecimal more, OracleBody p, OracleBody q) {
        return new OracleImpact(time, a, b, impulse.add(more), ax, ay, bx, by, p.vx, p.vy, q == null ? vbx : q.vx,
            q == null ? vby : q.vy);
    }

    OracleImpact between(int one, int other) {
        return new OracleImpact(time, one, other, impulse, ax, ay, bx, by, vax, vay, vbx, vby);
    }
}
