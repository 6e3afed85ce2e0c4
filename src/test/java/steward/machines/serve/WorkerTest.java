package steward.machines.serve;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.net.ssl.SSLException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.isolation.Isolation;
import steward.cli.Cli;
import steward.cli.ShellBots;
import steward.cli.TextShellBots;
import steward.cli.shared.Games;
import steward.contest.Contest;
import steward.files.InputException;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Season;
import steward.league.store.GameQueries;
import steward.league.store.GameStore;
import steward.machines.broker.BrokerClient;
import steward.machines.broker.BrokerClient.BrokenException;
import steward.machines.bundle.Bundle;
import steward.machines.check.TranscriptWriter;
import steward.machines.token.BrokerKey;
import steward.machines.token.WorkerToken;
import steward.machines.wire.GameJob;
import steward.machines.wire.HeaderText;
import steward.machines.wire.WireMessage;
import steward.machines.wire.WorkerWord;
import steward.machines.worker.Worker;
import steward.match.Protocol;
import steward.scene.RungLaw;

/** A league whose games workers play, in this JVM: honest ones, forging ones, and such as may not. */
@Tag("process")
@Tag("slow")
@Timeout(300)
class WorkerTest {

    @TempDir
    private Path folder;

    private TextShellBots bots;
    private int port;
    private final Map<Worker, Thread> playing = new HashMap<>();

    @BeforeEach
    void prepare() throws IOException {
        assumeTrue(ShellBots.runnable(), "skipped: there is no /bin/sh");
        ShellBots.shortDuel(folder);
        ShellBots.drawn(folder.resolve("short.json"));
        bots = new TextShellBots(folder);
        try (ServerSocket free = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            port = free.getLocalPort();
        }
    }

    private String done(String... words) {
        Cli cli = Cli.league(folder, words).done();
        return cli.out() + cli.err();
    }

    private void make(String name) {
        done("init", "TMP/" + name, "--scene", "TMP/short.json", "--seed", "5");
        done("add", "TMP/" + name, "fast=codingame:" + bots.driver());
        done("add", "TMP/" + name, "still=codingame:" + bots.idler(0));
        done("add", "TMP/" + name, "wrong=codingame:" + bots.idler(3));
    }

    private WorkerToken token(String league, String worker) {
        done("worker", "add", "TMP/" + league, worker, "--out", "TMP/" + worker + ".token");
        return WorkerToken.read(folder.resolve(worker + ".token"));
    }

    private CompletableFuture<String> serve(String league, int games, String... more) {
        List<String> words = new ArrayList<>(List.of("run", "TMP/" + league, "--games", Integer.toString(games),
            "--serve", "127.0.0.1:" + port));
        words.addAll(List.of(more));
        return CompletableFuture.supplyAsync(() -> done(words.toArray(new String[0])));
    }

    private Worker worker(WorkerToken token, int slots, long games) {
        return new Worker(new Worker.Options("127.0.0.1", port, token, slots, games, Long.MAX_VALUE,
            () -> Isolation.OFF, folder.resolve("bundles of " + token.worker()), "1", "a machine of the test"),
            Games.types(), what -> { });
    }

    /** Plays until the league does not answer any more. */
    private Thread play(Worker worker) {
        Thread thread = new Thread(() -> {
            try {
                worker.play();
            } catch (InterruptedException | InputException end) {
                return;
            }
        });
        thread.setDaemon(true);
        thread.start();
        playing.put(worker, thread);
        return thread;
    }

    /** Workers try for ever to join a league that has ended. */
    @AfterEach
    void endWorkers() throws InterruptedException {
        playing.keySet().forEach(Worker::drain);
        for (Thread thread : playing.values()) {
            thread.join();
        }
    }

    /** A connection, as soon as the league listens. */
    private BrokerClient client(WorkerToken token) throws BrokenException, InterruptedException {
        return join(port, token);
    }

    static BrokerClient join(int port, WorkerToken token) throws BrokenException, InterruptedException {
        for (int tries = 0; ; tries++) {
            try {
                return new BrokerClient("127.0.0.1", port, token, "process of " + token.worker());
            } catch (BrokenException notYet) {
                if (notYet.isRefused() || tries == 300) {
                    throw notYet;
                }
                TimeUnit.MILLISECONDS.sleep(100);
            }
        }
    }

