package steward.physics;

/**
 * The law of impact of a scene. Start from {@link #PHYSICS} or {@link #OFFICIAL_POD_RACE} and change single rules with
 * the {@code with} methods.
 *
 * @param restitution           the rule for the share of the approach speed that comes back
 * @param minimumImpulse        the least second step of an impulse, in pod masses times u per turn; 0 for none
 * @param minimumImpulseAtWalls whether the minimum also holds at walls
 * @param deadZone              {@code NaN}: the second step is at least the minimum. Otherwise (Mean Max) it is raised
 *                              to the minimum by magnitude, keeping its sign, and only if its magnitude is above
 *                              this, at least 0
 * @param separatingPairsReact  whether two bodies that touch while they separate react (the official games; needs a
 *                              minimum impulse). Walls react only to approach
 * @param batchWindow           impacts up to this long after the earliest react together, in turns. 0: one at a time,
 *                              ties going to the lowest pair of ids, and all is looked at anew after each. On
 *                              {@code exact} the impacts of an instant are decided before its first one reacts; other
 *                              arithmetics see a tie where two times are equal as doubles
 * @param scanOrder             the order in which pairs are scanned; decides ties within a batch
 * @param pushOut               positional correction; {@code NaN} for none. Otherwise bodies that touch after an impact
 *                              are moved apart, each by half of the overlap plus this much (against infinite mass, the
 *                              movable one by both halves). Caveat: a body far behind a wall is moved by the whole
 *                              depth at once, even into another body
 * @param maximumImpacts        the bound on impacts in a turn; 0 for the default, 10,000 + 1,000 per body
 * @param restSpeed             in u per turn: an impact with restitution below 1 and without a minimum impulse is rest
 *                              if it would rebound at up to this speed. {@code NaN} for the default, which follows from
 *                              the forces and the energy of its bodies
 */
