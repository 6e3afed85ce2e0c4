package steward.cli.league;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.Cli;
import steward.cli.ShellBots;
import steward.cli.TextShellBots;
import steward.cli.streams.Json;

/** Tests that stop, rules that end a league, and the search for parameters, with programs that play. */
@Tag("process")
@Tag("slow")
@Timeout(300)
class SequentialProcessTest {

    @TempDir
    private Path folder;
    /** Draws its maps from the seed. */
    private String scene;
    /** One game under every seed. */
    private String alike;
    private String drives;
    private String drivesToo;
    private String stays;

    @BeforeEach
    void prepare() throws IOException {
        assumeTrue(ShellBots.runnable(), "skipped: there is no /bin/sh");
        alike = folder.resolve("alike.json").toString();
        String duel = Files.readString(Path.of("config/scenes/duel.json"))
            .replace("\"maximumTurns\": 200", "\"maximumTurns\": 5");
        Files.writeString(Path.of(alike), duel);
        scene = folder.resolve("short.json").toString();
        Files.writeString(Path.of(scene), duel.replaceFirst("(?s)\"maps\": \\[.*?\\n    ]",
            "\"maps\": \"official\", \"shift\": true, \"jitter\": 30"));
        TextShellBots bots = new TextShellBots(folder);
        drives = "drives=codingame:" + bots.driver();
        drivesToo = "drivesToo=codingame:" + bots.driver().replace(" 0", " 99");
        stays = "stays=codingame:" + bots.idler(0);
    }

    private static String done(String... words) {
        Cli cli = Cli.run(words);
        assertEquals(0, cli.status(), cli.err());
        return cli.out();
    }

    private String league(String name, String... bots) throws IOException {
        String league = folder.resolve(name).toString();
        done("league", "init", league, "--scene", scene, "--seed", "3");
        Path settings = Path.of(league, "league.json");
        Files.writeString(settings, Files.readString(settings).replace("\"factor\": 1", "\"factor\": \"none\"")
            .replace("\"lag\": 64", "\"lag\": 4"));
        for (String bot : bots) {
            done("league", "add", league, bot);
        }
        return league;
    }

    private String sprt(String... more) {
        List<String> words = new ArrayList<>(List.of("sprt", "--scene", scene, "--bot", drives, "--bot", stays,
            "--elo1", "200", "--seed", "3", "--no-deadline"));
        words.addAll(Arrays.asList(more));
        return done(words.toArray(String[]::new));
    }

    private static String tableHead(String league) {
        return done("league", "table", league).lines().findFirst().orElseThrow();
    }

    @Test
    void aTestGoesOnWhereItWas() throws IOException {
        String whole = sprt();
        assertTrue(whole.contains(": H1 is accepted: drives is better"), whole);
        String league = league("tested");
        assertTrue(sprt("--into", league, "--games", "6").contains(": not decided, about "));
        assertEquals("6 games of duel", tableHead(league));
        assertEquals(whole, sprt("--into", league), "as if it had not been interrupted");
        String played = tableHead(league);
        assertEquals(whole, sprt("--into", league), "everything is stored");
        assertEquals(played, tableHead(league));
        assertEquals(done("league", "sprt", league("other", drives, stays), "drives", "stays", "--elo1", "200"),
            done("league", "sprt", league("third", drives, stays), "drives", "stays", "--elo1", "200", "--threads",
                "2"), "threads change nothing");
    }

    @Test
    void aTestOfBotsThatPlayAlikeUnderEverySeedStopsUndecided() {
        scene = alike;
        Cli cli = Cli.run("sprt", "--scene", scene, "--bot", drives, "--bot", stays, "--elo1", "200", "--seed", "3",
            "--no-deadline");
        assertEquals(0, cli.status(), cli.err());
        assertTrue(cli.out().contains(": not decided") && cli.out().contains(
            "1 seed, 2 games, 20 seeds that only repeat games left out"), cli.out());
        assertTrue(cli.err().contains("the test ends undecided: the last 20 seeds repeat games"), cli.err());
    }

    @Test
    void aTestOfABotThatDrawsByLotCountsEqualGames() {
        scene = alike;
        String said = sprt("--random");
        assertTrue(said.contains(": H1 is accepted: drives is better") && !said.contains("repeat"), said);
    }

    @Test
    void aLeagueOfBotsThatPlayAlikeEndsAndSaysSo() throws IOException {
        scene = alike;
        String said = done("league", "run", league("alike", drives, stays), "--games", "400");
        assertTrue(said.startsWith("2 games of duel, ") && said.contains(" more that only repeat earlier ones"), said);
        assertTrue(said.contains("The bots only repeat games that were played before"), said);
    }

