package steward.lab.stability.pairs;

import java.math.BigDecimal;
import java.util.List;
import java.util.Locale;
import steward.lab.trial.Finding;
import steward.lab.trial.Probe;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.HalfPlane;
import steward.physics.ImpactLaw;

/**
 * Stability case of two blocks and a wall, whose impacts count the digits of pi. With masses 1 and 100^k the number of
 * impacts is written with the first k + 1 digits of pi (G. Galperin, "Playing pool with pi", 2003).
 */
public final class PiBlocksCase extends StabilityCase {

    private static final List<Integer> DIGITS =
        List.of(3, 31, 314, 3141, 31415, 314159, 3141592, 31415926, 314159265);
    private static final double ENERGY = 1e-12;

    public PiBlocksCase() {
        super("pi-blocks",
            "3, 31, 314, ... impacts for mass ratios 100^k on every event rung; energy to 1e-12 on exact");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        StringBuilder text = new StringBuilder("impacts");
        boolean counted = true;
        double worst = 0;
        int last = rung.isEvent() ? size.pick(5, 6, 8) : 2;
        for (int k = 0; k <= last; k++) {
            Bodies bodies = blocks(k);
            BigDecimal energy = Probe.energy(bodies);
            long impacts = impacts(rung, bodies);
            counted &= impacts == DIGITS.get(k);
            worst = Math.max(worst, Probe.energy(bodies).subtract(energy).abs().doubleValue() / energy.doubleValue());
            text.append(' ').append(impacts);
        }
        text.append(String.format(Locale.ROOT, "; energy error %.1e", worst));
        return Finding.of(rung.isEvent(), counted && (!rung.isExact() || worst <= ENERGY), text.toString());
    }

    private static Bodies blocks(int k) {
        Bodies bodies = new Bodies(2);
        bodies.add(10, 0, 1, 1);
        bodies.add(20, 0, 1, StrictMath.pow(100, k));
        bodies.setVelocity(1, -1, 0);
        return bodies;
    }

    /** Plays until both fly away from the wall, the faster one ahead. */
    private static long impacts(Rung rung, Bodies bodies) {
        Advance advance = rung.advance(ImpactLaw.PHYSICS.withMaximumImpacts(Integer.MAX_VALUE),
            new HalfPlane(0, 0, 1, 0, 1));
        Probe count = new Probe();
        for (int turn = 0; turn < 1000; turn++) {
            advance.turn(bodies, count);
            if (bodies.vx[0] >= 0 && bodies.vx[1] >= bodies.vx[0]) {
                break;
            }
        }
        return count.impacts;
    }
}
