package steward.cli.machines;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import steward.bot.process.JavaProcess;
import steward.cli.Cli;
import steward.cli.FreePort;
import steward.cli.Main;
import steward.cli.ShellBots;
import steward.cli.TextShellBots;
import steward.files.InputException;
import steward.league.LeagueFolder;
import steward.league.Season;
import steward.league.store.GameQueries;
import steward.league.store.GameStore;
import steward.machines.broker.BrokerClient;
import steward.machines.broker.BrokerClient.BrokenException;
import steward.machines.broker.CutProxy;
import steward.machines.serve.HostileWorker;
import steward.machines.token.SharedBrokerKey;
import steward.machines.token.WorkerToken;

/**
 * Plays a league of deterministic bots once on a single machine, and once with three workers, each in a process of its
 * own, while everything goes wrong: one worker is killed with SIGKILL; one is stopped for a while and continued; the
 * league's process is killed with SIGKILL and started again; and all connections are cut in the middle of a message by
 * a proxy that takes no others for a while. Prints what became of the games. Exit status 1 if a game is lost or
 * doubled, if any of them or the table differs from the single machine's, or if a process prints a line that is not
 * ours.
 *
 * <p>{@code --games N} (1000), {@code --stop S} seconds (30), {@code --pause MS} before a bot begins
 * (300), so that games take a while and processors are not what decides.
 */
public class MachinesProof {

    private static final String ROW = "%-58s %s%n";
    private static final long PATIENCE_S = 1200;
    /** When less than this part of the games is left, a worker that comes back may get none of them. */
    private static final int FEW = 4;
    private static final int CLOSED_MS = 3000;

    final Path folder;
    private final int games;
    private final int stopSeconds;
    private final Consumer<String> teller;
    final List<String> problems = new ArrayList<>();
    final List<Process> started = new ArrayList<>();
    private final int pauseMs;
    int port;
    /** Ends hostile workers. */
    volatile boolean over;

    /** A game without what is measured, and which game of the schedule it is: a decision is a lineup and its mirror. */
    record Row(String place, String game, String machine, boolean counts, long played) {
    }

    MachinesProof(Path folder, int games, int stopSeconds, int pauseMs, Consumer<String> teller)
            throws IOException {
        this.folder = folder;
        this.teller = teller;
        this.games = games;
        this.stopSeconds = stopSeconds;
        this.pauseMs = pauseMs;
        ShellBots.shortDuel(folder, 20);
        Files.writeString(folder.resolve("pause.sh"), "#!/bin/sh\nsleep $1; shift; exec \"$@\"\n");
    }

    /** Reads the options, plays, prints. */
    public static void main(String[] arguments) throws Exception {
        List<String> options = List.of(arguments);
        exit(play(Files.createTempDirectory("machines-"), option(options, "--games", 1000),
            option(options, "--stop", 30), option(options, "--pause", 300), System.out::print));
    }

    /**
     * Plays.
     *
     * @param folder for all files
     * @return what is not as it should be
     */
    static List<String> play(Path folder, int games, int stopSeconds, int pauseMs, Consumer<String> teller)
            throws Exception {
        MachinesProof proof = new MachinesProof(folder, games, stopSeconds, pauseMs, teller);
        try {
            proof.play();
        } finally {
            proof.end();
        }
        return proof.problems;
    }

    static int option(List<String> options, String name, int otherwise) {
        int place = options.indexOf(name);
        return place < 0 ? otherwise : Integer.parseInt(options.get(place + 1));
    }

    void tell(String what, Object found) {
        teller.accept(String.format(ROW, what, found));
    }

    // ---- programs --------------------------------------------------------------------------------

    Process start(String name, String... arguments) throws IOException {
        Process process = new ProcessBuilder(JavaProcess.words(List.of("-Djava.io.tmpdir="
            + Files.createDirectories(folder.resolve("tmp"))), Main.class, List.of(arguments)))
            .directory(folder.toFile()).redirectOutput(folder.resolve(name + ".out").toFile())
            .redirectError(folder.resolve(name + ".err").toFile()).start();
        started.add(process);
        return process;
    }

    void run(String... arguments) {
        Cli call = Cli.run(arguments);
        if (call.status() != 0) {
            throw new IllegalStateException(call.out() + call.err());
        }
    }

    void make(String league) {
        String path = folder.resolve(league).toString();
        TextShellBots bots = new TextShellBots(folder);
        String paused = "sh '" + folder.resolve("pause.sh") + "' " + pauseMs / 1000.0 + " ";
        run("league", "init", path, "--scene", folder.resolve("short.json").toString(), "--seed", "5");
        run("league", "add", path, "fast=codingame:" + paused + bots.driver());
        run("league", "add", path, "still=codingame:" + paused + bots.idler(0));
        run("league", "add", path, "wrong=codingame:" + paused + bots.idler(3));
        run("league", "add", path, "later=codingame:" + paused + bots.idler(6));
    }

