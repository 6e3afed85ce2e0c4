package steward.league.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.json.JsonObject;
import steward.league.Season;
import steward.league.rating.Difference;
import steward.league.rating.LeagueTable;
import steward.league.rating.Results;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Differences of two bots on the page: undecided ones, and those of many bots. */
@Execution(ExecutionMode.CONCURRENT)
class UndecidedPairTest {

    @Test
    void thePageTellsTheSameLikelihoodOfSuperiorityAsTheTable() {
        Season season = Season.of("duel", "key", "limits", "rules", 2, false);
        Results results = new Results(season);
        results.addGame(0, new int[] {2, 3}, 0, 1);
        for (int seed = 1; seed <= 20; seed++) {
            results.addGame(seed, new int[] {1, 3}, 0, 1);
        }
        LeagueTable table = LeagueTable.of(results, List.of(entry(1), entry(2), entry(3)));
        assertFalse(Difference.isKnown(table.bounded(1, 2).bar()));
        JsonNode pair = differences(season, table).get(1).get(2);
        assertTrue(pair.get(1).isNull(), "the bar: " + pair);
        assertTrue(pair.get(3).asDouble() > 0.5, "who won is more probably the better one: " + pair);
        assertEquals(table.superiority(1, 2), pair.get(3).asDouble(), 1e-9);
    }

    @Test
    @Tag("slow")
    void ofManyBotsNeighboursAreComparedByTheirOwnPairings() {
        Season season = Season.of("duel", "key", "limits", "rules", 2, false);
        for (int bots : new int[] {100, 101}) {
            Results results = new Results(season);
            SplittableRandom random = new SplittableRandom(1);
            for (int game = 0; game < 20 * bots; game++) {
                int one = random.nextInt(bots);
                results.addGame(game, new int[] {one, (one + 1 + random.nextInt(bots - 1)) % bots},
                    random.nextInt(2), random.nextInt(2));
            }
            LeagueTable table = LeagueTable.of(results, IntStream.range(0, bots).mapToObj(bot -> entry(bot)).toList());
            JsonNode found = differences(season, table);
            assertEquals(bots > 100, found.get(40).get(51).isNull(), bots + " bots, 11 places apart");
            for (int other = 30; other <= 50; other++) {
                JsonNode pair = found.get(40).get(other);
                assertEquals(other == 40, pair.isNull());
                if (other != 40) {
                    double bar = table.difference(40, other).bar();
                    assertEquals(bar, pair.get(1).asDouble(), 1e-9 * bar);
                }
            }
        }
    }

    private static JsonNode differences(Season season, LeagueTable table) {
        return JsonMapper.shared().readTree(JsonObject.text(LeagueJson.table(season, table, List.of())::write))
            .get("differences");
    }

    private static LeagueTable.Entry entry(int version) {
        return new LeagueTable.Entry(version, "bot " + version, false, true);
    }
}
