package steward.replay.verify;

import java.util.Arrays;
import steward.game.AngleVariants;
import steward.game.Game;
import steward.physics.Impact;
import steward.physics.TurnLog;

/**
 * Range of the times and impulses of a turn's impacts when each sine and cosine of that turn is a unit in the last
 * place off: another referee's values must lie in it where they are not equal to the last bit.
 */
final class ImpactRange {

    private final double[] leastTime;
    private final double[] greatestTime;
    private final double[] leastImpulse;
    private final double[] greatestImpulse;

    /** @param played the turn as it was played; variants in which other pairs meet are left out */
    ImpactRange(Game played, AngleVariants variants) {
        TurnLog of = played.log();
        int impacts = of.kept();
        leastTime = new double[impacts];
        greatestTime = new double[impacts];
        leastImpulse = new double[impacts];
        greatestImpulse = new double[impacts];
        Arrays.fill(leastTime, Double.POSITIVE_INFINITY);
        Arrays.fill(greatestTime, Double.NEGATIVE_INFINITY);
        Arrays.fill(leastImpulse, Double.POSITIVE_INFINITY);
        Arrays.fill(greatestImpulse, Double.NEGATIVE_INFINITY);
        add(of, of);
        if (variants != null) {
            variants.play(variant -> add(of, variant));
        }
    }

    private void add(TurnLog of, TurnLog variant) {
        if (variant.impacts() != of.impacts()) {
            return;
        }
        for (int k = 0; k < of.kept(); k++) {
            Impact impact = variant.impact(k);
            if (impact.a() != of.impact(k).a() || impact.b() != of.impact(k).b()) {
                return;
            }
        }
        for (int k = 0; k < of.kept(); k++) {
            Impact impact = variant.impact(k);
            leastTime[k] = Math.min(leastTime[k], impact.time());
            greatestTime[k] = Math.max(greatestTime[k], impact.time());
            leastImpulse[k] = Math.min(leastImpulse[k], impact.impulse());
            greatestImpulse[k] = Math.max(greatestImpulse[k], impact.impulse());
        }
    }

    /** True if a recorded time of an impact can be that of a referee with such errors. */
    boolean holdsTime(int impact, double time) {
        return time >= leastTime[impact] && time <= greatestTime[impact];
    }

    /** True if a recorded impulse can be that of a referee with such errors. */
    boolean holdsImpulse(int impact, double impulse) {
        return impulse >= leastImpulse[impact] && impulse <= greatestImpulse[impact];
    }
}
