package steward.lab.trial;

import static steward.lab.oracle.DecimalErrors.ulps;

import java.util.List;
import java.util.Locale;
import steward.lab.oracle.Oracle;
import steward.lab.oracle.OracleBody;
import steward.lab.oracle.OracleImpact;
import steward.lab.oracle.PairOracle;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.Impact;
import steward.physics.ImpactLaw;
import steward.physics.TurnLog;

/**
 * Tally of the first impacts of many pairs on a rung, compared with {@link PairOracle} and {@link Oracle}. It counts
 * wrong decisions and keeps the worst errors in units in the last place.
 */
public final class PairTally {

    private final Rung rung;
    private final Advance advance;
    private final Oracle oracle = new Oracle(ImpactLaw.PHYSICS.withMaximumImpacts(1), List.of());
    private final TurnLog log = new TurnLog();
    private final Bodies before = new Bodies(2);
    private long pairs;
    private long hits;
    private long wrong;
    private long refused;
    private long timed;
    private double timeUlps;
    private double positionUlps;
    private double impulseUlps;
    private double velocityUlps;
    private String firstWrong = "";

    public PairTally(Rung rung) {
        this.rung = rung;
        advance = rung.advance(ImpactLaw.PHYSICS);
    }

    /** Decision and time of impact. @param whole whether to compare positions, impulse and velocities as well */
    public void add(Bodies bodies, boolean whole) {
        PairOracle truth = new PairOracle(bodies);
        List<OracleBody> state = whole && truth.hit() ? OracleBody.of(bodies) : null;
        before.copyFrom(bodies);
        pairs++;
        hits += truth.hit() ? 1 : 0;
        log.clear();
        try {
            advance.turn(bodies, log);
        } catch (IllegalArgumentException refusal) {
            refused++;
            return;
        }
        if (log.impacts() > 0 != truth.hit()) {
            wrong++;
            firstWrong = firstWrong.isEmpty() ? (truth.hit() ? "missed " : "invented ") + describe(before) : firstWrong;
            return;
        }
        if (truth.hit()) {
            Impact impact = log.impact(0);
            timed++;
            timeUlps = Math.max(timeUlps, truth.ulps(impact.time()));
            if (state != null) {
                compare(impact, oracle.turn(state).get(0));
            }
        }
    }

    private void compare(Impact seen, OracleImpact truth) {
        positionUlps = Math.max(positionUlps, Math.max(
            Math.max(ulps(seen.ax(), truth.ax()), ulps(seen.ay(), truth.ay())),
            Math.max(ulps(seen.bx(), truth.bx()), ulps(seen.by(), truth.by()))));
        impulseUlps = Math.max(impulseUlps, ulps(seen.impulse(), truth.impulse()));
        velocityUlps = Math.max(velocityUlps, Math.max(
            Math.max(ulps(seen.vaxAfter(), truth.vax()), ulps(seen.vayAfter(), truth.vay())),
            Math.max(ulps(seen.vbxAfter(), truth.vbx()), ulps(seen.vbyAfter(), truth.vby()))));
    }

    private static String describe(Bodies b) {
        return String.format(Locale.ROOT, "(%s, %s) r %s v (%s, %s) m %s; (%s, %s) r %s v (%s, %s) m %s",
            b.x[0], b.y[0], b.radius[0], b.vx[0], b.vy[0], b.mass[0],
            b.x[1], b.y[1], b.radius[1], b.vx[1], b.vy[1], b.mass[1]);
    }

    /** The result; on the exact rung no decision may be wrong and no error above {@link Rung#EXACT_ULPS}. */
    public Finding seen() {
        boolean met = isRight()
            && Math.max(Math.max(timeUlps, positionUlps), Math.max(impulseUlps, velocityUlps)) <= Rung.EXACT_ULPS;
        return Finding.of(rung.isExact(), met, text());
    }

    /** True if all decisions were made, and none was wrong. */
    public boolean isRight() {
        return wrong + refused == 0;
    }

    public long wrong() {
        return wrong;
    }

    public double timeUlps() {
        return timeUlps;
    }

    /** The worst error of a velocity, of the pairs that were compared as a whole. */
    public double velocityUlps() {
        return velocityUlps;
    }

    /** The worst error of a position, of the pairs that were compared as a whole. */
    public double positionUlps() {
        return positionUlps;
    }

    public String text() {
        String whole = positionUlps + impulseUlps + velocityUlps == 0 ? "" : String.format(Locale.ROOT,
            ", position %.3g, impulse %.3g, velocity %.3g", positionUlps, impulseUlps, velocityUlps);
        return String.format(Locale.ROOT, "%d pairs, %d hits, wrong %d%s%s%s", pairs, hits, wrong,
            refused > 0 ? ", refused " + refused : "",
            timed == 0 ? "" : String.format(Locale.ROOT, "; ulp: time %.3g", timeUlps), whole)
            + (rung.isExact() && wrong > 0 ? "; first " + firstWrong : "");
    }
}