    private record Row(String game, String machine, String problem, boolean counts) {
    }

    private List<Row> games(String league) {
        List<Row> rows = new ArrayList<>();
        try (GameStore store = GameStore.read(new LeagueFolder(folder.resolve(league)))) {
            Map<Integer, String> names = new HashMap<>();
            store.versions().forEach(version -> names.put(version.id(), version.display()));
            Season season = store.lastSeason().orElseThrow();
            new GameQueries(store, store.season(season).orElseThrow(), season).games(game -> rows.add(new Row(
                game.decision() + " " + game.seed() + " " + game.attempt() + " " + game.turns() + " "
                    + game.seats().stream().map(seat -> names.get(seat.version()) + ":" + seat.rank() + ":"
                        + seat.score() + ":" + seat.fault() + ":" + seat.answers()).toList(),
                game.machine(), game.problem(), game.counts())));
        }
        return rows;
    }

    private List<String> counting(String league) {
        return games(league).stream().filter(Row::counts).map(Row::game).sorted().toList();
    }

    @Test
    void theGamesAreThoseOfASingleMachine() throws Exception {
        make("alone");
        done("run", "TMP/alone", "--games", "100", "--quiet");
        make("many");
        WorkerToken one = token("many", "one");
        WorkerToken two = token("many", "two");
        CompletableFuture<String> run = serve("many", 100);
        play(worker(one, 2, Long.MAX_VALUE));
        play(worker(two, 1, Long.MAX_VALUE));
        String said = run.get(200, TimeUnit.SECONDS);

        assertEquals(counting("alone"), counting("many"), said);
        assertTrue(games("many").stream().anyMatch(row -> row.machine().startsWith("worker one: a machine of")), said);
        assertTrue(said.contains("worker one: 2 at a time, "), said);
    }

    /**
     * Plays three games as it should, and then answers for the bot that loses as another would: everything in its
     * transcripts follows from the commands.
     */
    private void forge(BrokerClient client) throws BrokenException, InterruptedException {
        hello(client, "a forge");
        try (BrokerClient.Taker taker = client.taker(List.of())) {
            for (int games = 0;;) {
                byte[] bytes = taker.take(500);
                if (bytes == null) {
                    continue;
                }
                GameJob job = GameJob.read(bytes, "a job", Bundle.LARGEST);
                List<WorkerWord.Played> played = new ArrayList<>();
                for (GameJob.Game game : job.games()) {
                    played.add(played(game, games++ < 3));
                }
                taker.finish(new WorkerWord.Result(job.id(), played).bytes());
            }
        }
    }

    private WorkerWord.Played played(GameJob.Game game, boolean honest) throws InterruptedException {
        List<String> commands = game.seats().stream().map(GameJob.Seat::name).map(name -> name + "=codingame:"
            + (name.equals("fast") != honest ? bots.idler(honest && name.equals("wrong") ? 3 : 0)
                : bots.driver())).toList();
        Contest contest = Contest.of(Games.open(folder.resolve("short.json").toString()), commands,
            Protocol.JSON, 1).isolatedBy(() -> Isolation.OFF);
        TranscriptWriter transcript = new TranscriptWriter(commands, "off");
        contest.play(game.seed(), 0, null, transcript);
        return new WorkerWord.Played(List.of(transcript.compressed()), List.of(false), null);
    }

    private static void hello(BrokerClient client, String machine) throws BrokenException {
        client.say(WireMessage.bytes(new HeaderText().put("type", "hello").put("version", "1")
            .put("bits", RungLaw.keys()).put("machine", machine).put("slots", 1)));
    }

    /** Plays the first games of a job as it should. */
    private void report(BrokerClient.Taker taker, GameJob job, int games) throws BrokenException, InterruptedException {
        List<WorkerWord.Played> played = new ArrayList<>();
        for (GameJob.Game game : job.games().subList(0, games)) {
            played.add(played(game, true));
        }
        taker.finish(new WorkerWord.Result(job.id(), played).bytes());
    }

