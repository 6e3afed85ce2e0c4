package steward.cli.machines;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.bot.process.JavaProcess;
import steward.bot.process.ScriptedBots;
import steward.cli.Cli;
import steward.cli.FreePort;
import steward.cli.Main;
import steward.cli.ShellBots;
import steward.cli.TextShellBots;
import steward.cli.streams.Streams;
import steward.league.LeagueFolder;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.store.GameQueries;
import steward.league.store.GameStore;
import steward.machines.token.SharedBrokerKey;

/**
 * How workers end, by themselves and by a signal, and what they say where they cannot play. Those that others end are
 * processes.
 */
@Tag("process")
@Tag("slow")
@Timeout(300)
@Execution(ExecutionMode.CONCURRENT)
class WorkerProcessTest {

    private static final int INTERRUPTED = 130;
    /** A thread for each: all are there at the same time. */
    private static final Executor THREADS = work -> {
        Thread thread = new Thread(work, "worker or league");
        thread.setDaemon(true);
        thread.start();
    };

    @TempDir
    private Path folder;

    private final List<Process> started = new ArrayList<>();
    private final ByteArrayOutputStream leagueSays = new ByteArrayOutputStream();
    private int port;

    @BeforeEach
    void prepare() throws IOException {
        ShellBots.shortDuel(folder, 5);
        ShellBots.drawn(folder.resolve("short.json"));
        before("");
        TextShellBots bots = new TextShellBots(folder);
        LeagueFolder league = new LeagueFolder(folder.resolve("night"));
        done("init", folder.resolve("night").toString(), "--scene", folder.resolve("short.json").toString());
        String gate = "sh '" + folder.resolve("gate.sh") + "' ";
        done("add", folder.resolve("night").toString(), "fast=codingame:" + gate + bots.driver());
        done("add", folder.resolve("night").toString(), "still=codingame:" + gate + bots.idler(0));
        SharedBrokerKey.put(league);
        port = FreePort.next();
    }

    /** Lets each bot do this, in the folder of the test, before it begins. */
    private void before(String commands) throws IOException {
        Files.writeString(folder.resolve("gate.sh"), "#!/bin/sh\ncd '" + folder + "'\n" + commands
            + "\nexec \"$@\"\n");
    }

    /** Lets each bot behind the first ones wait for the file {@code go}. */
    private void holdBotsBehind(int first) throws IOException {
        before("echo >>starts; [ $(wc -l <starts) -le " + first + " ] || until [ -e go ]; do sleep 0.02; done");
    }

    private void letBotsGo() throws IOException {
        Files.createFile(folder.resolve("go"));
    }

    private int starts() {
        return (int) read("starts").lines().count();
    }

    @AfterEach
    void end() throws InterruptedException {
        for (Process process : started) {
            process.destroyForcibly().waitFor();
        }
    }

    private static String done(String... words) {
        Cli cli = Cli.run(List.of("league"), words).done();
        return cli.out() + cli.err();
    }

    /** Serves the league, which plays nothing itself unless it is told to; the bots are not asked again. */
    private CompletableFuture<String> serve(int games, int threads) {
        return CompletableFuture.supplyAsync(() -> {
            int status = Main.run(new Streams(leagueSays, leagueSays, false, false), "league", "run",
                folder.resolve("night").toString(), "--games", Integer.toString(games), "--threads",
                Integer.toString(threads), "--again", "0", "--serve", "127.0.0.1:" + port);
            assertEquals(0, status, leagueSays::toString);
            return leagueSays.toString(StandardCharsets.UTF_8);
        }, THREADS);
    }

    /** Words of a worker with a new token. */
    private String[] joining(String name, String... options) {
        done("worker", "add", folder.resolve("night").toString(), name, "--out", token(name).toString());
        return Cli.words(List.of("worker", "--join", "127.0.0.1:" + port, "--token-file", token(name).toString(),
            "--bundles", folder.resolve("bundles " + name).toString(), "--sandbox", "off"), options);
    }

    /** A worker in this JVM, with a new token. */
    private CompletableFuture<Cli> here(String name, String... options) {
        String[] words = joining(name, options);
        return CompletableFuture.supplyAsync(() -> Cli.run(words), THREADS);
    }

    /** Plays what is left, in this JVM, and returns what the league has said. */
    private String rest(CompletableFuture<String> league) throws Exception {
        Path stop = folder.resolve("rest.stop");
        CompletableFuture<Cli> rest = here("rest", "--stop-file", stop.toString());
        String said = league.get(200, TimeUnit.SECONDS);
        Files.createFile(stop);
        assertEquals(0, end(rest).status(), () -> rest.join().err());
        return said;
    }

