package steward.cli.league;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.bot.process.JavaProcess;
import steward.cli.Cli;
import steward.cli.Main;
import steward.cli.SeveralCalls;
import steward.cli.ShellBots;
import steward.cli.TextShellBots;
import steward.league.LeagueFolder;
import steward.league.Season;
import steward.league.store.GameQueries;
import steward.league.store.GameStore;
import steward.match.TestSize;

/**
 * Leagues of shell bots, which are deterministic, in programs of their own: killed at any moment, changed in between,
 * called twice. The campaign kills as often as
 * {@code -Dsteward.turns} says.
 */
@Tag("process")
@Tag("slow")
@Timeout(600)
@Execution(ExecutionMode.CONCURRENT)
class LeagueProcessTest {

    private static final int GAMES_A_KILL = 12;

    @TempDir
    private Path folder;

    @BeforeEach
    void prepare() throws IOException {
        ShellBots.shortDuel(folder);
        new TextShellBots(folder);
    }

    private Process start(Path out, String... arguments) throws IOException {
        return new ProcessBuilder(JavaProcess.words(List.of("-Djava.io.tmpdir="
            + Files.createDirectories(folder.resolve("tmp"))), Main.class, List.of(arguments)))
            .directory(folder.toFile()).redirectErrorStream(true).redirectOutput(out.toFile()).start();
    }

    /** Makes a league, in this JVM: each start of Java takes a second. */
    private void make(String league) {
        String script = "=codingame:sh '" + folder.resolve("text pod.sh") + "' ";
        here(0, "init", "TMP/" + league, "--scene", "TMP/short.json", "--seed", "5");
        here(0, "add", "TMP/" + league, "fast" + script + "drive 0");
        here(0, "add", "TMP/" + league, "still" + script + "stay 0");
        here(0, "add", "TMP/" + league, "wrong" + script + "drive 3");
    }

    /** A call in this JVM; what it says. */
    private String here(int status, String... words) {
        Cli cli = Cli.league(folder, words);
        assertEquals(status, cli.status(), cli.err());
        return cli.out() + cli.err();
    }

    /** Every game without what is measured: it has to be the same however it was played. */
    private List<String> games(String league) {
        List<String> lines = new ArrayList<>();
        try (GameStore store = GameStore.read(new LeagueFolder(folder.resolve(league)))) {
            assertEquals("ok", store.integrity());
            Season season = store.lastSeason().orElseThrow();
            new GameQueries(store, store.season(season).orElseThrow(), season).games(game ->
                lines.add(game.decision() + " " + game.seed() + " " + game.attempt() + " " + game.counts() + " "
                    + game.turns() + " " + game.seats().stream().map(seat -> seat.version() + ":" + seat.rank() + ":"
                        + seat.score() + ":" + seat.fault() + ":" + seat.answers()).toList()));
        }
        lines.sort(null);
        return lines;
    }

    @Test
    @Tag("sized")
    void aLeagueThatIsKilledComesToTheSameGames() throws IOException, InterruptedException {
        int kills = TestSize.of(1, Integer.getInteger("steward.turns", 10));
        String games = Integer.toString(kills * GAMES_A_KILL);
        make("whole");
        here(0, "run", "TMP/whole", "--games", games, "--threads", "2");
        List<String> expected = games("whole");
        assertEquals(kills * GAMES_A_KILL, expected.size());

        make("killed");
        SplittableRandom random = new SplittableRandom(8);
        for (int kill = 0; kill < kills; kill++) {
            Path out = Files.createTempFile(folder, "out", ".txt");
            Process process = start(out, "league", "run", "killed", "--games", games, "--threads",
                Integer.toString(1 + random.nextInt(3)));
            int later = 1 + random.nextInt(GAMES_A_KILL);
            Path log = folder.resolve("killed/league.db-wal");
            long before = Files.exists(log) ? Files.size(log) : 0;
            while (process.isAlive() && (Files.exists(log) ? Files.size(log) : 0) < before + later * 10_000L) {
                process.waitFor(5, TimeUnit.MILLISECONDS);
            }
            process.destroyForcibly().waitFor();
            if (Files.exists(folder.resolve("killed/league.db"))) {
                assertTrue(expected.containsAll(gamesOrNone("killed")), "after kill " + kill);
            }
        }
        here(0, "run", "TMP/killed", "--games", games, "--threads", "2");
        assertEquals(expected, games("killed"));
        try (Stream<Path> left = Files.list(folder.resolve("tmp"))) {
            assertEquals(List.of(), left.filter(file -> file.getFileName().toString().contains("sqlite")).toList());
        }
    }

