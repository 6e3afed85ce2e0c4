package steward.scene;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import steward.numerics.SplitMix64;
import steward.numerics.StateHash;
import steward.physics.Advance;
import steward.physics.Arena;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.Forces;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.Segment;
import steward.physics.TurnSink;
import steward.physics.Wall;

/**
 * Fingerprint of the physics of a {@link RungLaw}: a hash of computed turns. They are turns of a few bodies and of a
 * crowd, among walls and without, of a tie, and of a heap that rests. It changes when the bits of these turns do.
 */
public final class PhysicsFingerprint {

    private static final long SEED = 4;
    private static final int TURNS = 3;
    private static final int FEW = 5;
    private static final int MANY = 30;
    private static final int PER_ROW = 6;
    private static final double MASSES = 10;
    private static final int MOST_STEPS = 64;
    private static final List<Wall> WALLS =
        Stream.concat(Arrays.stream(Wall.box(2400, 2400, 0.9)),
            Stream.of(new Segment(300, 900, 1500, 1700, 1), new Arena(1200, 1200, 1600, 0.8))).toList();
    private static final List<Forces> FORCES = List.of(Forces.NONE, new Forces(0, 0, 20, 100));
    private static final ImpactLaw SOFT = ImpactLaw.PHYSICS.withRestitution(ImpactLaw.Restitution.MINIMUM);

    private PhysicsFingerprint() { }

    /**
     * Plays the turns of a law on every rung of the ladder that has it, up to {@value #MOST_STEPS} steps.
     *
     * @return 16 hexadecimal digits
     */
    public static String of(RungLaw law) {
        StateHash hash = new StateHash().add(law.ordinal()).add(law.version());
        for (Accuracy rung : Accuracy.ladder()) {
            for (ImpactLaw impacts : List.of(ImpactLaw.OFFICIAL_POD_RACE, ImpactLaw.PHYSICS, SOFT)) {
                if (rung.steps() <= MOST_STEPS) {
                    for (Forces forces : FORCES) {
                        if (RungLaw.of(rung, impacts, forces.act()) == law
                            && (!forces.act() || rung.way() == Accuracy.Way.EVENT && !impacts.separatingPairsReact())) {
                            play(rung, impacts, forces, hash);
                        }
                    }
                }
            }
        }
        return StateHash.toHex(hash.value());
    }

    private static void play(Accuracy rung, ImpactLaw law, Forces forces, StateHash hash) {
        play(rung, law, forces, List.of(), bodies(FEW), hash);
        play(rung, law, forces, WALLS, bodies(FEW), hash);
        play(rung, law, forces, List.of(), tie(), hash);
        if (rung.usesCells(law, MANY)) {
            play(rung, law, forces, WALLS, bodies(MANY), hash);
            if (law.bodiesRest() && forces.act()) {
                play(rung, law, forces, WALLS.subList(0, 4), heap(), hash);
            }
        }
    }

    private static void play(Accuracy rung, ImpactLaw law, Forces forces, List<Wall> walls, Bodies bodies,
                             StateHash hash) {
        Advance advance = rung.advance(new PhysicsParts(law, rung.arithmetic(), new Contacts(1), walls, null, false)
            .withForces(forces), bodies.size());
        for (int turn = 0; turn < TURNS; turn++) {
            for (int k = 0; k < bodies.size() && forces.act(); k++) {
                forces.accelerate(bodies, k, 0, 0);
            }
            advance.turn(bodies, TurnSink.NONE);
            for (int k = 0; k < bodies.size(); k++) {
                hash.add(bodies.x[k]).add(bodies.y[k]).add(bodies.vx[k]).add(bodies.vy[k]);
            }
        }
    }

    /** Bodies near enough to each other that several have impacts in every turn. */
    private static Bodies bodies(int count) {
        SplitMix64 random = new SplitMix64(SEED);
        Bodies bodies = new Bodies(count);
        for (int k = 0; k < count; k++) {
            bodies.add(500 + 300 * (k % PER_ROW) + 90 * random.nextDouble(),
                500 + 320 * (k / PER_ROW) + 90 * random.nextDouble(), 120, k == 2 ? MASSES : 1);
            bodies.setVelocity(k, 1600 * (random.nextDouble() - 0.5), 1600 * (random.nextDouble() - 0.5));
            bodies.setRestitution(k, 0.5 + 0.5 * random.nextDouble());
        }
        return bodies;
    }

    /** Rows of discs that lie on each other in the gaps of the row below: far more contacts than a small heap has. */
    private static Bodies heap() {
        Bodies bodies = new Bodies(MANY);
        for (int k = 0; k < MANY; k++) {
            int row = k / PER_ROW;
            bodies.add(130 + 130 * (row % 2) + 260 * (k % PER_ROW), 2280 - 206 * row, 120, 1 + k % 3);
            bodies.setRestitution(k, 0.5);
        }
        return bodies;
    }

    /** Three discs that meet a fourth at the same time, 21/26, from directions along three Pythagorean triangles. */
    private static Bodies tie() {
        double[][] starts = {{126, 32}, {66, -112}, {0, 130}};
        Bodies bodies = new Bodies(1 + starts.length);
        bodies.add(0, 0, 20, 1);
        for (double[] start : starts) {
            int k = bodies.add(start[0], start[1], 5, 1);
            bodies.setVelocity(k, -start[0], -start[1]);
        }
        return bodies;
    }
}
