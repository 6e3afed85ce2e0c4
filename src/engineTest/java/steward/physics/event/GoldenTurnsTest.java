package steward.physics.event;

import static org.junit.jupiter.api.Assertions.assertEquals;

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
import steward.physics.HalfPlane;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.Segment;
import steward.physics.TurnSink;
import steward.physics.Wall;

/**
 * The bits of some hundred turns on every rung, as a hash: the same on every machine, with and without compilers, with
 * and without fused multiply-add. A hash that changes means that replays of that rung no longer verify.
 */
@Execution(ExecutionMode.CONCURRENT)
class GoldenTurnsTest {

    private static final Wall[] ROUND = {new Arena(500, 500, 800, 0.9), new Segment(-100, 300, -50, 700, 0.8),
        new HalfPlane(1100, 500, -0.8, 0.6, 1)};

    @ParameterizedTest
    @CsvSource({"OFFICIAL, ddbbc5972d875626", "DOUBLE, b4ab7a0323db7377",
        "COMPENSATED, 53b0c0aad04b9ba4", "EXACT, 39444827e566a939",
        "1, 2efd30f75f0e7563", "4, 6eb7aae784363f7e",
        "7, 1a0a62c444722422", "64, 3b3e578dcb3bb16a"})
    void everyRungHasItsBits(String rung, String hash) {
        assertEquals(hash, StateHash.toHex(hashOf(rung)));
    }

    private static long hashOf(String rung) {
        StateHash hash = new StateHash();
        play(rung, ImpactLaw.OFFICIAL_POD_RACE, 4, hash);
        play(rung, ImpactLaw.PHYSICS, 16, hash, Wall.box(1000, 1000, 1));
        play(rung, Scenes.WITH_RESTITUTION, 9, hash, ROUND);
        return hash.value();
    }

    private static void play(String rung, ImpactLaw law, int count, StateHash hash, Wall... walls) {
        boolean steps = Character.isDigit(rung.charAt(0));
        PhysicsParts parts = Scenes.parts(law, steps ? Arithmetic.DOUBLE : Arithmetic.valueOf(rung), walls);
        Advance advance = steps ? new StepAdvance(parts, Integer.parseInt(rung)) : new EventAdvance(parts);
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