    /** Of each second job it leaves out the last game, if it has several; how many it has left out. */
    private int leaveOut(BrokerClient client, CompletableFuture<String> run) throws BrokenException,
            InterruptedException {
        int left = 0;
        hello(client, "lazy");
        try (BrokerClient.Taker taker = client.taker(List.of())) {
            for (int jobs = 0; !run.isDone();) {
                byte[] bytes = taker.take(500);
                if (bytes == null) {
                    continue;
                }
                GameJob job = GameJob.read(bytes, "a job", Bundle.LARGEST);
                int games = Math.max(1, job.games().size() - jobs++ % 2);
                left += job.games().size() - games;
                report(taker, job, games);
            }
        } catch (BrokenException closed) {
            run.join();                                // which has ended, then
        }
        return left;
    }

    @Test
    void gamesOfAJobThatWereNotBegunArePlayedLater() throws Exception {
        make("alone");
        done("run", "TMP/alone", "--games", "60", "--quiet");
        make("many");
        WorkerToken token = token("many", "lazy");
        CompletableFuture<String> run = serve("many", 60, "--quiet");
        try (BrokerClient client = client(token)) {
            int left = leaveOut(client, run);
            assertEquals(counting("alone"), counting("many"), () -> left + " left out");
        }
    }

    /** A full disk, say: it is told once, and not for each game. */
    @Test
    void whyAWorkerPlaysNoGameIsToldOnce() throws Exception {
        make("many");
        WorkerToken token = token("many", "full");
        CompletableFuture<String> run = serve("many", 60, "--threads", "1");
        int jobs = 0;
        try (BrokerClient client = client(token)) {
            hello(client, "full");
            try (BrokerClient.Taker taker = client.taker(List.of())) {
                while (!run.isDone()) {
                    byte[] bytes = taker.take(500);
                    if (bytes != null) {
                        GameJob job = GameJob.read(bytes, "a job", Bundle.LARGEST);
                        taker.finish(new WorkerWord.Result(job.id(), List.of(new WorkerWord.Played(List.of(), List.of(),
                            "no space left on device"))).bytes());
                        jobs++;
                    }
                }
            }
        } catch (BrokenException closed) {
            run.join();                                // which has ended, then
        }
        String said = run.join();
        assertEquals(jobs == 0 ? 1 : 2, said.split("full could not play a game: no space left", -1).length, said);
    }

    @Test
    void aWorkerThatForgesBesideAnHonestOneIsCaughtRevokedAndItsGamesAreSetAside() throws Exception {
        make("alone");
        done("run", "TMP/alone", "--games", "60", "--quiet");
        make("many");
        WorkerToken token = token("many", "bad");
        WorkerToken other = token("many", "good");
        CompletableFuture<String> run = serve("many", 60, "--threads", "1");
        play(worker(other, 1, Long.MAX_VALUE));
        try (BrokerClient client = client(token)) {
            assertThrows(BrokenException.class, () -> forge(client), "its connection is closed");
        }
        String said = run.get(200, TimeUnit.SECONDS);

        assertTrue(said.contains("worker bad is caught and revoked: "), said);
        assertTrue(said.contains("answers otherwise when it is asked again"), said);
        Matcher count = Pattern.compile("; ([1-3]) of its games are set aside and played again").matcher(said);
        assertTrue(count.find(), said);
        String heading = "60 games of duel, " + count.group(1) + " more set aside, of workers that were caught\n";
        assertTrue(said.contains(heading), said);
        String table = done("table", "TMP/many");
        assertTrue(table.startsWith(heading), table);
        assertTrue(table.contains("worker bad: caught, 0 games, " + count.group(1)
            + " more set aside, 0 faults, 0 hiccups\n"), table);
        assertTrue(done("table", "TMP/many", "--json").contains("\"workers\":[{\"name\":\"bad\",\"state\":\"caught\","
            + "\"games\":0,\"aside\":" + count.group(1) + ","));
        done("page", "TMP/many", "--out", "TMP/page.html");
        assertTrue(Files.readString(folder.resolve("page.html")).contains("\"name\":\"bad\",\"state\":\"caught\""));
        assertEquals(counting("alone"), counting("many"), said);
        assertTrue(games("many").stream().noneMatch(row -> row.counts() && row.machine().startsWith("worker bad")));
        assertTrue(done("worker", "list", "TMP/many").contains("bad (revoked: caught: game of seed "));
        try (RemoteGames games = served("many")) {
            assertTrue(games.seen().isEmpty());
            assertTrue(refused(token).contains("wrong or revoked"), "also by the next run");
        }
    }

