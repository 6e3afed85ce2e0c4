package steward.league.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.league.GameName;
import steward.league.LeagueFolder;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.StoredGame.StoredSeat;
import steward.league.pairing.KnownResults;
import steward.league.pairing.Looks;
import steward.league.rating.Difference;
import steward.league.rating.Ratings;
import steward.league.store.GameStore.Version;

/** A league that goes on knows of its earlier games what it would if it had not been interrupted, to the bit. */
class ResumedResultsTest {

    private static final int LAG = 16;

    @TempDir
    private Path path;

    private static StoredGame game(Season season, int decision, int seat, SplittableRandom random, List<Version> bots) {
        List<String> identities = bots.stream().map(Version::identity).toList();
        List<StoredSeat> seats = new ArrayList<>();
        int[] ranks = new int[bots.size()];
        for (int k = 0; k < ranks.length; k++) {
            ranks[k] = random.nextInt(ranks.length);
        }
        for (int k = 0; k < ranks.length; k++) {
            seats.add(new StoredSeat(bots.get(k).id(), ranks[k], random.nextInt(3), null, 5, 100, 900, 5000));
        }
        return new StoredGame(0, GameName.of(season, decision, identities, seat + 1), decision, decision, 1,
            true, 50, null, 1000, "here", null, 0, seats);
    }

    /** Decisions in which each bot has each seat; of decision 700 a game is missing, decision 900 has none. */
    private static void play(GameStore store, int number, Season season, List<Version> bots) {
        SplittableRandom random = new SplittableRandom(5);
        List<StoredGame> games = new ArrayList<>();
        for (int decision = 0; decision < 1000; decision++) {
            List<Version> group = new ArrayList<>(bots);
            while (group.size() > season.players()) {
                group.remove(random.nextInt(group.size()));
            }
            for (int seat = 0; seat < group.size() && decision != 900; seat++) {
                group.add(group.remove(0));
                if (decision != 700 || seat > 0) {
                    games.add(game(season, decision, seat, random, group));
                }
            }
            if (season.players() == 1) {
                games.add(game(season, decision, 5, random, List.of(bots.get(1))));
            }
        }
        MadeUpGames.add(store, number, games);
    }

    @Test
    @Tag("slow")
    void resultsThatAreReadTogetherAreThoseThatAreReadOneByOne() throws IOException {
        for (int players = 1; players <= 3; players++) {
            Season season = Season.of("crowd", "key", "limits", "rules", players, false);
            Path folder = Files.createDirectory(path.resolve("of" + players));
            try (GameStore store = GameStore.write(new LeagueFolder(folder))) {
                int number = store.open(season);
                List<Version> bots = MadeUpGames.bots(store, 4);
                play(store, number, season, bots);
                GameQueries queries = new GameQueries(store, number, season);
                assertEquals(1000, queries.nextDecision());
                int settled = Looks.settled(900, LAG);
                assertTrue(settled > 800, settled + "");
                KnownResults one = queries.known(0);
                KnownResults other = queries.known(settled);
                List<Integer> versions = bots.stream().map(Version::id).toList();
                for (int before : new int[] {settled, settled + 3, 1000}) {
                    Ratings found = Ratings.of(other.before(before), versions);
                    Ratings expected = Ratings.of(one.before(before), versions);
                    for (int bot : versions) {
                        Difference difference = expected.difference(1, bot);
                        assertEquals(difference, found.difference(1, bot), players + " players, " + before);
                        assertTrue(bot == 1 || difference.elo() != 0, "there is something to know");
                    }
                }
            }
        }
    }

    @Test
    void nothingBelowTheSettledDecisionIsAskedForAgain() {
        for (int first = 0; first < 5000; first++) {
            for (int decision = first; decision < first + 200; decision++) {
                assertTrue(Looks.of(decision) - LAG + 1 >= Looks.settled(first, LAG) || decision < LAG);
            }
        }
    }
}
