package steward.lab.stability.crowds;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.lab.oracle.FirstInstant;
import steward.lab.trial.Rung;
import steward.match.TestSize;
import steward.numerics.SplitMix64;
import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.TurnLog;
import steward.physics.Wall;

/** The rule of ties on {@code exact}, against decimals of 140 digits. */
@Execution(ExecutionMode.CONCURRENT)
class SimultaneousImpactsTest {

    private static final Rung EXACT =
        Rung.all().stream().filter(rung -> rung.arithmetic() == Arithmetic.EXACT).findFirst().orElseThrow();

    private static List<String> play(Advance advance, Bodies bodies) {
        TurnLog log = new TurnLog();
        advance.turn(bodies, log);
        List<String> impacts = new ArrayList<>();
        for (int k = 0; k < log.impacts(); k++) {
            impacts.add(log.impact(k).a() + " " + log.impact(k).b());
        }
        return impacts;
    }

    /** Three discs fly to a fourth along triples of 130; all meet it at t = 105/130 = 21/26. */
    private static Bodies threeAtOne() {
        int[][] discs = {{0, 0, 20}, {126, 32, 5}, {66, -112, 5}, {0, 130, 5}};
        Bodies bodies = new Bodies(discs.length);
        for (int[] disc : discs) {
            bodies.setVelocity(bodies.add(disc[0], disc[1], disc[2], 1), -disc[0], -disc[1]);
        }
        return bodies;
    }

    @Test
    void threeThatMeetAFourthReactInTheOrderOfIds() {
        assertEquals(List.of("0 1", "0 2", "0 3"), new FirstInstant(threeAtOne(), List.of()).impacts());
        assertEquals(List.of("0 1", "0 2", "0 3"),
            play(EXACT.advance(ImpactLaw.PHYSICS), threeAtOne()).subList(0, 3));
    }

    @Test
    @Tag("slow")
    @Tag("sized")
    void everyTieReactsByTheRule() {
        int worlds = TestSize.of(150, 1_000);
        SplitMix64 random = new SplitMix64(4);
        int several = 0;
        for (int n = 0; n < worlds; n++) {
            String seed = "seed 4, world " + n;
            TiedWorlds.World world = TiedWorlds.draw(random);
            several += world.impacts().size() > 2 ? 1 : 0;
            Wall[] walls = world.walls().toArray(new Wall[0]);
            Bodies one = world.bodies().copy();
            Bodies crowd = world.bodies().copy();
            List<String> impacts = play(EXACT.advance(ImpactLaw.PHYSICS, walls), one);
            assertTrue(impacts.size() >= world.impacts().size(), seed);
            assertEquals(world.impacts(), impacts.subList(0, world.impacts().size()), seed);
            assertEquals(impacts, play(EXACT.crowdAdvance(ImpactLaw.PHYSICS, walls), crowd), seed);
            assertArrayEquals(one.vx, crowd.vx, seed);
            assertArrayEquals(one.x, crowd.x, seed);
        }
        assertTrue(several > worlds / 4, several + " worlds with three impacts or more");
    }
}
