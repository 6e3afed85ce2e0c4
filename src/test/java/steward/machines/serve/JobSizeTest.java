package steward.machines.serve;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** How many games go together. */
class JobSizeTest {

    private static final long MS = 1_000_000;

    private final JobSize size = new JobSize();

    @Test
    void gamesOfWhichNothingIsKnownGoOneByOne() {
        assertEquals(1, size.games(32));
    }

    @Test
    void asManyGoTogetherAsTakeHalfASecond() {
        size.played("one", 4, 400 * MS);
        assertEquals(5, size.games(32));
        assertEquals(3, size.games(3));
        assertEquals(1, size.games(0));
        size.played("one", 5, 4_500 * MS);
        assertEquals(2, size.games(32), "(100 + (900 - 100) / 8) ms each");
    }

    @Test
    void veryShortGamesDoNotGoTogetherWithoutEnd() {
        size.played("one", 1, 0);
        assertEquals(32, size.games(1000));
    }

    @Test
    void whereGamesTakeLongestDecides() {
        size.played("slow", 1, 300 * MS);
        size.played("fast", 32, 32 * MS);
        assertEquals(1, size.games(32));
        size.forget("slow");
        assertEquals(32, size.games(32));
        size.forget("fast");
        assertEquals(1, size.games(32));
    }
}