    /** Plays what it is given, but has no bot of one name; how many games it has played. */
    private int without(String bot, BrokerClient client, CompletableFuture<String> run) throws BrokenException,
            InterruptedException {
        List<String> unfit = new ArrayList<>();
        int games = 0;
        hello(client, "bare");
        try {
            while (!run.isDone()) {
                try (BrokerClient.Taker taker = client.taker(unfit)) {
                    byte[] bytes = taker.take(500);
                    if (bytes == null) {
                        continue;
                    }
                    GameJob job = GameJob.read(bytes, "a job", Bundle.LARGEST);
                    job.games().stream().flatMap(game -> game.seats().stream()).filter(seat -> seat.name().equals(bot))
                        .forEach(seat -> unfit.add(seat.bundle()));
                    if (!unfit.isEmpty() && job.games().stream().anyMatch(game -> game.seats().stream()
                            .anyMatch(seat -> unfit.contains(seat.bundle())))) {
                        client.say(WireMessage.bytes(new HeaderText().put("type", "unfit").put("bundle", unfit.get(0))
                            .put("reason", bot + " does not run here")));
                        continue;
                    }
                    report(taker, job, job.games().size());
                    games += job.games().size();
                }
            }
        } catch (BrokenException closed) {
            run.join();                                // which has ended, then
        }
        return games;
    }

    @Test
    void gamesOfABotThatRunsOnNoWorkerArePlayedByTheLeague() throws Exception {
        make("alone");
        done("run", "TMP/alone", "--games", "100", "--quiet");
        make("many");
        WorkerToken token = token("many", "bare");
        CompletableFuture<String> run = serve("many", 100, "--threads", "1");
        try (BrokerClient client = client(token)) {
            int games = without("still", client, run);
            assertEquals(counting("alone"), counting("many"), () -> games + " games of the worker");
            assertTrue(games("many").stream().noneMatch(row -> row.machine().startsWith("worker bare")
                && row.game().contains("still")));
            assertTrue(run.join().contains("worker bare cannot play a bot: still does not run here"), run.join());
        }
    }

    /** Each has another bot that does not run there: a job must not need both. */
    @Test
    void twoWorkersThatBothLackABotPlayTheGamesThatTheyCan() throws Exception {
        make("alone");
        done("run", "TMP/alone", "--games", "101", "--quiet");
        make("many");
        WorkerToken one = token("many", "one");
        WorkerToken two = token("many", "two");
        CompletableFuture<String> run = serve("many", 101, "--threads", "1");
        try (BrokerClient first = client(one); BrokerClient second = client(two)) {
            CompletableFuture<Integer> other = CompletableFuture.supplyAsync(() -> {
                try {
                    return without("wrong", second, run);
                } catch (BrokenException | InterruptedException problem) {
                    throw new IllegalStateException(problem);
                }
            });
            int games = without("still", first, run) + other.join();
            assertEquals(counting("alone"), counting("many"), () -> games + " games of the workers");
            assertTrue(games("many").stream().noneMatch(row -> row.machine().startsWith("worker one")
                && row.game().contains("still") || row.machine().startsWith("worker two")
                && row.game().contains("wrong")));
        }
    }

