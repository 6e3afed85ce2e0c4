package steward.scene;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import steward.Internal;
import steward.numerics.SplitMix64;
import steward.numerics.StateHash;
import steward.physics.Advance;
import steward.physics.Arena;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.Segment;
import steward.physics.TurnSink;
import steward.physics.Wall;

/**
 * The version of the physics, from its results: a hash of turns of a few bodies on every rung, under two laws, one of
 * them with walls. It changes exactly when the bits of a result change; figures measured with another fingerprint are
 * out of date.
 */
@Internal
public final class PhysicsFingerprint {

    private static final long SEED = 4;
    private static final int TURNS = 3;
    private static final int BODIES = 5;
    private static final double MASSES = 10;
    private static final List<Wall> WALLS =
        Stream.concat(Arrays.stream(Wall.box(2400, 2400, 0.9)),
            Stream.of(new Segment(300, 900, 1500, 1700, 1), new Arena(1200, 1200, 1600, 0.8))).toList();

    private PhysicsFingerprint() {
    }

    /** 16 hexadecimal digits. */
    public static String text() {
        return StateHash.toHex(value());
    }

    private static long value() {
        StateHash hash = new StateHash();
        ImpactLaw soft = ImpactLaw.PHYSICS.withRestitution(ImpactLaw.Restitution.MINIMUM);
        for (Accuracy rung : Accuracy.ladder()) {
            play(rung, ImpactLaw.OFFICIAL_POD_RACE, List.of(), hash);
            play(rung, soft, WALLS, hash);
        }
        return hash.value();
    }

    private static void play(Accuracy rung, ImpactLaw law, List<Wall> walls, StateHash hash) {
        Advance advance = rung.advance(
            new PhysicsParts(law, rung.arithmetic(), new Contacts(1), walls, null, false));
        Bodies bodies = closeBodies(new SplitMix64(SEED));
        for (int turn = 0; turn < TURNS; turn++) {
            advance.turn(bodies, TurnSink.NONE);
            for (int k = 0; k < bodies.size(); k++) {
                hash.add(bodies.x[k]).add(bodies.y[k]).add(bodies.vx[k]).add(bodies.vy[k]);
            }
        }
    }

    /** Bodies near enough to each other that several have impacts in every turn. */
    private static Bodies closeBodies(SplitMix64 random) {
        Bodies bodies = new Bodies(BODIES);
        for (int k = 0; k < BODIES; k++) {
            bodies.add(900 + 300 * (k % 3) + 90 * random.nextDouble(), 900 + 320 * (k / 3) + 90 * random.nextDouble(),
                120, k == 2 ? MASSES : 1);
            bodies.setVelocity(k, 1600 * (random.nextDouble() - 0.5), 1600 * (random.nextDouble() - 0.5));
            bodies.setRestitution(k, 0.5 + 0.5 * random.nextDouble());
        }
        return bodies;
    }
}