    Process worker(String name, int join) throws IOException {
        return start("worker " + name, "worker", "--join", "127.0.0.1:" + join, "--token-file",
            folder.resolve(name + ".token").toString(), "--bundles", folder.resolve("bundles " + name).toString(),
            "--sandbox", "off");
    }

    /** Gives a worker a token of the league with workers. */
    void add(String name) {
        run("league", "worker", "add", folder.resolve("many").toString(), name, "--out",
            folder.resolve(name + ".token").toString());
    }

    /** Starts a hostile worker, which joins again whenever it is sent away. */
    Thread hostile(String name, HostileWorker.Way way) {
        WorkerToken token = WorkerToken.read(folder.resolve(name + ".token"));
        TextShellBots bots = new TextShellBots(folder);
        HostileWorker worker = new HostileWorker(way, folder.resolve("short.json").toString(), (bot, honest) ->
            "codingame:" + (bot.equals("fast") == honest ? bots.driver() : bots.idler(!honest ? 0
                : bot.equals("wrong") ? 3 : bot.equals("later") ? 6 : 0)));
        Thread thread = new Thread(() -> {
            while (!over) {
                try (BrokerClient client = new BrokerClient("127.0.0.1", port, token, name)) {
                    worker.play(client, () -> over);
                } catch (BrokenException | InputException again) {
                    pause();
                } catch (InterruptedException end) {
                    return;
                }
            }
        }, "hostile " + name);
        thread.setDaemon(true);
        thread.start();
        return thread;
    }

    private static void pause() {
        try {
            TimeUnit.MILLISECONDS.sleep(500);
        } catch (InterruptedException end) {
            Thread.currentThread().interrupt();
        }
    }

    private Process league(int number) throws IOException {
        return start("league " + number, "league", "run", "many", "--games", Integer.toString(games), "--serve",
            "127.0.0.1:" + port);
    }

    static void signal(String name, Process process) throws IOException, InterruptedException {
        new ProcessBuilder("kill", "-s", name, Long.toString(process.pid())).start().waitFor();
    }

    List<Row> rows(String league) {
        List<Row> rows = new ArrayList<>();
        LeagueFolder path = new LeagueFolder(folder.resolve(league));
        if (!Files.exists(path.database())) {
            return rows;
        }
        try (GameStore store = GameStore.read(path)) {
            Map<Integer, String> names = new HashMap<>();
            store.versions().forEach(version -> names.put(version.id(), version.display()));
            Season season = store.lastSeason().orElse(null);
            if (season != null) {
                new GameQueries(store, store.season(season).orElseThrow(), season).games(game -> rows.add(new Row(
                    game.decision() + " " + Arrays.toString(game.lineup()), game.decision() + " " + game.seed() + " "
                        + game.attempt() + " " + game.turns() + " "
                        + game.problem() + " " + game.seats().stream().map(seat -> names.get(seat.version()) + ":"
                            + seat.rank() + ":" + seat.score() + ":" + seat.fault() + ":" + seat.answers()).toList(),
                    game.machine(), game.counts(), game.played())));
            }
        } catch (InputException notYet) {
            return List.of();                          // it is just being made
        }
        return rows;
    }

    private String table(String league) {
        // The last two columns are answer times.
        return Cli.run("league", "table", folder.resolve(league).toString(), "--csv").out()
            .replaceAll("(?m),[^,\n]*,[^,\n]*$", "");
    }

    private int await(Process league, int stored, String worker) throws InterruptedException {
        return await(league, stored, worker, 0);
    }

