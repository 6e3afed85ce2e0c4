package steward.machines.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import steward.league.StoredGame;
import steward.league.StoredGame.StoredSeat;

/** Who is called doubtful: made-up games of bots that draw by lot. */
class WorkerBookTest {

    private static final long SEED = Long.getLong("steward.seed", 22);
    private static final long MS = 1_000_000;
    private static final Kind HONEST = new Kind(0.3, 0.02, 1);

    /** How a worker's games are. */
    private record Kind(double weakWins, double fails, double slower) {
    }

    /** A game between bot 1, the weak one, and bot 2; in either seat. */
    private static StoredGame game(String machine, Kind kind, SplittableRandom random) {
        boolean wins = random.nextDouble() < kind.weakWins;
        StoredSeat weak = seat(1, wins, kind, random);
        StoredSeat strong = seat(2, !wins, kind, random);
        return new StoredGame(0, new byte[16], 0, random.nextLong(), 1, true, 50, null, 0, machine, null, 0,
            random.nextBoolean() ? List.of(strong, weak) : List.of(weak, strong));
    }

    private static StoredSeat seat(int version, boolean wins, Kind kind, SplittableRandom random) {
        long nanos = Math.round((1 + random.nextDouble()) * kind.slower * MS);
        return new StoredSeat(version, wins ? 0 : 1, wins ? 1 : 0, random.nextDouble() < kind.fails ? "timeout" : null,
            50, nanos, nanos, nanos);
    }

    /** The doubts about worker "x" after so many games of its own, and as many of each of three others. */
    private static List<String> doubts(Kind kind, int games, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        WorkerBook book = new WorkerBook(version -> version == 1 ? "weak" : "strong");
        for (int k = 0; k < games; k++) {
            for (String machine : List.of("worker a: m", "Java 17, here", "worker b: m")) {
                book.add(game(machine, HONEST, random));
            }
            book.add(game("worker x: m", kind, random));
        }
        return book.lines().stream().filter(line -> line.name().equals("x")).findFirst().orElseThrow().doubts();
    }

    /** Chance of draws, each told as how many there are, how many have the mark, are taken, and are taken with it. */
    private static double chance(int[]... draws) {
        DrawnWithout drawn = new DrawnWithout();
        for (int[] draw : draws) {
            drawn.add(draw[0], draw[1], draw[2], draw[3]);
        }
        return drawn.chance();
    }

    /** R. A. Fisher's tea: of 8 cups 4 are marked, 4 are taken, all of them right: 1 in 70 one way, and the other. */
    @Test
    void theChanceIsExact() {
        int[] tea = {8, 4, 4, 4};
        assertEquals(2.0 / 70, chance(tea), 1e-15);
        // Two tables of it: only both right is as extreme, 1 in 4900.
        assertEquals(2.0 / 4900, chance(tea, tea), 1e-17);
        assertEquals(1, chance(new int[] {8, 4, 4, 2}));
        assertEquals(1, chance(new int[] {5, 5, 3, 3}), "all have the mark: nothing can be told");
    }

    /**
     * More than 4,000 different sums: the normal distribution takes over. Of 10,000 of 20,000, where half have the
     * mark, the standard deviation is sqrt(10,000 / 4 * 10,000 / 19,999) = 35.4: 600 more than 5,000 are 17 of them.
     */
    @Test
    void manyGamesAreMeasuredByTheNormalDistribution() {
        assertEquals(1, chance(new int[] {20_000, 10_000, 10_000, 5000}));
        double wide = chance(new int[] {20_000, 10_000, 10_000, 5600});
        assertTrue(wide < 1e-60 && wide > 0, () -> "found " + wide);
        // Where both can be computed they agree: 3990 of 15,960 below, 3.5 deviations up.
        int[] both = {15_960, 3990, 3990, 1090};
        double exact = chance(both);
        assertEquals(exact, chance(both, new int[] {1_000_000, 999_999, 11, 11}, new int[] {11, 11, 10, 10}),
            1e-3 * exact, "games that say nothing change nothing");
    }

