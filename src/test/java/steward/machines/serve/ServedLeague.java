package steward.machines.serve;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.command.Platform;
import steward.bot.isolation.Isolation;
import steward.cli.Cli;
import steward.cli.FreePort;
import steward.cli.ShellBots;
import steward.cli.TextShellBots;
import steward.cli.shared.Games;
import steward.contest.Contest;
import steward.files.InputException;
import steward.game.GameTypes;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Schedule;
import steward.league.Season;
import steward.league.play.RemoteMachines;
import steward.league.play.Roster.Member;
import steward.league.store.GameQueries;
import steward.league.store.GameStore;
import steward.machines.broker.BrokerClient;
import steward.machines.broker.BrokerClient.BrokenException;
import steward.machines.token.BrokerKey;
import steward.machines.token.SharedBrokerKey;
import steward.machines.token.WorkerToken;
import steward.machines.wire.GameJob;
import steward.machines.wire.WorkerWord;
import steward.machines.worker.Worker;
import steward.match.Protocol;

/** Leagues in a temporary folder whose games are played by workers in this JVM. */
abstract class ServedLeague {

    private static final Map<String, List<String>> ALONE = new HashMap<>();

    @TempDir
    Path folder;

    TextShellBots bots;
    int port;
    final Map<Worker, Thread> playing = new HashMap<>();

    @BeforeEach
    void prepare() throws IOException {
        ShellBots.shortDuel(folder);
        ShellBots.drawn(folder.resolve("short.json"));
        bots = new TextShellBots(folder);
        port = FreePort.next();
    }

    String done(String... words) {
        Cli cli = Cli.league(folder, words).done();
        return cli.out() + cli.err();
    }

    void make(String name) {
        done("init", "TMP/" + name, "--scene", "TMP/short.json", "--seed", "5");
        done("add", "TMP/" + name, "fast=codingame:" + bots.driver());
        done("add", "TMP/" + name, "still=codingame:" + bots.idler(0));
        done("add", "TMP/" + name, "wrong=codingame:" + bots.idler(3));
    }

    /** Games of a league on a single machine, which is played once for all tests of a JVM. */
    List<String> alone(int games, int lag, String... more) throws IOException {
        List<String> words = new ArrayList<>(List.of("run", "TMP/alone", "--games", Integer.toString(games),
            "--quiet"));
        words.addAll(List.of(more));
        synchronized (ALONE) {
            String key = words + ", lag " + lag;
            if (!ALONE.containsKey(key)) {
                make("alone");
                lag("alone", lag);
                done(words.toArray(new String[0]));
                ALONE.put(key, counting("alone"));
            }
            return ALONE.get(key);
        }
    }

    /** Sets how many decisions back results are known. */
    void lag(String league, int lag) throws IOException {
        Path settings = folder.resolve(league + "/league.json");
        Files.writeString(settings, Files.readString(settings).replaceFirst("\"lag\": \\d+", "\"lag\": " + lag));
    }

    /** A new token; the first one of a league comes with the key of its broker. */
    WorkerToken token(String league, String worker) throws IOException {
        LeagueFolder here = new LeagueFolder(folder.resolve(league));
        if (!Files.exists(new BrokerKey(here).store())) {
            SharedBrokerKey.put(here);
        }
        done("worker", "add", "TMP/" + league, worker, "--out", "TMP/" + worker + ".token");
        return WorkerToken.read(folder.resolve(worker + ".token"));
    }

    CompletableFuture<String> serve(String league, int games, String... more) {
        List<String> words = new ArrayList<>(List.of("run", "TMP/" + league, "--games", Integer.toString(games),
            "--serve", "127.0.0.1:" + port));
        words.addAll(List.of(more));
        return CompletableFuture.supplyAsync(() -> done(words.toArray(new String[0])));
    }

    Worker worker(WorkerToken token, int slots, long games) {
        return worker(token, slots, games, Games.types());
    }

    Worker worker(WorkerToken token, int slots, long games, GameTypes types) {
        return new Worker(new Worker.Options("127.0.0.1", port, token, slots, games, Long.MAX_VALUE,
            () -> Isolation.OFF, folder.resolve("bundles of " + token.worker()), Platform.here(), "1",
            "a machine of the test"), types, what -> { });
    }

