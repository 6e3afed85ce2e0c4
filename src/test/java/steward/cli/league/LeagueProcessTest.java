package steward.cli.league;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
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
import steward.cli.Main;
import steward.cli.SeveralCalls;
import steward.cli.ShellBots;
import steward.cli.TextShellBots;
import steward.league.LeagueFolder;
import steward.league.Season;
import steward.league.store.GameQueries;
import steward.league.store.GameStore;

/**
 * Leagues of shell bots, which are deterministic, in programs of their own: killed at any moment, changed in between,
 * called twice. {@code -Dsteward.turns=100} kills so often.
 */
@Tag("process")
@Tag("slow")
@Timeout(600)
@Execution(ExecutionMode.CONCURRENT)
class LeagueProcessTest {

    private static final int KILLS = Integer.getInteger("steward.turns", 3);
    private static final int GAMES_A_KILL = 12;

    @TempDir
    private Path folder;

    @BeforeEach
    void prepare() throws IOException {
        assumeTrue(ShellBots.runnable(), "skipped: there is no /bin/sh");
        ShellBots.shortDuel(folder);
        new TextShellBots(folder);
    }

    private Process start(Path out, String... arguments) throws IOException {
        List<String> command = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java")
            .toString(), "-XX:TieredStopAtLevel=1", "--enable-native-access=ALL-UNNAMED", "-Djava.io.tmpdir="
            + Files.createDirectories(folder.resolve("tmp")), "-cp", absolute(), Main.class.getName()));
        command.addAll(List.of(arguments));
        return new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true)
            .redirectOutput(out.toFile()).start();
    }

    private static String absolute() {
        return Stream.of(System.getProperty("java.class.path").split(File.pathSeparator))
            .map(part -> Path.of(part).toAbsolutePath().toString())
            .reduce((one, other) -> one + File.pathSeparator + other).orElseThrow();
    }

    private String run(int status, String... arguments) throws IOException, InterruptedException {
        Path out = Files.createTempFile(folder, "out", ".txt");
        int found = start(out, arguments).waitFor();
        String said = Files.readString(out, StandardCharsets.UTF_8);
        assertEquals(status, found, said);
        return said;
    }

    private void make(String league) throws IOException, InterruptedException {
        run(0, "league", "init", league, "--scene", "short.json", "--seed", "5");
        run(0, "league", "add", league, "fast=codingame:sh 'text pod.sh' drive 0");
        run(0, "league", "add", league, "still=codingame:sh 'text pod.sh' stay 0");
        run(0, "league", "add", league, "wrong=codingame:sh 'text pod.sh' drive 3");
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
    void aLeagueThatIsKilledComesToTheSameGames() throws IOException, InterruptedException {
        String games = Integer.toString(KILLS * GAMES_A_KILL);
        make("whole");
        run(0, "league", "run", "whole", "--games", games, "--threads", "2");
        List<String> expected = games("whole");
        assertEquals(KILLS * GAMES_A_KILL, expected.size());

        make("killed");
        SplittableRandom random = new SplittableRandom(8);
        for (int kill = 0; kill < KILLS; kill++) {
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
        run(0, "league", "run", "killed", "--games", games, "--threads", "2");
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
        run(0, "league", "run", "league", "--games", "6");
        Files.writeString(folder.resolve("text pod.sh"), Files.readString(folder.resolve("text pod.sh"))
            + "# another program\n");
        String said = run(0, "league", "run", "league", "--games", "8");
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
            assertEquals("steward: league: found a league that is being played by process " + first.pid()
                + ", expected one run at a time\n", run(2, "league", "run", "league"));
        } finally {
            first.destroyForcibly().waitFor();
        }
        run(0, "league", "run", "league", "--games", "8");
    }

    private static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException problem) {
            return problem.toString();
        }
    }

    @Test
    void noOtherCommandLoadsTheDatabase() throws IOException, InterruptedException {
        Path out = Files.createTempFile(folder, "out", ".txt");
        List<String> command = List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-XX:TieredStopAtLevel=1", "-Xlog:class+load", "-cp", absolute());
        List<List<String>> calls = List.of(List.of("match", "--scene", "short.json", "--bot",
                "codingame:sh 'text pod.sh' drive 0", "--bot", "codingame:sh 'text pod.sh' stay 0", "--games", "2",
                "--out", "games"),
            List.of("replay", "games/game-0001.jsonl", "--verify"), List.of("explain", "short.json"),
            List.of("--help"), List.of("league", "table", "none"));
        List<String> words = new ArrayList<>(command);
        words.add(SeveralCalls.class.getName());
        words.addAll(SeveralCalls.words(calls));
        int status = new ProcessBuilder(words).directory(folder.toFile()).redirectErrorStream(true)
            .redirectOutput(out.toFile()).start().waitFor();
        String said = read(out);
        assertEquals(0, status, said);
        assertTrue(said.contains("steward.cli.Main"), said);
        for (List<String> call : calls) {
            assertTrue(said.contains(SeveralCalls.line(call.contains("none") ? 2 : 0, call)), () -> call + ": " + said);
        }
        assertFalse(said.contains("org.sqlite"), () -> "the database is loaded: " + said);
        make("league");
        words = new ArrayList<>(command);
        words.addAll(List.of(Main.class.getName(), "league", "run", "league", "--games", "1"));
        new ProcessBuilder(words).directory(folder.toFile()).redirectErrorStream(true).redirectOutput(out.toFile())
            .start().waitFor();
        assertTrue(read(out).contains("org.sqlite"), "a run does: the test would see it");
    }
}
