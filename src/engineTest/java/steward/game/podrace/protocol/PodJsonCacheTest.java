package steward.game.podrace.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodState;
import steward.game.podrace.Races;
import steward.numerics.SplitMix64;

/** Text that is spelled once and copied is the text that would be spelled now. */
class PodJsonCacheTest {

    private final PodRace race = Races.official(Races.FAR);
    private final PodJsonCache texts = new PodJsonCache(race);

    private static final PodState[] STATES = {
        new PodState(1, 2, 3, 4, 0.5, 0, true, 0),
        new PodState(1.5, 2, 3, 4, 0.5, 0, true, 0),
        new PodState(1, 2.5, 3, 4, 0.5, 0, true, 0),
        new PodState(1, 2, -0.0, 4, 0.5, 0, true, 0),
        new PodState(1, 2, 0.0, 4, 0.5, 0, true, 0),
        new PodState(1, 2, 3, -4, 0.5, 0, true, 0),
        new PodState(1, 2, 3, 4, Double.NaN, 0, true, 0),
        new PodState(1, 2, 3, 4, 0.5, 4, true, 0),
        new PodState(1, 2, 3, 4, 0.5, 0, false, 0),
        new PodState(1, 2, 3, 4, 0.5, 0, true, 1),
        new PodState(1, 2, 3, 4, 0.5, 0, true, 7)};

    /** Whatever changes, and whoever looks first. */
    @Test
    void afterAnyChangeAllIsSpelledAnew() {
        SplitMix64 random = new SplitMix64(5);
        for (int k = 0; k < 20_000; k++) {
            PodState state = STATES[(int) Math.floorMod(random.nextLong(), (long) STATES.length)];
            race.setPod(2, state);
            PodJsonCache fresh = new PodJsonCache(race);
            switch ((int) Math.floorMod(random.nextLong(), 4L)) {
                case 0 -> assertEquals(fresh.view(2, true).getValue(), texts.view(2, true).getValue());
                case 1 -> assertEquals(fresh.view(2, false).getValue(), texts.view(2, false).getValue());
                case 2 -> assertEquals(fresh.state(2).getValue(), texts.state(2).getValue());
                default -> assertEquals(fresh.view(1, true).getValue(), texts.view(1, true).getValue());
            }
        }
    }

    @Test
    void theOwnerSeesMore() {
        race.setPod(2, STATES[7]);

        assertEquals("{\"id\":2,\"player\":1,\"x\":1,\"y\":2,\"vx\":3,\"vy\":4,\"heading\":28.64788975654116,"
            + "\"nextCheckpoint\":1,\"lap\":0}", texts.view(2, false).getValue());
        assertEquals("{\"id\":2,\"player\":1,\"x\":1,\"y\":2,\"vx\":3,\"vy\":4,\"heading\":28.64788975654116,"
            + "\"nextCheckpoint\":1,\"lap\":0,\"shieldTimer\":4,\"boostLeft\":true}", texts.view(2, true).getValue());
        assertEquals("{\"id\":2,\"player\":1,\"x\":1,\"y\":2,\"vx\":3,\"vy\":4,\"heading\":0.5,"
            + "\"shieldTimer\":4,\"boostLeft\":true,\"passed\":0}", texts.state(2).getValue());
    }

    /** A number that cannot be written is no reason to say something old the next time. */
    @Test
    void aDamagedStateLeavesNothingBehind() {
        race.setPod(2, STATES[0]);
        String good = texts.view(2, true).getValue();
        race.setPod(2, STATES[1]);
        assertNotEquals(good, texts.view(2, true).getValue());
        race.bodies().vx[2] = Double.NaN;
        assertThrows(IllegalStateException.class, () -> texts.view(2, true));
        race.setPod(2, STATES[0]);
        assertEquals(good, texts.view(2, true).getValue());
    }

    @Test
    void commandsAreSpelled() {
        race.command(2, 1.5, -2, 100);
        race.command(3, 0, -0.0, PodRace.SHIELD);
        assertEquals("[{\"x\":1.5,\"y\":-2,\"thrust\":100},{\"x\":0,\"y\":-0.0,\"shield\":true}]",
            texts.command(1).getValue());
        race.command(2, 1, 1, PodRace.BOOST);
        race.command(3, 1e7, 1e-3, 0);
        assertEquals("[{\"x\":1,\"y\":1,\"boost\":true},{\"x\":10000000,\"y\":0.001,\"thrust\":0}]",
            texts.command(1).getValue());
        assertSame(texts.command(0), texts.command(1), "nothing is made anew");
    }
}
