package steward.lab.tradeoff;

import java.util.List;
import java.util.function.Supplier;
import steward.lab.trial.PairSampler;
import steward.numerics.SplitMix64;
import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.Wall;
import steward.physics.event.EventAdvance;

/** The scenes of the trade-off that are not games: a dense box, a gas, fast bullets, grazing passes. */
public final class TradeoffWorlds {

    private static final long SEED = 4;
    private static final int ALL_STEPS = 1024;

    /** The sum of two radii in the grazing passes, in u: two pods. */
    private static final double TOUCH = 800;

    private TradeoffWorlds() {
    }

    /** All of them. */
    public static List<TradeoffScene> all() {
        return List.of(denseBox(), gas(), bullets(), grazing());
    }

    /** @throws java.util.NoSuchElementException if there is none of this name */
    public static TradeoffScene named(String name) {
        return all().stream().filter(world -> world.name().equals(name)).findFirst().orElseThrow();
    }

    private static PhysicsParts elastic(Wall... walls) {
        return new PhysicsParts(ImpactLaw.PHYSICS, Arithmetic.DOUBLE, new Contacts(1), List.of(walls), null, false);
    }

    /** 50 of radius 50 cover 60% of their box: the gaps between them are about as wide as the path of a turn. */
    private static TradeoffScene denseBox() {
        double cell = 108;
        return crowd("dense-box", "50 bodies that cover 60% of a box, elastic", 50, 7, cell, 50, 10, 150, 3, 40,
            ALL_STEPS);
    }

    /** 1,000 of radius 10 cover 10% of their box. */
    private static TradeoffScene gas() {
        double cell = Math.sqrt(Math.PI * 100 / 0.1 * 1000 / 1024);
        return crowd("gas", "1,000 bodies that cover 10% of a box, elastic", 1000, 32, cell, 10, 5, 4, 1, 10, 64);
    }

    /** A crowd that flies on by itself; every other turn gives a state. */
    private static TradeoffScene crowd(String name, String about, int count, int perRow, double cell, double radius,
                                       double speed, int states, int freeRuns, int freeTurns, int mostSteps) {
        SplitMix64 random = new SplitMix64(SEED);
        Bodies bodies = new Bodies(count);
        for (int k = 0; k < count; k++) {
            bodies.add((k % perRow + 0.5) * cell, (k / perRow + 0.5) * cell, radius, 1);
            bodies.setVelocity(k, speed * (2 * random.nextDouble() - 1), speed * (2 * random.nextDouble() - 1));
        }
        int rows = (count + perRow - 1) / perRow;
        PhysicsParts parts = elastic(Wall.box(perRow * cell, rows * cell, 1));
        Advance advance = new EventAdvance(parts);
        Supplier<Bodies> source = () -> {
            advance.turn(bodies, TurnSink.NONE);
            advance.turn(bodies, TurnSink.NONE);
            Bodies state = new Bodies(count);
            state.copyFrom(bodies);
            return state;
        };
        return new TradeoffScene(name, about, name, parts, null, source, states, freeRuns, freeTurns, mostSteps);
    }

    /** 10 small bodies fly 2,000 to 4,000 u a turn among 30 big ones; each state is a new world. */
    private static TradeoffScene bullets() {
        double side = 4000;
        SplitMix64 random = new SplitMix64(SEED);
        Supplier<Bodies> source = () -> {
            Bodies bodies = new Bodies(40);
            while (bodies.size() < 30) {
                place(bodies, random, side, 60, 10, 50);
            }
            while (bodies.size() < 40) {
                place(bodies, random, side, 5, 0.1, 2000 + 2000 * random.nextDouble());
            }
            return bodies;
        };
        return new TradeoffScene("bullets", "10 bodies of radius 5 at 2,000 to 4,000 u a turn among 30 of radius 60, "
            + "elastic", "bullets", elastic(Wall.box(side, side, 1)), null, source, 200, 5, 20, ALL_STEPS);
    }

    /** Adds a body at a random free place, if one is found. */
    private static void place(Bodies bodies, SplitMix64 random, double side, double radius, double mass, double speed) {
        double x = radius + (side - 2 * radius) * random.nextDouble();
        double y = radius + (side - 2 * radius) * random.nextDouble();
        for (int k = 0; k < bodies.size(); k++) {
            double dx = x - bodies.x[k];
            double dy = y - bodies.y[k];
            double touch = radius + bodies.radius[k];
            if (dx * dx + dy * dy <= touch * touch) {
                return;
            }
        }
        double ux = 2 * random.nextDouble() - 1;
        double uy = 2 * random.nextDouble() - 1;
        double length = Math.sqrt(ux * ux + uy * uy);
        bodies.setVelocity(bodies.add(x, y, radius, mass), speed * ux / length, speed * uy / length);
    }

    /**
     * Two of two pods' size that pass each other at R (1 - 10^-k) or R (1 + 10^-k), k = 1..16, in any direction; and
     * one state in 17 exactly tangent along an axis, or one unit in the last place to either side.
     */
    private static TradeoffScene grazing() {
        SplitMix64 random = new SplitMix64(SEED);
        Supplier<Bodies> source = () -> {
            int k = 1 + random.nextInt(17);
            if (k == 17) {
                Bodies bodies = new Bodies(2);
                bodies.add(-TOUCH, TOUCH + (random.nextInt(3) - 1) * Math.ulp(TOUCH), TOUCH / 2, 1);
                bodies.add(0, 0, TOUCH / 2, 1);
                bodies.setVelocity(0, 2 * TOUCH, 0);
                return bodies;
            }
            double off = StrictMath.pow(10, -k);
            return PairSampler.passing(random, TOUCH, random.nextInt(2) == 0 ? 1 - off : 1 + off,
                TOUCH * random.nextDouble(), 0.1 + 0.8 * random.nextDouble(),
                16_000 * random.nextDouble(), 9_000 * random.nextDouble());
        };
        return new TradeoffScene("grazing", "two bodies that pass each other at R (1 -+ 10^-k), k = 1..16, or tangent",
            "grazing", elastic(), null, source, 4000, 5, 20, ALL_STEPS);
    }
}
