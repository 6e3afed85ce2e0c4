package steward.physics.event;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.numerics.SplitMix64;
import steward.numerics.StateHash;
import steward.physics.Advance;
import steward.physics.Arena;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.HalfPlane;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.Segment;
import steward.physics.TurnSink;
import steward.physics.Wall;

/**
 * The bits of some hundred turns on every rung, as a hash: the same on every machine, with and without compilers, with
 * and without fused multiply-add. A hash that changes means that replays of that rung no longer verify. Those of
 * the former loop are from before the other rungs existed.
 */
@Execution(ExecutionMode.CONCURRENT)
class GoldenTurnsTest {

    private static final Wall[] ROUND = {new Arena(500, 500, 800, 0.9), new Segment(-100, 300, -50, 700, 0.8),
        new HalfPlane(1100, 500, -0.8, 0.6, 1)};

    /** What replays of formats 1 and 2 were made with: the bits of the first versions, without Rest and sliding. */
    @ParameterizedTest
    @CsvSource({"OFFICIAL, 8bc29d7d532b04e2", "DOUBLE, 3f6b3f7615033975", "COMPENSATED, d23e6197b1543e80",
        "EXACT, 68cc4f5c85119c46"})
    void theFormerLoopKeepsItsBits(String rung, String hash) {
        assertEquals(hash, StateHash.toHex(hashOf(rung, EventAdvance::ofFormerReplays)));
    }

    @ParameterizedTest
    @CsvSource({"OFFICIAL, 79af0b36f6a47462", "DOUBLE, e3cdbd8048cd4845",
        "COMPENSATED, 75103241c311d69b", "EXACT, 58e2f7dfdcf72eaa",
        "1, 2efd30f75f0e7563", "4, 6eb7aae784363f7e",
        "7, 1a0a62c444722422", "64, 3b3e578dcb3bb16a"})
    void everyRungHasItsBits(String rung, String hash) {
        assertEquals(hash, StateHash.toHex(hashOf(rung, EventAdvance::new)));
    }

    /** Central impacts of equal masses, which left some 1e-30; the hash is that of the former loop itself. */
    @Test
    void theFormerLoopKeepsWhatCentralImpactsLeftOnTheExactRung() {
        Advance advance = EventAdvance.ofFormerReplays(new PhysicsParts(ImpactLaw.PHYSICS, Arithmetic.EXACT));
        SplitMix64 random = new SplitMix64(5);
        StateHash hash = new StateHash();
        for (int n = 0; n < 300; n++) {
            Bodies bodies = new Bodies(2);
            double radius = 1 + 499 * random.nextDouble();
            double x = 1000 * random.nextDouble();
            bodies.add(x, 968, radius, 1);
            bodies.add(x + 2 * radius + (n % 3 == 0 ? 0 : random.nextDouble()), 968, radius, 1);
            bodies.setVelocity(0, 1 + random.nextDouble(), n % 2 == 0 ? 0 : 1e-15 * random.nextDouble());
            advance.turn(bodies, TurnSink.NONE);
            for (int k = 0; k < 2; k++) {
                hash.add(bodies.x[k]).add(bodies.y[k]).add(bodies.vx[k]).add(bodies.vy[k]);
            }
        }
        assertEquals("f835a3e0f22d519d", StateHash.toHex(hash.value()));
    }

    private static long hashOf(String rung, Function<PhysicsParts, Advance> loop) {
        StateHash hash = new StateHash();
        play(rung, loop, ImpactLaw.OFFICIAL_POD_RACE, 4, hash);
        play(rung, loop, ImpactLaw.PHYSICS, 16, hash, Wall.box(1000, 1000, 1));
        play(rung, loop, Scenes.WITH_RESTITUTION, 9, hash, ROUND);
        return hash.value();
    }

    private static void play(String rung, Function<PhysicsParts, Advance> loop, ImpactLaw law, int count,
                             StateHash hash, Wall... walls) {
        boolean steps = Character.isDigit(rung.charAt(0));
        PhysicsParts parts = new PhysicsParts(law, steps ? Arithmetic.DOUBLE : Arithmetic.valueOf(rung),
            new Contacts(1), List.of(walls), null, true);
        Advance advance = steps ? new StepAdvance(parts, Integer.parseInt(rung)) : loop.apply(parts);
        for (long seed = 1; seed <= 10; seed++) {
            Bodies bodies = Scenes.grid(new SplitMix64(seed), (int) Math.sqrt(count), 1000, 90, 700);
            for (int k = 0; k < count; k++) {
                bodies.setRestitution(k, 0.5 + k % 3 / 4.0);
            }
            for (int turn = 0; turn < 5; turn++) {
                advance.turn(bodies, TurnSink.NONE);
                for (long bits : Scenes.bits(bodies)) {
                    hash.add(bits);
                }
            }
        }
    }
}