    /** A worker with a new token, after the words of {@code before}. */
    private Process worker(String name, List<String> before, String... options) throws IOException {
        List<String> words = new ArrayList<>(before);
        words.addAll(JavaProcess.words(Main.class, joining(name, options)));
        Process process = new ProcessBuilder(words).directory(folder.toFile())
            .redirectOutput(folder.resolve(name + ".out").toFile())
            .redirectError(folder.resolve(name + ".err").toFile()).start();
        started.add(process);
        return process;
    }

    private Path token(String name) {
        return folder.resolve(name + ".token");
    }

    private String read(String file) {
        try {
            return Files.readString(folder.resolve(file), StandardCharsets.UTF_8);
        } catch (IOException problem) {
            return problem.toString();
        }
    }

    private static void await(BooleanSupplier condition) throws InterruptedException {
        while (!condition.getAsBoolean()) {
            TimeUnit.MILLISECONDS.sleep(50);
        }
    }

    /** The games that a worker has played and that are stored. */
    private int stored(String worker) {
        List<StoredGame> games = new ArrayList<>();
        try (GameStore store = GameStore.read(new LeagueFolder(folder.resolve("night")))) {
            Season season = store.lastSeason().orElse(null);
            if (season != null) {
                new GameQueries(store, store.season(season).orElseThrow(), season).games(games::add);
            }
        }
        assertEquals(games.size(), games.stream().map(game -> game.decision() + " " + List.of(game.seats().get(0)
            .version())).distinct().count(), "each is stored once");
        return (int) games.stream().filter(game -> game.machine().startsWith("worker " + worker + ": ")).count();
    }

    private int end(Process process, CompletableFuture<String> league) throws InterruptedException {
        assertTrue(process.waitFor(100, TimeUnit.SECONDS), () -> "it does not end; the league "
            + (league.isDone() ? "has ended" : "plays"));
        return process.exitValue();
    }

    /** Workers of one league, in this JVM: one after another, so that none takes the games of those before. */
    @Test
    @Tag("campaign")
    void endsAfterSoManyGamesOrSoMuchTimeOrWhenItIsIdleOrAFileSaysSo() throws Exception {
        before("sleep 0.2");
        CompletableFuture<String> league = serve(14, 0);
        Cli three = end(here("three", "--games", "3", "--threads", "2")).done();
        assertEquals("3 games played\n", three.out());
        Path stop = folder.resolve("stop");
        CompletableFuture<Cli> told = here("told", "--stop-file", stop.toString(), "--threads", "1", "--json");
        await(() -> stored("told") >= 1 || league.isDone());
        Files.createFile(stop);
        assertEquals(0, end(told).status(), () -> told.join().err());
        assertTrue(told.join().err().matches("(?s)\\{\"time\":\"\\d{4}-[^\"]*Z\",\"event\":\"joined 127.0.0.1:.*"),
            told.join().err());
        final long began = System.nanoTime();
        Cli brief = end(here("brief", "--for", "1s", "--threads", "1")).done();
        assertTrue(System.nanoTime() - began >= TimeUnit.SECONDS.toNanos(1));
        assertFalse(league.isDone(), "there is no time for all that is left");
        CompletableFuture<Cli> idle = here("idle", "--idle", "1s");
        String said = rest(league);
        assertEquals(0, end(idle).status(), () -> idle.join().err());
        assertTrue(said.contains("14 games of duel\n"), said);
        assertEquals(3, stored("three"), said);
        assertTrue(stored("told") >= 1, said);
        assertEquals(stored("brief") + (stored("brief") == 1 ? " game" : " games") + " played\n", brief.out());
    }

    private static Cli end(CompletableFuture<Cli> worker) throws Exception {
        return worker.get(100, TimeUnit.SECONDS);
    }

    /** The league plays its game itself when the worker has been refused. */
    @Test
    void differsWhenItIsRefused() throws Exception {
        done("worker", "add", folder.resolve("night").toString(), "gone", "--out", token("gone").toString());
        done("worker", "revoke", folder.resolve("night").toString(), "gone");
        holdBotsBehind(0);
        CompletableFuture<String> league = serve(1, 1);
        Cli cli = Cli.run("worker", "--join", "127.0.0.1:" + port, "--token-file", token("gone").toString(),
            "--sandbox", "off");
        assertEquals(3, cli.status(), cli.err());
        assertTrue(cli.err().contains("the league refuses the token: it is wrong or revoked"), cli.err());
        letBotsGo();
        assertTrue(league.get(100, TimeUnit.SECONDS).contains("1 game of duel\n"));
    }