    /** Waits until so many games are stored, and a later one of this worker among them, or the league has ended. */
    private int await(Process league, int stored, String worker, long since) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_S);
        for (;;) {
            List<Row> rows = rows("many");
            int found = rows.size();
            if (found >= stored && rows.stream().anyMatch(row -> row.machine().startsWith(worker)
                    && row.played() > since)
                || !league.isAlive()) {
                return found;
            }
            if (System.nanoTime() > end) {
                throw new IllegalStateException("found " + found + " games after " + PATIENCE_S + " s");
            }
            league.waitFor(100, TimeUnit.MILLISECONDS);
        }
    }

    // ---- the proof -------------------------------------------------------------------------------

    private void play() throws Exception {
        make("alone");
        long began = System.nanoTime();
        run("league", "run", folder.resolve("alone").toString(), "--games", Integer.toString(games), "--quiet",
            "--threads", "4");
        tell("single machine: seconds", TimeUnit.NANOSECONDS.toSeconds(System.nanoTime() - began));

        make("many");
        port = FreePort.next();
        SharedBrokerKey.put(new LeagueFolder(folder.resolve("many")));
        List.of("one", "two", "three").forEach(this::add);
        began = System.nanoTime();
        long continued;
        int left;
        try (CutProxy proxy = new CutProxy(port)) {
            Process league = league(1);
            final Process one = worker("one", proxy.port());
            final Process two = worker("two", proxy.port());
            final Process three = worker("three", proxy.port());

            tell("worker one killed (SIGKILL) after games", await(league, games / 5, "worker one"));
            one.destroyForcibly().waitFor();

            tell("worker two stopped after games", await(league, games * 3 / 10, "worker two"));
            signal("STOP", two);
            final long stopped = System.nanoTime();

            tell("league killed (SIGKILL) after games", await(league, games * 4 / 10, "worker three"));
            check(league.isAlive(), "the league had ended before it was killed");
            league.destroyForcibly().waitFor();
            league = league(2);
            long again = System.currentTimeMillis();

            tell("connections cut after games", await(league, games / 2, "worker three", again));
            int cut = proxy.cut(CLOSED_MS);
            tell("  within a message; none was taken for 3 s", cut);
            check(cut > 0, "no connection was cut within a message");

            TimeUnit.NANOSECONDS.sleep(stopped + TimeUnit.SECONDS.toNanos(stopSeconds) - System.nanoTime());
            signal("CONT", two);
            continued = System.currentTimeMillis();
            left = games - rows("many").size();
            tell("worker two continued after " + stopSeconds + " s, after games", games - left);
            check(league.isAlive(), "the league had ended before the worker was continued: more --games, or longer");

            check(league.waitFor(PATIENCE_S, TimeUnit.SECONDS) && league.exitValue() == 0, "the league does not end");
            check(two.isAlive() && three.isAlive(), "a worker has ended by itself");
        }
        tell("three workers: seconds", TimeUnit.NANOSECONDS.toSeconds(System.nanoTime() - began));
        compare(continued, left);
    }

    private void compare(long continued, int left) {
        List<Row> alone = rows("alone");
        List<Row> many = rows("many");
        Map<String, Integer> times = new TreeMap<>();
        many.stream().filter(Row::counts).forEach(row -> times.merge(row.place(), 1, Integer::sum));
        long lost = alone.stream().filter(row -> row.counts() && !times.containsKey(row.place())).count();
        long doubled = times.values().stream().mapToInt(count -> count - 1).sum();
        List<String> expected = alone.stream().map(Row::game).sorted().toList();
        List<String> found = many.stream().map(Row::game).sorted().toList();
        tell("games on the single machine", alone.size());
        tell("games with workers", many.size());
        tell("lost", lost);
        tell("doubled", doubled);
        tell("games that differ", found.stream().filter(game -> !expected.contains(game)).count());
        tell("the table is the single machine's", table("alone").equals(table("many")));
        check(alone.size() == games && lost == 0 && doubled == 0, "games are lost or doubled");
        check(expected.equals(found), "the games are others than on a single machine");
        check(table("alone").equals(table("many")), "the table is another:\n" + table("alone") + table("many"));
        Map<String, Integer> players = tellPlayers(many);
        check(players.keySet().containsAll(List.of("worker one", "worker two", "worker three")),
            "a worker has played no game: " + players);
        long later = many.stream().filter(row -> row.machine().startsWith("worker two")
            && row.played() > continued).count();
        tell("played by worker two after it was continued", later);
        check(later > 0 || left < games / FEW, "worker two has played no game after it was continued");
        for (String name : List.of("league 1", "league 2", "worker one", "worker two", "worker three")) {
            foreignLines(folder.resolve(name + ".err")).forEach(line -> problems.add(name + " prints: " + line));
        }
    }

    /** Tells how many games each worker has played, and the league. */
    Map<String, Integer> tellPlayers(List<Row> rows) {
        Map<String, Integer> players = new TreeMap<>();
        rows.forEach(row -> players.merge(row.machine().startsWith("worker ") ? row.machine().replaceAll(":.*", "")
            : "the league itself", 1, Integer::sum));
        players.forEach((player, count) -> tell("played by " + player, count));
        return players;
    }

    /** Ends what it has started. */
    void end() throws InterruptedException {
        over = true;
        started.forEach(Process::destroyForcibly);
        for (Process process : started) {
            process.waitFor();
        }
    }

    /** Prints the problems, and ends this JVM. */
    static void exit(List<String> problems) {
        problems.forEach(problem -> System.out.println("PROBLEM: " + problem));
        System.out.println(problems.size() + " problems");
        System.exit(problems.isEmpty() ? 0 : 1);
    }

    /** Lines on stderr that are not ours, such as those of a library that logs. */
    private static List<String> foreignLines(Path file) {
        try {
            return Files.readAllLines(file).stream().filter(line -> !line.startsWith("steward: ")).toList();
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }

    void check(boolean holds, String problem) {
        if (!holds) {
            problems.add(problem);
        }
    }
}
