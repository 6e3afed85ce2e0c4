package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.Cli;
import tools.jackson.databind.JsonNode;

/** Limits of one bot in what is printed for programs: beside its name, in one form. */
@Tag("process")
@Tag("slow")
class OwnLimitsJsonTest {

    private static final List<String> EXPECTED = List.of("a null", "b \"900,2000\"");

    @TempDir
    private Path folder;

    private static Cli run(String call) {
        return Cli.run(call.split(" ")).done();
    }

    private static List<String> limits(JsonNode bots) {
        List<String> limits = new ArrayList<>();
        bots.forEach(bot -> limits.add(bot.get("name").stringValue() + " " + bot.get("timeLimit")));
        return limits;
    }

    @Test
    void aMatchASeriesAReplayAndALeagueTellThem() {
        String play = "match --json --scene duel --seed 1 --bot a=builtin:racer --bot b=builtin:racer "
            + "--time-limit b=900,2000 ";
        Path replay = folder.resolve("r.jsonl");
        assertEquals(EXPECTED, limits(run(play + "--out " + replay).json().get("players")));
        assertEquals(EXPECTED, limits(run(play + "--games 1").json().get("bots")));
        assertEquals(EXPECTED, limits(run("replay --json " + replay).json().get("players")));
        run("league init " + folder + "/night --scene duel --seed 1");
        run("league add " + folder + "/night a=builtin:racer");
        run("league add " + folder + "/night b=builtin:racer --time-limit 900,2000");
        assertEquals(EXPECTED, limits(run("league list --json " + folder + "/night").json().get("bots")));
    }

    /** Versions that came from elsewhere are of no bot in league.json. */
    @Test
    void aVersionOfNoBotOfTheLeagueIsListedWithThem() {
        run("league init " + folder + "/night --scene duel --seed 1");
        run("match --scene duel --seed 1 --games 1 --bot a=builtin:racer --bot b=builtin:veteran "
            + "--time-limit b=900,2000 --into " + folder + "/night");
        assertEquals(List.of("  a: 1 game, not in league.json: builtin:racer",
            "  b: 1 game, not in league.json: builtin:veteran, answers within 900 ms, the first within 2000 ms"),
            run("league list " + folder + "/night").out().lines().skip(1).sorted().toList());
    }
}
