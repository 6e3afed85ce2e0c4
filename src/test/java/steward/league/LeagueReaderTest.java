package steward.league;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.bot.TimeBasis;
import steward.bot.hold.HoldPolicy;
import steward.contest.Hiccups;
import steward.contest.KeptReplays;
import steward.files.InputException;
import steward.match.OwnLimits;
import steward.scene.json.SceneException;

/** league.json: what it says is read, written and read again; what it should not say is refused with its place. */
class LeagueReaderTest {

    private static final String WHOLE = """
        {
          "league": 1, "scene": "duel", "seed": "-9223372036854775808", "pairing": "gauntlet a", "lag": 7,
          "time": { "factor": 2.5, "basis": "cpu" }, "hiccups": "count", "seeds": "chosen.txt",
          "sandbox": { "level": "strict", "memory": "2G", "processes": 9, "network": true, "environment": ["X", "Y"] },
          "replays": { "keep": "lost", "of": ["a"] },
          "bots": [ { "name": "a", "command": "python3 'b c.py'", "files": ["b c.py"], "answerMs": 60, \
                      "firstAnswerMs": 500, "random": true },
                    { "name": "b", "command": "codingame:./b", "folder": "/v1", "answerMs": 9, "retired": true,
                      "platforms": [{ "platform": "linux-aarch64", "command": "./b-arm", "folder": "arm", \
                    "files": ["b-arm"] }]},
                    { "name": "b@linux-arm", "command": "./b-a" } ] }
        """;

    private static LeagueSettings read(String text) {
        return LeagueReader.read(text, "league.json");
    }

    private static String refusal(String text) {
        return assertThrows(SceneException.class, () -> read(text)).getMessage();
    }

    @Test
    void everyFieldIsReadAndWritten() {
        LeagueSettings settings = read(WHOLE);
        assertEquals(new LeagueSettings("duel", Long.MIN_VALUE, "chosen.txt", "a", false, 7, 2.5, TimeBasis.CPU,
            Hiccups.COUNT,
            List.of("--sandbox", "strict", "--memory", "2G", "--processes", "9", "--network", "--env", "X", "--env",
                "Y"),
            KeptReplays.LOST, List.of("a"), List.of(
                new LeagueBot("a", "python3 'b c.py'", List.of("b c.py"), true, false)
                    .within(new OwnLimits(60, 500)),
                new LeagueBot("b", "codingame:./b", "/v1", null, false, true, 0,
                    List.of(new LeagueBot.ForPlatform("linux-aarch64", "./b-arm", "arm", List.of("b-arm"))),
                    new OwnLimits(9, 0)),
                new LeagueBot("b@linux-arm", "./b-a", null, false, false))), settings);
        assertEquals(settings, read(LeagueText.write(settings)));
        LeagueSettings usual = LeagueSettings.usual("duel", 3);
        assertEquals(usual, read(LeagueText.write(usual)));
        LeagueSettings unlimited = usual.with(null, Double.POSITIVE_INFINITY, KeptReplays.ALL);
        assertEquals(unlimited, read(LeagueText.write(unlimited)));
    }

    /** The season's limits are part of the names of all games: those of the usual policy are as they always were. */
    @Test
    void whichBotsAreHeldStandsInTheLimitsUnlessItIsUsual() {
        String plain = "{ \"league\": 1, \"scene\": \"duel\", \"seed\": \"1\", "
            + "\"sandbox\": { \"level\": \"light\"%s } }";
        assertEquals("factor 1.0 wall", read(String.format(plain, "")).limits());
        assertEquals("factor 1.0 wall", read(String.format(plain, ", \"hold\": \"burners\"")).limits());
        LeagueSettings always = read(String.format(plain, ", \"hold\": \"always\""));
        assertEquals(List.of("--sandbox", "light", "--hold", "always"), always.sandbox());
        assertEquals("factor 1.0 wall, hold always", always.limits());
        assertEquals(always, read(LeagueText.write(always)));
        assertEquals("factor 1.0 wall, hold never", read(String.format(plain, ", \"hold\": \"never\"")).limits());
        assertEquals("factor 1.0 wall, hold never", always.holding(HoldPolicy.NEVER).limits());
        assertEquals("sandbox.pauseWaiting: found true, expected \"hold\": \"always\" in its place, as Steward 0.2.0 "
            + "writes it", refusal(String.format(plain, ", \"pauseWaiting\": true"))
            .replaceAll("^league.json:\\d+:\\d+: ", ""));
        assertEquals("sandbox.hold: found \"burner\", expected one of \"burners\", \"always\", \"never\"; "
            + "did you mean \"burners\"?",
            refusal(String.format(plain, ", \"hold\": \"burner\"")).replaceAll("^league.json:\\d+:\\d+: ", ""));
    }

    /** Each row: a part of the text, what stands there instead, and the refusal with its line. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        gauntlet a | gauntlet c | 2 pairing: found the unknown bot "c", expected one of the league's bots
        "name": "b" | "name": "a" | 7 bots[1].name: found "a" a second time, expected each name once
        @linux-arm | @arm | 9 bots[2].name: found "b@arm", expected NAME@PLATFORM with a platform such as linux-x86_64 \
        or linux-aarch64: linux, macos or windows, and x86_64, aarch64, arm, loongarch64, ppc64le, riscv64, s390x or x86
        ["b-arm"] } | [] }, { "platform": "linux-aarch64", "command": "x" } | 8 bots[1].platforms[1].platform: found \
        "linux-aarch64" a second time, expected each platform once
        "./b-a" | "./b-a", "platforms": [ { "platform": "linux-x86", "command": "x" } ] | 9 bots[2].platforms[0]\
        .platform: found "linux-x86", expected none: the bot plays on the platform of its name
        "answerMs": 9 | "firstAnswerMs": 9 | 7 bots[1].firstAnswerMs: found 9, expected "answerMs" beside it
        "answerMs": 9 | "answerMs": 0 | 7 bots[1].answerMs: found 0, expected a whole number 1..3600000
        "seed": "-9223372036854775808",| `` | 1 seed: found nothing, expected a text
        "lag": 7,| "lag": 7, "bost": [], | 2 bost: found an unknown field, expected
        "league": 1 | "league": 2 | 2 league: found 2, expected a whole number 1..1
        """)
    void aWrongFieldIsNamedWithItsPlace(String part, String instead, String refusal) {
        assertTrue(WHOLE.contains(part), part);
        String found = refusal(WHOLE.replace(part, instead)).replaceFirst("^league.json:(\\d+):\\d+:", "$1");
        assertEquals(refusal, found.substring(0, Math.min(refusal.length(), found.length())));
    }

    @Test
    void aFolderOfAnotherMachineIsRefused(@TempDir Path folder) {
        InputException refused = assertThrows(InputException.class, () -> LeagueFolder.refuseRemote(folder, "NFS4"));
        assertEquals(folder + ": found a file system of another machine (NFS4), expected one of this machine: the "
            + "write-ahead log of the database is not safe over a network", refused.getMessage());
        LeagueFolder.refuseRemote(folder, "ext4");
    }
}
