package steward.lab.tradeoff;

/**
 * Cost and errors of one rung on one scene, both from the same starting states.
 *
 * @param states      how many starting states, of a turn each
 * @param impacts     true impacts in all these turns
 * @param jvms        how many JVMs have timed it, one after the other
 * @param rounds      of timing in all of them
 * @param cost        what a turn costs
 * @param costRatio   the time of a turn as a multiple of that of {@code event/double}
 * @param ratioLow    the least ratio of two JVMs that were measured in the same rounds
 * @param ratioHigh   the greatest
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
                          Cost cost, double costRatio, double ratioLow, double ratioHigh, double median,
                          double most99, double worst, long missed, long invented, double energyError, int freeTurns,
                          int freeBound, long differing, long compared, boolean onFront) {

    /** Part of the demand by which a rung is chosen: 99% of the turns are off by at most so many u. */
    public static final double DEMAND = 0.01;

    /** The rung that the others' cost is compared with. */
    public static final String DEFAULT_RUNG = "event/double";

    /** The rung without its way: {@code double} of {@code event/double}. */
    public String shortName() {
        return rung.replace("event/", "");
    }

    /**
     * Cost of a turn. A JVM's time is the median of its rounds; there is none over JVMs, whose compilers settle in
     * different states: the middle one stands for them, beside the range.
     *
     * @param nanosPerTurn   of the thread's CPU, in the JVM that is in the middle
     * @param low            in the fastest JVM
     * @param high           in the slowest JVM
     * @param nanosPerImpact the same by the impacts that the rung computes; NaN if there are none
     * @param bytesPerTurn   allocated; NaN where the JVM does not provide it
     */
    public record Cost(double nanosPerTurn, double low, double high, double nanosPerImpact, double bytesPerTurn) { }
}
