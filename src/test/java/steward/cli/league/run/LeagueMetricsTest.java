package steward.cli.league.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import steward.league.page.WorkerRow;

class LeagueMetricsTest {

    @Test
    void figuresAreInTheTextFormatOfPrometheus() {
        String text = LeagueMetrics.text(120, 7, 1.5, List.of(
            new WorkerRow("attic", "2 at a time", 30, 0, 0.5, 3, 1, "1", 1500, List.of("a doubt")),
            new WorkerRow("cellar", "caught", 0, 12, 0, 0, 0, "1", 0, List.of())));
        assertTrue(text.lines().allMatch(line -> line.matches("# (HELP|TYPE) steward_[a-z_]+ .+"
            + "|steward_[a-z_]+(\\{worker=\"[A-Za-z0-9_-]+\"\\})? [0-9]+(\\.[0-9]+)?")), text);
        assertEquals(List.of("steward_games_total 120", "steward_stored_total 7", "steward_games_per_second 1.500",
            "steward_workers 1", "steward_worker_games{worker=\"attic\"} 30",
            "steward_worker_games{worker=\"cellar\"} 0", "steward_worker_set_aside{worker=\"attic\"} 0",
            "steward_worker_set_aside{worker=\"cellar\"} 12", "steward_worker_faults{worker=\"attic\"} 3",
            "steward_worker_faults{worker=\"cellar\"} 0", "steward_worker_hiccups{worker=\"attic\"} 1",
            "steward_worker_hiccups{worker=\"cellar\"} 0", "steward_worker_suspicions{worker=\"attic\"} 1",
            "steward_worker_suspicions{worker=\"cellar\"} 0", "steward_worker_silent_seconds{worker=\"attic\"} 1.500",
            "steward_worker_silent_seconds{worker=\"cellar\"} 0"),
            text.lines().filter(line -> !line.startsWith("#")).toList());
    }
}