    /** The worker tries each of the two bots against itself, and is told to end in its third or fourth game. */
    @Test
    void ctrlCFinishesTheGamesThatAreUnderWay() throws Exception {
        ScriptedBots.assumeInterruptible();
        int trials = 4;
        holdBotsBehind(trials + 4);
        CompletableFuture<String> league = serve(8, 0);
        Process worker = worker("ending", List.of(), "--threads", "2");
        await(() -> starts() > trials + 4 || league.isDone());
        new ProcessBuilder("kill", "-s", "INT", Long.toString(worker.pid())).start().waitFor();
        await(() -> read("ending.err").contains("the games that are under way are finished, no others begun\n")
            || league.isDone());
        letBotsGo();
        assertEquals(INTERRUPTED, end(worker, league), () -> read("ending.err"));
        int begun = starts() - trials;
        String said = rest(league);
        assertTrue(said.contains("8 games of duel\n"), said);
        int after = stored("ending");
        assertEquals(begun, 2 * after, "each game that was begun is finished and stored; " + read("ending.err"));
        assertTrue(after >= 1 && after <= 4, () -> "found " + after + " games, expected no others: " + said);
        assertTrue(read("ending.err").endsWith("interrupted; " + after + " games played\n"), read("ending.err"));
    }

    /**
     * The files of the worker may have 4 KiB each: beyond that the system refuses to write, as on a full disk. The
     * league waits in its first game: the bot that the worker cannot have is held, the other one it tries.
     */
    @Test
    @Tag("campaign")
    void aWorkerThatCannotStoreABotSaysSoAndOthersPlay() throws Exception {
        Path weights = folder.resolve("weights.bin");
        Files.write(weights, new byte[40_000]);
        before("case \"$*\" in *drive*) until [ -e go ]; do sleep 0.02; done ;; esac");
        Path settings = folder.resolve("night/league.json");
        Files.writeString(settings, Files.readString(settings).replaceFirst("\"name\": \"fast\"", "\"files\": [\""
            + weights + "\", \"" + folder.resolve("gate.sh") + "\", \"" + folder.resolve("text pod.sh")
            + "\"], $0"));
        CompletableFuture<String> league = serve(8, 1);
        Process small = worker("small", List.of("sh", "-c", "ulimit -f 8; exec \"$0\" \"$@\""));
        await(() -> leagueSays.toString().contains(" cannot play a bot: ") || league.isDone());
        letBotsGo();
        String said = rest(league);
        assertTrue(said.contains("8 games of duel\n"), said);
        assertEquals(0, stored("small"));
        assertTrue(read("small.err").matches("(?s).*steward: \\S+ fast: \\S.*: the bundle cannot be unpacked: [^\n]*\n"
            + ".*"), read("small.err"));
        assertTrue(said.contains("Z worker small cannot play a bot: fast: "), said);
        assertTrue(small.isAlive(), "it waits for games that it can play");
        try (Stream<Path> left = Files.list(folder.resolve("bundles small"))) {
            assertFalse(left.anyMatch(path -> path.getFileName().toString().startsWith("unpacking")));
        }
    }

    @Test
    void aTokenThatOthersCanReadIsWarnedOf() throws Exception {
        done("worker", "add", folder.resolve("night").toString(), "open", "--out", token("open").toString());
        Files.setPosixFilePermissions(token("open"), PosixFilePermissions.fromString("rw-r--r--"));
        Cli cli = Cli.run("worker", "--join", "no-such-host.invalid:1", "--token-file", token("open").toString(),
            "--sandbox", "off");
        assertEquals(3, cli.status(), cli.err());
        assertTrue(cli.err().contains("expected a file of yours alone: chmod 600 " + token("open")), cli.err());
        assertTrue(cli.err().contains("no-such-host.invalid:1: found an unknown host"), cli.err());
    }

    @Test
    void aPortThatIsTakenIsNamedBeforeAnyGame() throws Exception {
        try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            String address = "127.0.0.1:" + taken.getLocalPort();
            Cli.run("league", "run", folder.resolve("night").toString(), "--games", "8", "--serve", address)
                .assertRefused("nothing can listen at " + address);
        }
        assertEquals(0, stored("any"));
    }

    @Test
    void aBotThatIsTooLargeIsNamedBeforeAnyGame() throws Exception {
        Path weights = folder.resolve("weights.bin");
        try (RandomAccessFile file = new RandomAccessFile(weights.toFile(), "rw")) {
            file.setLength((64 << 20) + 1);
        }
        Path settings = folder.resolve("night/league.json");
        Files.writeString(settings, Files.readString(settings).replaceFirst("\"name\": \"fast\"", "\"files\": [\""
            + weights + "\"], $0"));
        Cli cli = Cli.run("league", "run", folder.resolve("night").toString(), "--games", "8", "--serve",
            "127.0.0.1:" + port);
        cli.assertRefused("bot 'fast': found 67109");
        assertTrue(cli.err().contains(" bytes of files up to " + weights + ", expected at most 67108864 (64 MiB) for "
            + "workers"), cli.err());
        assertEquals(0, stored("any"));
    }
}
