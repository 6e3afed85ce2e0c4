package steward.lab.stability.crowds;

import java.util.Locale;
import steward.lab.trial.CrowdCheck;
import steward.lab.trial.Finding;
import steward.lab.trial.Gas;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.physics.Arithmetic;

/** Stability case of a crowd in a box, played for many impacts to see whether any is missed. */
public final class CrowdCase extends StabilityCase {

    private static final long SEED = 9;
    private static final int LONG_IMPACTS = 10_000_000;

    private static final int MOST_STEPPED = 1000;

    private final int bodies;
    private final double coverage;
    private final long longest;

    /**
     * @param coverage share of the box that is covered
     * @param longest  how many impacts the long version has in {@code double}, which most scenes use
     */
    public CrowdCase(int bodies, double coverage, long longest) {
        super(String.format(Locale.ROOT, "crowd of %d, %.0f%%", bodies, 100 * coverage),
            "cells and an event queue over many impacts. No two overlap and no body is outside the box at the end of"
            + " any turn, and no impact is without a touch, by more than rounding explains. On every event rung");
        this.bodies = bodies;
        this.coverage = coverage;
        this.longest = longest;
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        if (!rung.isEvent() && bodies > MOST_STEPPED) {
            return Finding.reported("not tried: each step looks at all pairs");
        }
        long wanted = !rung.isEvent() ? 1000
            : size == RunLength.LONG && rung.arithmetic() == Arithmetic.DOUBLE ? longest
            : size.pick(20_000, 1_000_000, LONG_IMPACTS);
        CrowdCheck.Result seen = CrowdCheck.run(new Gas(SEED, bodies, coverage), rung, wanted);
        return Finding.of(rung.isEvent(), seen.isRight() && seen.impacts() >= wanted, seen.toString());
    }
}
