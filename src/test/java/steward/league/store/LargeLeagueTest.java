package steward.league.store;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Pairing;
import steward.league.Schedule;
import steward.league.Season;
import steward.league.pairing.AdaptivePairing;
import steward.league.pairing.KnownResults;
import steward.league.pairing.Looks;
import steward.league.pairing.StopRule;
import steward.league.rating.LeagueTable;
import steward.league.rating.Ratings;
import steward.schema.PublishedTable;

/** Leagues of made-up games are whole at any size; what they cost goes into {@code docs/tables/leagues.md}. */
@Tag("campaign")
class LargeLeagueTest {

    private static final Season SEASON = GameStoreTest.SEASON;
    private static final int BOTS = 10;
    private static final int GAMES_A_BOT = 200;
    private static final double MS = 1e-6;

    @TempDir
    private Path folder;

    private final List<String> lines = new ArrayList<>();

    @Test
    void largeLeaguesAreStoredRatedAndResumed() throws IOException {
        lines.add("| games of " + BOTS + " bots | stored | opened and rated | resumed | resumed, adaptive | a game |");
        lines.add("|---:|---:|---:|---:|---:|---:|");
        for (int games = 1000; games <= 1_000_000; games *= 10) {
            grow(new LeagueFolder(Files.createDirectory(folder.resolve("made-" + games))), games);
        }
        lines.add("");
        lines.add("| bots, " + GAMES_A_BOT + " games each | table |");
        lines.add("|---:|---:|");
        for (int bots : new int[] {10, 30, 100, 300, 1000}) {
            rate(new LeagueFolder(Files.createDirectory(folder.resolve("field-" + bots))), bots);
        }
        PublishedTable.write("leagues.md", "leagues", lines);
    }

    private void grow(LeagueFolder league, int games) throws IOException {
        long began = System.nanoTime();
        int number = fill(league, BOTS, games);
        String stored = since(began);
        began = System.nanoTime();
        try (GameStore store = GameStore.read(league)) {
            assertEquals(games, table(store, number).results().games());
        }
        String rated = since(began);
        String[] resumed = new String[2];
        for (int adaptive = 0; adaptive < 2; adaptive++) {
            began = System.nanoTime();
            try (GameStore store = GameStore.read(league)) {
                assertEquals(games / 2, next(store, new GameQueries(store, number, SEASON), adaptive == 1));
            }
            resumed[adaptive] = since(began);
        }
        lines.add(String.format(Locale.ROOT, "| %,d | %s | %s | %s | %s | %d bytes |", games, stored, rated,
            resumed[0], resumed[1], Files.size(league.database()) / games));
    }

    private void rate(LeagueFolder league, int bots) {
        int number = fill(league, bots, GAMES_A_BOT * bots);
        try (GameStore store = GameStore.read(league)) {
            long began = System.nanoTime();
            assertEquals(bots, table(store, number).rows().size());
            lines.add(String.format(Locale.ROOT, "| %,d | %s |", bots, since(began)));
        }
    }

    private static int fill(LeagueFolder league, int bots, int games) {
        try (GameStore store = GameStore.write(league)) {
            int number = store.open(SEASON);
            new MadeUpGames(store, number, SEASON, MadeUpGames.bots(store, bots), new SplittableRandom(1)).add(games);
            return number;
        }
    }

    private static LeagueTable table(GameStore store, int number) {
        return LeagueTable.of(new GameQueries(store, number, SEASON).results(), store.versions().stream()
            .map(version -> new LeagueTable.Entry(version.id(), version.display(), false, true)).toList());
    }

    /** The first decision of a run that goes on. */
    private static int next(GameStore store, GameQueries queries, boolean adaptive) {
        int lag = LeagueSettings.USUAL_LAG;
        List<Integer> playing = store.versions().stream().map(GameStore.Version::id).toList();
        Schedule schedule = MadeUpGames.schedule(queries, playing);
        if (adaptive) {
            int settled = Looks.settled(queries.nextDecision(), lag);
            KnownResults known = queries.known(settled);
            schedule.play(playing, versions -> new AdaptivePairing(versions, 2, lag, StopRule.NONE,
                before -> Ratings.of(known.before(before), versions)));
        } else {
            schedule.play(playing, versions -> Pairing.roundRobin(versions, 2));
        }
        return schedule.decide(Long.MAX_VALUE, 1).made().get(0).number();
    }

    private static String since(long began) {
        return String.format(Locale.ROOT, "%,.0f ms", MS * (System.nanoTime() - began));
    }
}
