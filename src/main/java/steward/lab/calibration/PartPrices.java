package steward.lab.calibration;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleConsumer;
import java.util.function.LongSupplier;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.game.Pilot;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.HalfPlane;
import steward.physics.Motion;
import steward.physics.TurnLog;
import steward.physics.Wall;
import steward.scene.Part;
import steward.scene.Scene;

/**
 * The time that each part of a scene's engine adds to a turn on this machine. States of seeded play are played with the
 * {@link PartByPartPhysics} of the scene, all steps in turn, round after round; a price is the median over the rounds
 * of the difference of two steps. The price of the game's parts is the time of the game before and after its bodies
 * fly, measured in games whose bodies do not move; parts that work at the same point of a turn share a price.
 *
 * <p>Caveat: all steps share a JVM, whose compiler sees more kinds of parts at one place than a match ever does, so
 * prices are a little high; the benchmark {@code Part} gives each step a JVM of its own.
 */
public final class PartPrices {

    private static final int STATES = 256;
    /** Turns of a slice, long enough for the clock. */
    private static final int TURNS = 1024;
    private static final int GAMES = 64;
    private static final long SEED = 1;
    /** Share of the time that is spent on warming up the compiler. */
    private static final double WARM_UP = 0.4;
    private static final int LEAST_ROUNDS = 5;
    /** Distance of the trial half-planes, as a multiple of the farthest point of any state: tested, but not touched. */
    private static final double FAR = 2;
    /** Standard deviation of a normal distribution from its median absolute deviation; and that of a median from it. */
    private static final double NORMAL = 1.4826;
    private static final double OF_MEDIAN = 1.2533;

    private final List<TimedTurns> slices = new ArrayList<>();
    private final List<double[]> rounds = new ArrayList<>();

    /**
     * The price of a part.
     *
     * @param part  its name
     * @param nanos nanoseconds a turn; may be below 0
     * @param error two standard errors of that
     */
    public record Price(String part, double nanos, double error) {
    }

    /**
     * The results.
     *
     * @param prices first that of the empty scene, then those of the physics' parts in the order of
     *               {@link PartByPartPhysics}, then those of the game's parts
     * @param turn   a turn of the whole scene, in nanoseconds
     * @param rounds how many rounds were used
     */
    public record Prices(List<Price> prices, Price turn, int rounds) {
    }

    private PartPrices() {
    }

    /**
     * Measures the prices.
     *
     * @param types    to open the scene with
     * @param play     of states of the scene
     * @param pilot    of its players
     * @param work     the clock for the prices, preferably one that stops while other processes have the processor
     * @param wall     the wall clock; both in nanoseconds from any origin
     * @param budget   for all rounds together, on the wall clock; five rounds are made in any case
     * @param progress receives the spent share of the budget after each round
     */
    public static Prices measure(Scene scene, GameTypes types, SeededPlay play, Pilot pilot,
                                 LongSupplier work, LongSupplier wall, long budget, DoubleConsumer progress) {
        GameSetup setup = types.open(scene);
        GameSetup still = types.open(scene.withObserver((parts, advance) -> (bodies, sink) -> { }));
        Bodies[] states = new Bodies[STATES];
        Arrays.setAll(states, k -> play.next());
        List<PartByPartPhysics.Step> steps = PartByPartPhysics.of(setup, box(states));
        PartPrices prices = new PartPrices();
        prices.slices.add(flights(states, (bodies, sink) -> { }, new Motion(false, false, false)));
        steps.forEach(step -> prices.slices.add(flights(states, step.advance(), step.motion())));
        prices.slices.add(flights(states, (bodies, sink) -> { }, setup.motion()));
        prices.slices.add(new RulesOnlyTurns(still, null, GAMES, SEED));
        prices.slices.add(new RulesOnlyTurns(still, pilot, GAMES, SEED));
        prices.time(work, wall, budget, progress);
        return prices.result(setup.plan().parts(), steps);
    }