    private List<String> gamesOrNone(String league) {
        try (GameStore store = GameStore.write(new LeagueFolder(folder.resolve(league)))) {
            if (store.lastSeason().isEmpty()) {
                return List.of();
            }
        }
        return games(league);
    }

    @Test
    void aChangedBotIsANewVersionAndASecondRunIsRefused() throws IOException, InterruptedException {
        make("league");
        here(0, "run", "TMP/league", "--games", "6");
        Files.writeString(folder.resolve("text pod.sh"), Files.readString(folder.resolve("text pod.sh"))
            + "# another program\n");
        String said = here(0, "run", "TMP/league", "--games", "8");
        assertTrue(said.contains("fast changed after 4 games: new version fast#2\n"), said);
        assertTrue(said.contains("fast (out)") && said.contains("fast#2"), said);

        Path out = Files.createTempFile(folder, "out", ".txt");
        Process first = start(out, "league", "run", "league", "--for", "1h", "--quiet");
        try {
            Path lock = folder.resolve("league/league.lock");
            while (!Files.readString(lock).strip().equals(Long.toString(first.pid()))) {
                assertTrue(first.isAlive(), () -> read(out));
                first.waitFor(10, TimeUnit.MILLISECONDS);
            }
            assertEquals("steward: " + folder.resolve("league") + ": found a league that is being played by process "
                + first.pid() + ", expected one run at a time\n", here(2, "run", "TMP/league"));
        } finally {
            first.destroyForcibly().waitFor();
        }
        here(0, "run", "TMP/league", "--games", "8");
    }

    private static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException problem) {
            return problem.toString();
        }
    }

    @Test
    @Tag("campaign")
    void noOtherCommandLoadsTheDatabase() throws IOException, InterruptedException {
        Path out = Files.createTempFile(folder, "out", ".txt");
        make("league");
        List<List<String>> calls = List.of(List.of("match", "--scene", "short.json", "--bot",
                "codingame:sh 'text pod.sh' drive 0", "--bot", "codingame:sh 'text pod.sh' stay 0", "--games", "2",
                "--out", "games"),
            List.of("replay", "games/game-0001.jsonl", "--verify"), List.of("explain", "short.json"),
            List.of("--help"), List.of("league", "table", "none"), List.of("league", "run", "league", "--games", "1"));
        int status = new ProcessBuilder(JavaProcess.words(List.of("-Xlog:class+load"), SeveralCalls.class,
            SeveralCalls.words(calls))).directory(folder.toFile()).redirectErrorStream(true)
            .redirectOutput(out.toFile()).start().waitFor();
        String said = read(out);
        assertEquals(0, status, said);
        assertTrue(said.contains("steward.cli.Main"), said);
        for (List<String> call : calls) {
            assertTrue(said.contains(SeveralCalls.line(call.contains("none") ? 2 : 0, call)), () -> call + ": " + said);
        }
        int run = said.indexOf(SeveralCalls.line(2, calls.get(calls.size() - 2)));
        assertFalse(said.substring(0, run).contains("org.sqlite"), () -> "the database is loaded: " + said);
        assertTrue(said.substring(run).contains("org.sqlite"), "a run does: the test would see it");
    }
}