public record ImpactLaw(Restitution restitution, double minimumImpulse, boolean minimumImpulseAtWalls, double deadZone,
                        boolean separatingPairsReact, double batchWindow, ScanOrder scanOrder, double pushOut,
                        int maximumImpacts, double restSpeed) {

    /** Rule by which the restitution of an impact follows from the two partners'. */
    public enum Restitution {
        /** Every impact is elastic: no restitution is looked up. */
        ELASTIC,
        /** The lower of the two. */
        MINIMUM
    }

    /** The order of pairs (i, j) of indices; the first of the pair is body a of the impact. */
    public enum ScanOrder {
        /** i upward, j from i + 1 upward. */
        ASCENDING,
        /** i from the last downward, j from i - 1 downward. */
        DESCENDING
    }

    /** Perfectly elastic, one impact at a time, only approach reacts, no positional correction. */
    public static final ImpactLaw PHYSICS = new ImpactLaw(Restitution.ELASTIC, 0, false, Double.NaN, false, 0,
        ScanOrder.ASCENDING, Double.NaN, 0);

    /** CodinGame's pod race: minimum impulse 120, batches of 1e-5 turns, push-out of 1e-5 u. */
    public static final ImpactLaw OFFICIAL_POD_RACE = new ImpactLaw(Restitution.ELASTIC, 120, false, Double.NaN, true,
        1e-5, ScanOrder.DESCENDING, 1e-5, 0);

    /** @throws IllegalArgumentException if a value is out of range, or values contradict each other */
    public ImpactLaw {
        require(minimumImpulse >= 0 && minimumImpulse < Double.POSITIVE_INFINITY, "minimumImpulse", minimumImpulse,
            "finite and at least 0");
        require(Double.isNaN(deadZone) || deadZone >= 0, "deadZone", deadZone, "at least 0");
        require(batchWindow >= 0 && batchWindow <= 1, "batchWindow", batchWindow, "0..1");
        require(Double.isNaN(pushOut) || pushOut >= 0 && pushOut < Double.POSITIVE_INFINITY, "pushOut", pushOut,
            "finite and at least 0");
        require(maximumImpacts >= 0, "maximumImpacts", maximumImpacts, "at least 0");
        require(Double.isNaN(restSpeed) || restSpeed >= 0 && restSpeed < Double.POSITIVE_INFINITY, "restSpeed",
            restSpeed, "finite and at least 0");
        require(Double.isNaN(restSpeed) || minimumImpulse == 0, "minimumImpulse", minimumImpulse,
            "0, because there is a rest speed");
        require(!separatingPairsReact || minimumImpulse > 0, "minimumImpulse", minimumImpulse,
            "above 0, because separating pairs react");
        require(separatingPairsReact || batchWindow == 0, "batchWindow", batchWindow,
            "0, because only approaching pairs react");
    }

    /** A law with the default rest speed. */
    public ImpactLaw(Restitution restitution, double minimumImpulse, boolean minimumImpulseAtWalls, double deadZone,
                     boolean separatingPairsReact, double batchWindow, ScanOrder scanOrder, double pushOut,
                     int maximumImpacts) {
        this(restitution, minimumImpulse, minimumImpulseAtWalls, deadZone, separatingPairsReact, batchWindow, scanOrder,
            pushOut, maximumImpacts, Double.NaN);
    }

    public ImpactLaw withRestitution(Restitution value) {
        return new ImpactLaw(value, minimumImpulse, minimumImpulseAtWalls, deadZone, separatingPairsReact, batchWindow,
            scanOrder, pushOut, maximumImpacts, restSpeed);
    }

    /**
     * Returns this law with another minimum impulse.
     *
     * @param atWalls whether it also holds at walls
     */
    public ImpactLaw withMinimumImpulse(double value, boolean atWalls) {
        return new ImpactLaw(restitution, value, atWalls, deadZone, separatingPairsReact, batchWindow, scanOrder,
            pushOut, maximumImpacts, restSpeed);
    }

    /** Returns this law with another dead zone; NaN for none. */
    public ImpactLaw withDeadZone(double value) {
        return new ImpactLaw(restitution, minimumImpulse, minimumImpulseAtWalls, value, separatingPairsReact,
            batchWindow, scanOrder, pushOut, maximumImpacts, restSpeed);
    }

    /** Returns this law with another push-out, in u; NaN for none. */
    public ImpactLaw withPushOut(double value) {
        return new ImpactLaw(restitution, minimumImpulse, minimumImpulseAtWalls, deadZone, separatingPairsReact,
            batchWindow, scanOrder, value, maximumImpacts, restSpeed);
    }

    /** Returns this law with another bound on the impacts in a turn; 0 for the default. */
    public ImpactLaw withMaximumImpacts(int value) {
        return new ImpactLaw(restitution, minimumImpulse, minimumImpulseAtWalls, deadZone, separatingPairsReact,
            batchWindow, scanOrder, pushOut, value, restSpeed);
    }

    /** Returns this law with another rest speed, in u per turn; NaN for the default. */
    public ImpactLaw withRestSpeed(double value) {
        return new ImpactLaw(restitution, minimumImpulse, minimumImpulseAtWalls, deadZone, separatingPairsReact,
            batchWindow, scanOrder, pushOut, maximumImpacts, value);
    }

    /** True if bodies can come to rest on each other: some rebound by less, and no minimum impulse drives them. */
    public boolean bodiesRest() {
        return restitution != Restitution.ELASTIC && !(minimumImpulse > 0);
    }

    /** The bound on impacts in a turn with this many bodies. */
    public int impactLimit(int bodies) {
        return maximumImpacts > 0 ? maximumImpacts : 10_000 + 1_000 * bodies;
    }

    private static void require(boolean inRange, String what, double value, String expected) {
        if (!inRange) {
            throw new IllegalArgumentException("impact law: " + what + " " + value + ", expected " + expected);
        }
    }
}