    /** Plays until the league does not answer any more. */
    Thread play(Worker worker) {
        Thread thread = new Thread(() -> {
            try {
                worker.play();
            } catch (InterruptedException | InputException | Worker.RefusedException end) {
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
    BrokerClient client(WorkerToken token) throws BrokenException, InterruptedException {
        return join(port, token);
    }

    static BrokerClient join(int port, WorkerToken token) throws BrokenException, InterruptedException {
        for (int tries = 0; ; tries++) {
            try {
                return new BrokerClient("127.0.0.1", port, token, "process of " + token.worker());
            } catch (BrokenException notYet) {
                if (notYet.isRefused() || tries == 1200) {
                    throw notYet;
                }
                TimeUnit.MILLISECONDS.sleep(100);
            }
        }
    }

    /** A game; which attempt at it this is does not matter, as those that are set aside are played again. */
    record Row(String game, String machine, String problem, boolean counts) {
    }

    List<Row> games(String league) {
        List<Row> rows = new ArrayList<>();
        try (GameStore store = GameStore.read(new LeagueFolder(folder.resolve(league)))) {
            Map<Integer, String> names = new HashMap<>();
            store.versions().forEach(version -> names.put(version.id(), version.display()));
            Season season = store.lastSeason().orElseThrow();
            new GameQueries(store, store.season(season).orElseThrow(), season).games(game -> rows.add(new Row(
                game.decision() + " " + game.seed() + " " + game.turns() + " "
                    + game.seats().stream().map(seat -> names.get(seat.version()) + ":" + seat.rank() + ":"
                        + seat.score() + ":" + seat.fault() + ":" + seat.answers()).toList(),
                game.machine(), game.problem(), game.counts())));
        }
        return rows;
    }

    List<String> counting(String league) {
        return games(league).stream().filter(Row::counts).map(Row::game).sorted().toList();
    }

    WorkerWord.Played played(GameJob.Game game) throws InterruptedException {
        List<String> commands = game.seats().stream().map(GameJob.Seat::name).map(name -> name + "=codingame:"
            + (name.equals("fast") ? bots.driver() : bots.idler(name.equals("wrong") ? 3 : 0))).toList();
        return new WorkerWord.Played(List.of(HostileWorker.transcript(folder.resolve("short.json").toString(), commands,
            game.seed(), 1)), List.of(false), null, null);
    }

    static void hello(BrokerClient client, String machine) throws BrokenException {
        HostileWorker.hello(client, machine, 1);
    }

    /** The next message of the league. */
    static byte[] listen(BrokerClient client) throws BrokenException {
        byte[] answer = null;
        while (answer == null) {
            answer = client.listen(500);
        }
        return answer;
    }

    /** Plays the first games of a job as it should. */
    void report(BrokerClient.Taker taker, GameJob job, int games) throws BrokenException, InterruptedException {
        List<WorkerWord.Played> played = new ArrayList<>();
        for (GameJob.Game game : job.games().subList(0, games)) {
            played.add(played(game));
        }
        taker.finish(new WorkerWord.Result(job.id(), played).bytes());
    }

    /** A league that serves and gives no games out. */
    RemoteGames served(String league) {
        return served(league, what -> { });
    }

    RemoteGames served(String league, Consumer<String> teller) {
        return served(league, false, teller);
    }

    RemoteGames served(String league, boolean scaled, Consumer<String> teller) {
        return served(league, scaled, Long.MAX_VALUE, teller);
    }

    RemoteGames served(String league, boolean scaled, long leaseNanos, Consumer<String> teller) {
        LeagueFolder here = new LeagueFolder(folder.resolve(league));
        LeagueSettings settings = here.read();
        Contest contest = Contest.withoutBots(Games.open(here.scene(settings.scene())), 1);
        return new RemoteGames(here, Season.of(contest.setup(), settings), contest, settings, Games.types(),
            new RemoteGames.Service(new InetSocketAddress("127.0.0.1", port), 0.05, leaseNanos, "1", scaled),
            teller);
    }

    /** A game of the first two bots of a league, which is not asked for by a run. */
    RemoteMachines.Game firstGame(String league) {
        return game(league, 0, 1);
    }

    /** A game of two bots of a league, by their places in the settings. */
    RemoteMachines.Game game(String league, int one, int other) {
        LeagueSettings settings = new LeagueFolder(folder.resolve(league)).read();
        List<Member> members = Stream.of(one, other).map(settings.active()::get).map(bot -> new Member(bot,
            new GameStore.Version(1, bot.name(), 1, bot.command(), false, bot.name(), 0, false, null),
            Contest.entrant(bot.typed(), Protocol.JSON), "", null)).toList();
        return new RemoteMachines.Game(new Schedule.Task(0, 5, 1, 1), settings, members, 1);
    }

    String refused(WorkerToken token) {
        BrokenException problem = assertThrows(BrokenException.class,
            () -> new BrokerClient("127.0.0.1", port, token, "process of " + token.worker()).close());
        assertTrue(problem.isRefused(), problem.getMessage());
        return problem.getMessage();
    }
}