    @Test
    void whoMayNotJoinIsRefused() throws Exception {
        make("many");
        WorkerToken good = token("many", "good");
        BrokerKey key = new BrokerKey(new LeagueFolder(folder.resolve("many")));
        String fingerprint = key.fingerprint();
        done("worker", "renew", "TMP/many");
        assertEquals(fingerprint, key.fingerprint(), "the key stays");
        try (RemoteGames games = served("many"); BrokerClient older = client(good);
             BrokerClient client = new BrokerClient("127.0.0.1", port, good, "a newer process")) {
            assertTrue(games.seen().isEmpty());
            assertThrows(BrokenException.class, () -> listen(older), "the newer one has taken over");
            assertTrue(refused(new WorkerToken("good", "x".repeat(43), good.broker())).contains("wrong or revoked"));
            assertTrue(refused(new WorkerToken("nobody", good.secret(), good.broker())).contains("wrong or revoked"));
            assertTrue(refused(new WorkerToken("good", good.secret(), "0".repeat(64))).contains("has another key"));
            assertTrue(refused(good).contains("another worker plays with this token"));
            try (Socket plain = new Socket("127.0.0.1", port); InputStream in = plain.getInputStream()) {
                plain.getOutputStream().write("ARTEMIS\n\n\n\n\n\n\n\n".getBytes(StandardCharsets.UTF_8));
                plain.setSoTimeout(30_000);
                int first = in.read();
                assertTrue(first < 0 || first == 21, "closed, or an alert of TLS: " + first);
            }
            assertThrows(SSLException.class, () -> TrustingClient.shakeHands(port, "TLSv1.2"));
            assertEquals("TLSv1.3", TrustingClient.shakeHands(port, "TLSv1.3"),
                "the same client in the version that is wanted");
            done("worker", "revoke", "TMP/many", "good");
            assertThrows(BrokenException.class, () -> listen(client));
            assertTrue(refused(good).contains("wrong or revoked"));
        }
    }

    private static byte[] listen(BrokerClient client) throws BrokenException {
        byte[] answer = null;
        while (answer == null) {
            answer = client.listen(500);
        }
        return answer;
    }

    /** A league that serves and gives no games out. */
    private RemoteGames served(String league) {
        return served(league, what -> { });
    }

    private RemoteGames served(String league, Consumer<String> teller) {
        LeagueFolder here = new LeagueFolder(folder.resolve(league));
        LeagueSettings settings = here.read();
        Contest contest = Contest.withoutBots(Games.open(here.scene(settings.scene())), 1);
        return new RemoteGames(here, Season.of(contest.setup(), settings), contest, settings, Games.types(),
            new RemoteGames.Service(new InetSocketAddress("127.0.0.1", port), 0.05, Long.MAX_VALUE, "1"), teller);
    }

    private String refused(WorkerToken token) {
        BrokenException problem = assertThrows(BrokenException.class,
            () -> new BrokerClient("127.0.0.1", port, token, "process of " + token.worker()).close());
        assertTrue(problem.isRefused(), problem.getMessage());
        return problem.getMessage();
    }

    @Test
    void versionsThatComputeOtherResultsDoNotPlayTogether() throws Exception {
        make("many");
        WorkerToken token = token("many", "old");
        List<String> told = new CopyOnWriteArrayList<>();
        try (RemoteGames games = served("many", told::add); BrokerClient client = client(token)) {
            assertTrue(games.seen().isEmpty());
            client.say(WireMessage.bytes(new HeaderText().put("type", "hello").put("version", "0.0.9")
                .put("bits", "0123456789abcdef").put("machine", "an old machine").put("slots", 1)));
            WireMessage message = WireMessage.read(listen(client), "the league");
            assertEquals("refused", message.header().text("type"));
            String reason = message.header().text("reason");
            assertEquals("found Steward 0.0.9 (results 0123456789abcdef) on worker old and Steward 1 (results "
                + RungLaw.WHOLE_LADDER + ") in the league, expected versions that compute the same", reason);
            assertEquals(List.of(reason), told, "the league says it, too");

            client.say(WireMessage.bytes(new HeaderText().put("type", "hello").put("version", "0.0.8")
                .put("bits", RungLaw.keys()).put("machine", "a machine").put("slots", 2)));
            client.say(WireMessage.bytes(new HeaderText().put("type", "differs").put("rules", "fedcba9876543210")));
            while (told.size() < 3) {
                TimeUnit.MILLISECONDS.sleep(10);
            }
            assertTrue(told.get(2).startsWith("found Steward 0.0.8 (results fedcba9876543210) on worker old and "
                + "Steward 1 (results "), told::toString);
            assertEquals(0, games.seen().get(0).slots(), "it is given no games");
        }
    }
}