    /** Distant walls on all sides of all states. */
    static List<Wall> box(Bodies[] states) {
        double far = 0;
        for (Bodies bodies : states) {
            for (int k = 0; k < bodies.size(); k++) {
                far = Math.max(far, Math.abs(bodies.x[k]) + Math.abs(bodies.y[k]) + bodies.radius[k]
                    + Math.abs(bodies.vx[k]) + Math.abs(bodies.vy[k]));
            }
        }
        far *= FAR;
        return List.of(new HalfPlane(-far, 0, 1, 0, 1), new HalfPlane(0, -far, 0, 1, 1),
            new HalfPlane(far, 0, -1, 0, 1), new HalfPlane(0, far, 0, -1, 1));
    }

    private static TimedTurns flights(Bodies[] states, Advance advance, Motion motion) {
        Bodies[] played = alike(states);
        TurnLog log = new TurnLog();
        return new TimedTurns() {
            @Override
            public void run() {
                for (int turn = 0; turn < TURNS; turn++) {
                    Bodies bodies = played[turn % states.length];
                    bodies.copyFrom(states[turn % states.length]);
                    log.clear();
                    advance.turn(bodies, log);
                    motion.endTurn(bodies);
                }
            }

            @Override
            public int turns() {
                return TURNS;
            }
        };
    }

    /** For each state the bodies that take copies of it; states of one capacity, as most scenes have, share theirs. */
    private static Bodies[] alike(Bodies[] states) {
        Map<Integer, Bodies> shared = new HashMap<>();
        return Arrays.stream(states).map(state -> shared.computeIfAbsent(state.capacity(), capacity -> state.copy()))
            .toArray(Bodies[]::new);
    }

    private void time(LongSupplier work, LongSupplier wall, long budget, DoubleConsumer progress) {
        long begin = wall.getAsLong();
        double share = 0;
        int warm = 0;
        while (share < 1 || rounds.size() < warm + LEAST_ROUNDS) {
            double[] nanos = new double[slices.size()];
            for (int k = 0; k < nanos.length; k++) {
                TimedTurns slice = slices.get(k);
                slice.prepare();
                long start = work.getAsLong();
                slice.run();
                nanos[k] = (double) (work.getAsLong() - start) / slice.turns();
            }
            rounds.add(nanos);
            share = (double) (wall.getAsLong() - begin) / budget;
            warm = share < WARM_UP ? rounds.size() : warm;
            progress.accept(Math.min(1, share));
        }
        rounds.subList(0, warm).clear();
    }

    private Prices result(List<Part> parts, List<PartByPartPhysics.Step> steps) {
        List<Price> prices = new ArrayList<>();
        int whole = 0;
        for (int k = 0; k < steps.size(); k++) {
            PartByPartPhysics.Step step = steps.get(k);
            prices.add(difference(step.part(), 1 + k, step.in() ? k : whole));
            whole = step.in() ? 1 + k : whole;
        }
        int motion = 1 + steps.size();
        for (Part part : parts) {
            if (part.when() == Part.When.COMMANDS) {
                prices.add(difference(part.name(), motion + 2, motion + 1));
            } else if (part.when() == Part.When.OUTCOME) {
                prices.add(difference(part.name(), motion + 1, motion));
            }
        }
        int flown = whole;
        return new Prices(prices,
            price("", rounds.stream().mapToDouble(nanos -> nanos[flown] - nanos[motion] + nanos[motion + 2]).toArray()),
            rounds.size());
    }

    private Price difference(String part, int more, int less) {
        return price(part, rounds.stream().mapToDouble(nanos -> nanos[more] - nanos[less]).toArray());
    }

    private static Price price(String part, double[] nanos) {
        double median = median(nanos);
        double spread = median(Arrays.stream(nanos).map(each -> Math.abs(each - median)).toArray());
        return new Price(part, median, 2 * OF_MEDIAN * NORMAL * spread / Math.sqrt(nanos.length));
    }

    private static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        return (sorted[(sorted.length - 1) / 2] + sorted[sorted.length / 2]) / 2;
    }
}
