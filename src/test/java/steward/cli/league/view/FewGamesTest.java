package steward.cli.league.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.cli.Cli;
import steward.cli.streams.Colour;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Season;
import steward.league.page.EmbeddedReplays;
import steward.league.page.LeaguePage;
import steward.league.page.LeagueView;
import steward.league.rating.LeagueTable;
import steward.league.rating.RatingPath;
import steward.league.rating.Results;
import steward.league.store.MadeUpGames;
import steward.match.TestSize;

/** A league that has just begun, in all its forms: a bar of which nothing is known is no number. */
@Execution(ExecutionMode.CONCURRENT)
class FewGamesTest {

    private static final Season SEASON = Season.of("duel", "key", "limits", "rules", 2, false);

    @TempDir
    private Path folder;

    private static List<LeagueTable.Entry> entries(int bots) {
        return IntStream.rangeClosed(1, bots)
            .mapToObj(version -> new LeagueTable.Entry(version, "bot-" + version, false, true)).toList();
    }

    /** Both games of a seed, all won by the first. */
    private static void won(Results results, long seed, int winner, int loser) {
        results.addGame(seed, new int[] {winner, loser}, 0, 1);
        results.addGame(seed, new int[] {loser, winner}, 1, 0);
        for (int version : new int[] {winner, loser}) {
            results.addSums(version, 2, 0, 0, 2, 2e6, 1_000_000);
        }
    }

    /** 1 has played 2, and 3 has played 4: nothing tells how the two pairs compare. Then more, and more again. */
    private static List<Results> beginnings() {
        List<Results> all = new ArrayList<>();
        for (int seeds : new int[] {0, 1, 2, 9}) {
            Results results = new Results(SEASON);
            for (int seed = 0; seed < seeds; seed++) {
                won(results, seed, 1, 2);
                won(results, seed, 3, 4);
            }
            all.add(results);
        }
        return all;
    }

    @Test
    void aRoundThatHasBegunWithOneGameIsNotComplete() {
        Results results = new Results(SEASON);
        won(results, 1, 1, 2);
        won(results, 2, 1, 3);
        won(results, 3, 2, 3);
        LeagueSettings settings = LeagueSettings.usual("duel", 1);
        assertEquals(Optional.empty(), RoundText.unfinished(LeagueTable.of(results, entries(3)), settings, 2));
        results.addGame(4, new int[] {1, 2}, 0, 1);
        assertEquals(Optional.of("Round 2 is not complete: 0 of 3 pairs have met in it."),
            RoundText.unfinished(LeagueTable.of(results, entries(3)), settings, 2));
    }

    @Test
    @Tag("slow")
    void everyFormHasNumbersOrNothing() throws IOException {
        for (Results results : beginnings()) {
            List<LeagueTable.Entry> entries = entries(5);
            LeagueTable table = LeagueTable.of(results, entries);
            RatingPath.Collector path = new RatingPath.Collector(entries, LeagueTable.Reference.NONE);
            path.take(results);
            path.take(results);
            String text = String.join("\n", TableText.whole(table, SEASON, List.of(), Colour.NONE));
            assertFalse(Pattern.compile("9999|\\d{5}|Infinity|NaN|∞").matcher(text).find(), text);
            String html = new String(LeaguePage.of(new LeagueView(SEASON, table, path.path(), List.of(), Double.NaN,
                List.of()), folder, EmbeddedReplays.of(List.of(), folder, null, null, any -> ""), "few"),
                StandardCharsets.UTF_8);
            String data = html.substring(html.indexOf("{\"scene\":"));
            data = data.substring(0, data.indexOf("</script>"));
            assertFalse(Pattern.compile("Infinity|NaN|9999").matcher(data).find(), data);
        }
    }

    @Test
    @Tag("slow")
    @Tag("sized")
    void theCommandsSayNothingOfWhatIsNotKnown() {
        for (int games = 1; games <= TestSize.of(2, 6); games++) {
            String league = folder.resolve("league" + games).toString();
            done("init", league, "--scene", "duel", "--seed", "1");
            MadeUpGames.fill(new LeagueFolder(Path.of(league)), games, 4);
            for (String[] form : new String[][] {{}, {"--json"}, {"--csv"}}) {
                String out = done(Cli.words(List.of("table", league), form));
                assertFalse(Pattern.compile("Infinity|NaN|9999|\\d{19}").matcher(out.replaceAll("seed.*", "")).find(),
                    out);
            }
            done("page", league, "--out", folder.resolve("page" + games + ".html").toString());
        }
    }

    private String done(String... words) {
        return Cli.league(folder, words).done().out();
    }

    /** Residuals beside ratings are told only where the two shares can be told apart. */
    @Test
    @Tag("slow")
    void noBotBeatsAnotherMoreThanRatingsTellByNothing() {
        Results results = new Results(SEASON);
        // Each beats the next in 299 of 300 games, or in all: 1 against 3 is nearly certain in any case.
        for (int seed = 0; seed < 30_000; seed++) {
            results.addGame(seed, new int[] {1, 2}, seed % 100 == 0 ? 1 : 0, seed % 100 == 0 ? 0 : 1);
            results.addGame(seed, new int[] {2, 3}, seed % 100 == 50 ? 1 : 0, seed % 100 == 50 ? 0 : 1);
            results.addGame(seed, new int[] {1, 3}, seed % 500 == 7 ? 1 : 0, seed % 500 == 7 ? 0 : 1);
        }
        LeagueTable table = LeagueTable.of(results, entries(3));
        for (LeagueTable.Surprise each : table.surprises()) {
            String line = TableText.surprise(table, each);
            var shares = Pattern.compile("tell: ([0-9.]+)% of .* tell ([0-9.]+)%").matcher(line);
            assertTrue(shares.find(), line);
            assertFalse(shares.group(1).equals(shares.group(2)), line);
        }
        assertEquals(List.of(), table.surprises(), "less than half a percent is nothing to name");
    }
}
