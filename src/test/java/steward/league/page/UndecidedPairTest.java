package steward.league.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.json.JsonNumbers;
import steward.league.Season;
import steward.league.rating.Difference;
import steward.league.rating.LeagueTable;
import steward.league.rating.Results;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** After a single game the difference of two bots has no bar; who is probably the better one is known. */
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
        ByteArrayOutputStream text = new ByteArrayOutputStream();
        try (JsonGenerator out = JsonNumbers.FACTORY.createGenerator(ObjectWriteContext.empty(), text)) {
            out.writeStartObject();
            LeagueJson.table(out, season, table, List.of());
            out.writeEndObject();
        }
        assertFalse(Difference.isKnown(table.bounded(1, 2).bar()));
        JsonNode pair = JsonMapper.shared().readTree(text.toByteArray()).get("differences").get(1).get(2);
        assertTrue(pair.get(1).isNull(), "the bar: " + pair);
        assertTrue(pair.get(3).asDouble() > 0.5, "who won is more probably the better one: " + pair);
        assertEquals(table.difference(1, 2).superiority(), pair.get(3).asDouble(), 1e-9);
    }

    private static LeagueTable.Entry entry(int version) {
        return new LeagueTable.Entry(version, "bot " + version, false, true);
    }
}