    /** At most 1 in 100 by construction; 11 or more of 300 would come by chance once in some thousand. */
    @Test
    @Tag("slow")
    void honestWorkersAreSeldomDoubtful() {
        int found = 0;
        for (int league = 0; league < 300; league++) {
            found += doubts(HONEST, 160, SEED + league).isEmpty() ? 0 : 1;
        }
        int count = found;
        assertTrue(found < 11, () -> "doubtful in " + count + " of 300 leagues, seed " + SEED);
    }

    /** Half of all games are forged: beside them honest ones are the exception, until they leave the comparison. */
    @Test
    void honestWorkersAreNoMoreDoubtfulWhenTheForgersGamesAreSuspended() {
        for (boolean suspended : new boolean[] {false, true}) {
            SplittableRandom random = new SplittableRandom(SEED);
            WorkerBook book = new WorkerBook(Integer::toString);
            for (int k = 0; k < 80; k++) {
                StoredGame forged = game("worker x: m", new Kind(1, 0.02, 1), random);
                book.add(!suspended ? forged : new StoredGame(0, forged.name(), 0, forged.seed(), 1, false, 50,
                    StoredGame.SUSPENDED + "why", 0, forged.machine(), null, 0, forged.seats()));
                book.add(game("worker a: m", HONEST, random));
            }
            WorkerBook.Line honest = book.lines().get(0);
            assertEquals(suspended, honest.doubts().isEmpty(), () -> honest + ", seed " + SEED);
            assertEquals(suspended ? 80 : 0, book.lines().get(1).aside());
            assertEquals(suspended, book.lines().get(1).suspended());
        }
    }

    @Test
    void aWorkerThatLetsTheWeakBotWinIsNamedAfterFortyGames() {
        List<String> doubts = doubts(new Kind(1, 0.02, 1), 40, SEED);
        assertTrue(doubts.stream().anyMatch(doubt -> doubt.matches(
            "weak in seat [12] had nobody ahead of it in (\\d+) of \\1 games, elsewhere in \\d+ of \\d+ "
                + "\\(p = .*e-.*\\)")), () -> doubts + ", seed " + SEED);
    }

    @Test
    void aWorkerOnWhichBotsFailOrAreSlowIsNamed() {
        List<String> failing = doubts(new Kind(0.3, 0.6, 1), 80, SEED);
        assertTrue(failing.stream().anyMatch(doubt -> doubt.contains(" failed in ")), failing::toString);
        List<String> slow = doubts(new Kind(0.3, 0.02, 3), 80, SEED);
        assertTrue(slow.stream().anyMatch(doubt -> doubt.contains(" took longer than the median to answer in ")),
            slow::toString);
        assertEquals(List.of(), doubts(new Kind(0.3, 0.02, 1.4), 80, SEED), "machines may differ a little");
    }

    @Test
    void gamesSetAsideAndPlayedAgainAreCountedApart() {
        SplittableRandom random = new SplittableRandom(SEED);
        WorkerBook book = new WorkerBook(Integer::toString);
        StoredGame first = game("worker y: m", HONEST, random);
        for (int k = 0; k < 3; k++) {
            book.add(game("worker y: m", HONEST, random));
        }
        for (String problem : new String[] {StoredGame.SET_ASIDE + "worker y was caught", null}) {
            book.add(new StoredGame(9, first.name(), -1, 1, 1, false, 5, problem, 0, "worker y: m", null, 0,
                first.seats()));
        }
        book.add(game("Java 17, here", HONEST, random));
        assertEquals(1, book.lines().size());
        WorkerBook.Line line = book.lines().get(0);
        assertEquals("y 3 1 1", line.name() + " " + line.games() + " " + line.aside() + " " + line.repeated());
    }
}
