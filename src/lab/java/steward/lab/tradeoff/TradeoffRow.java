package steward.lab.tradeoff;

/**
 * A rung on a scene: what it costs, and its errors, both from the same starting states.
 *
 * @param scene       name of the scene
 * @param rung        name of the rung
 * @param states      how many starting states, of a turn each
 * @param impacts     true impacts in all these turns
 * @param jvms        how many JVMs have timed it, one after the other
 * @param rounds      of timing in all of them, whose median the cost is
 * @param cost        what a turn costs
 * @param costRatio   the time of a turn as a multiple of that of {@code event/double}: the ratio of the medians
 * @param median      position error after one turn, in u: half of the turns have at most this error
 * @param most99      99% of the turns have at most this error
 * @param worst       the largest error of a turn
 * @param missed      true impacts that were not computed
 * @param invented    computed impacts that do not happen
 * @param energyError largest error of the kinetic energy after a turn, as a share of the true one
 * @param freeTurns   after how many turns of a free run a body's error exceeds 1 u, the median of the runs; one more
 *                    than {@code freeBound} if that does not happen
 * @param freeBound   how many turns the free runs had
 * @param differing   body-turns whose final numbers, rounded as the scene does, differ from the true ones
 * @param compared    body-turns compared; 0 where the scene does not round
 * @param onFront     whether no rung of the scene is both cheaper and more accurate (by {@code most99})
 */
public record TradeoffRow(String scene, String rung, int states, long impacts, int jvms, int rounds,
                          Cost cost, double costRatio, double median, double most99, double worst, long missed,
                          long invented, double energyError, int freeTurns, int freeBound, long differing,
                          long compared, boolean onFront) {

    /** The demand by which a rung is chosen for pages and pictures: 99% of the turns are off by at most so many u. */
    public static final double DEMAND = 0.01;

    /** The rung that the others' cost is compared with. */
    public static final String DEFAULT_RUNG = "event/double";

    /**
     * Cost of a turn.
     *
     * @param nanosPerTurn   of the thread's CPU, the median of the rounds
     * @param low            one round in ten is faster than this
     * @param high           one round in ten is slower than this
     * @param nanosPerImpact the same by the impacts that the rung computes; NaN if there are none
     * @param bytesPerTurn   allocated; NaN where the JVM does not provide it
     */
    public record Cost(double nanosPerTurn, double low, double high, double nanosPerImpact, double bytesPerTurn) {
    }
}