    @Test
    void aLeagueEndsWhenEnoughIsKnown() throws IOException {
        String whole = league("whole", drives, drivesToo);
        String said = done("league", "run", whole, "--until-ranked", "--equal", "300", "--games", "400");
        assertTrue(said.contains("Ranked: drives = drivesToo") || said.contains("Ranked: drivesToo = drives"), said);
        assertTrue(said.contains("= within 300 Elo."), said);
        String games = tableHead(whole);
        assertFalse(games.startsWith("400 "), "it ended by its rule");

        String parts = league("parts", drives, drivesToo);
        said = done("league", "run", parts, "--until-ranked", "--equal", "300", "--games", "5", "--threads", "2");
        assertTrue(said.contains("Not yet ranked: the order of 1 of 1 pair of neighbours is open."), said);
        done("league", "run", parts, "--until-ranked", "--equal", "300", "--games", "400", "--threads", "2");
        assertEquals(games, tableHead(parts), "neither threads nor interruptions change the end");

        said = done("league", "run", parts, "--until-bars", "1", "--games", games.split(" ")[0]);
        assertTrue(Pattern.compile("--until-bars 1 needs more games of .* more\\)").matcher(said).find(), said);
        assertTrue(done("league", "run", parts, "--until-bars", "1000", "--games", "400")
            .contains("All anytime bars are at most 1000 Elo."));
        assertEquals(games, tableHead(parts), "that was known already");
    }

    /** Both win all games against the third of the gauntlet, and never meet. */
    @Test
    void aLeagueDoesNotWaitForTheOrderOfBotsThatCannotMeet() throws IOException {
        String league = league("gauntlet", drives, drivesToo, stays);
        Path settings = Path.of(league, "league.json");
        Files.writeString(settings, Files.readString(settings).replace("\"adaptive\"", "\"gauntlet stays\""));
        String said = done("league", "run", league, "--until-ranked", "--games", "6");
        assertTrue(said.contains("Not yet ranked: the order of 2 of 2 pairs of neighbours is open."), said);
        said = done("league", "run", league, "--until-ranked", "--games", "400");
        assertTrue(said.contains("Ranked: drives | drivesToo > stays")
            || said.contains("Ranked: drivesToo | drives > stays"), said);
        assertTrue(said.contains("One pair of neighbours cannot meet, and no game compares them: not waited for."),
            said);
        assertFalse(tableHead(league).startsWith("400 "), "it ended by its rule");
    }

    /** The bot reads its first two words only: whatever the third is, it plays the same games. */
    @Test
    void aSearchThatSeesNoDifferenceSaysSoAndWhatToTry() throws IOException {
        List<String> words = new ArrayList<>(List.of("tune", "--scene", scene, "--bot", drives + " {unread:10..90}",
            "--against", stays, "--games", "16", "--seeds", "1", "--test-games", "0", "--seed", "1", "--no-deadline"));
        Cli cli = Cli.run(words.toArray(String[]::new));
        assertEquals(0, cli.status(), cli.err());
        assertTrue(cli.err().contains("in each of the 4 steps both sets of values scored alike: the search saw no "
            + "difference, and stays at the start. Try wider ranges, parameters that the bot reads, opponents nearer "
            + "in strength (--against), or more seeds a step (--seeds)"), cli.err());
        words.add("--json");
        assertEquals(4L, ((Number) Json.object(done(words.toArray(String[]::new)).lines().findFirst().orElseThrow())
            .get("tied")).longValue());
    }

    @Test
    @Tag("campaign")
    void aSearchGoesOnWhereItWasAndFindsTheBetterChoice() throws IOException {
        scene = alike;
        String league = league("tuned");
        List<String> words = new ArrayList<>(List.of("tune", "--scene", alike, "--bot",
            "mine=codingame:sh '" + folder.resolve("text pod.sh") + "' {way:stay|drive} 0", "--against", stays,
            "--games", "24", "--seeds", "1", "--test-games", "12", "--seed", "1", "--no-deadline"));
        String whole = done(words.toArray(String[]::new));
        assertTrue(whole.contains("way drive"), whole);
        words.addAll(List.of("--into", league));
        assertEquals(whole, done(words.toArray(String[]::new)));
        assertEquals(whole, done(words.toArray(String[]::new)), "from what is stored");

        words.add("--json");
        List<String> lines = done(words.toArray(String[]::new)).lines().toList();
        assertEquals(2, lines.size(), lines::toString);
        Map<String, Object> result = Json.object(lines.get(0));
        assertTrue(result.get("bot").toString().contains(" drive "), lines.get(0));
        assertEquals("way", Json.objects(result.get("parameters")).get(0).get("name"));
        assertTrue(Json.object(lines.get(1)).containsKey("llr"), lines.get(1));
    }
}
