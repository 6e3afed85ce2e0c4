package steward.cli.machines;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import steward.cli.FreePort;
import steward.league.LeagueFolder;
import steward.machines.broker.CutProxy;
import steward.machines.serve.HostileWorker.Way;
import steward.machines.token.WorkerList;

/**
 * Plays a league for a while with three honest workers and three hostile ones, and with a fault every twenty seconds: a
 * worker or the league is killed and started again, a worker is stopped, all connections are cut. One bot plays by the
 * clock. Exit status 1 if a game is lost or doubled, if an honest worker is convicted or the forger of states is not,
 * or if a worker that never answers stops the others.
 *
 * <p>{@code --minutes N} (30), {@code --seed N} (1) of the faults.
 */
public final class MachinesSoak extends MachinesProof {

    private static final List<String> HONEST = List.of("one", "two", "three");
    private static final Map<String, Way> HOSTILE = new TreeMap<>(Map.of("keeps", Way.KEEPS, "late", Way.EARLY,
        "states", Way.STATES));
    private static final long PERIOD_S = 20;
    private static final int CLOSED_MS = 1000;

    private final Map<String, Process> workers = new HashMap<>();
    /** Longest run of periods without a game. */
    private int stalled;

    private MachinesSoak(Path folder, Consumer<String> teller) throws IOException {
        super(folder, 0, 0, 50, teller);
    }

    /** Reads the options, plays, prints. */
    public static void main(String[] arguments) throws Exception {
        List<String> options = List.of(arguments);
        MachinesSoak soak = new MachinesSoak(Files.createTempDirectory("machines-soak-"), System.out::print);
        try {
            soak.play(option(options, "--minutes", 30), option(options, "--seed", 1));
        } finally {
            soak.end();
        }
        exit(soak.problems);
    }

    private Process league(int number) throws IOException {
        return start("league " + number, "league", "run", "many", "--games", "1000000", "--pause-after", "0", "--serve",
            "127.0.0.1:" + port);
    }

    private void prepare() throws IOException {
        make("many");
        Path clock = folder.resolve("clock.sh");
        Files.writeString(clock, "#!/bin/sh\nwhile read -r x y nextX nextY rest && read -r other; do\n"
            + "echo \"$nextX $nextY $(($(date +%s%N) / 1000 % 100))\"\ndone\n");
        run("league", "add", folder.resolve("many").toString(), "clock=codingame:sh '" + clock + "'");
        port = FreePort.next();
        for (String name : HONEST) {
            add(name);
        }
        HOSTILE.keySet().forEach(this::add);
    }

    private void play(int minutes, int seed) throws Exception {
        prepare();
        SplittableRandom random = new SplittableRandom(seed);
        Map<String, Integer> faults = new TreeMap<>();
        int leagues = 1;
        try (CutProxy proxy = new CutProxy(port)) {
            Process league = league(leagues);
            for (String name : HONEST) {
                workers.put(name, worker(name, proxy.port()));
            }
            List<Thread> hostile = HOSTILE.keySet().stream().map(name -> hostile(name, HOSTILE.get(name))).toList();
            long end = System.nanoTime() + TimeUnit.MINUTES.toNanos(minutes);
            int still = 0;
            for (int before = 0; System.nanoTime() < end;) {
                TimeUnit.SECONDS.sleep(PERIOD_S);
                int stored = rows("many").size();
                still = stored == before ? still + 1 : 0;
                stalled = Math.max(stalled, still);
                before = stored;
                check(league.isAlive(), "the league has ended by itself");
                String name = HONEST.get(random.nextInt(HONEST.size()));
                String fault = List.of("worker killed", "worker stopped for 3 s", "connections cut", "league killed")
                    .get(Math.min(3, random.nextInt(7) / 2));
                faults.merge(fault, 1, Integer::sum);
                if (fault.startsWith("league")) {
                    league.destroyForcibly().waitFor();
                    league = league(++leagues);
                } else if (fault.startsWith("connections")) {
                    proxy.cut(CLOSED_MS);
                } else if (fault.startsWith("worker killed")) {
                    workers.get(name).destroyForcibly().waitFor();
                    workers.put(name, worker(name, proxy.port()));
                } else {
                    signal("STOP", workers.get(name));
                    TimeUnit.SECONDS.sleep(3);
                    signal("CONT", workers.get(name));
                }
            }
            over = true;
            league.destroyForcibly().waitFor();
            for (Thread thread : hostile) {
                thread.join();
            }
        }
        compare(faults);
    }

    /** Fills up what was under way, without workers; then each decision has to have its two games once. */
    private void compare(Map<String, Integer> faults) throws IOException, InterruptedException {
        long played = rows("many").stream().filter(Row::counts).count();
        int games = (int) (played + 128) / 2 * 2;
        int status = start("league at the end", "league", "run", "many", "--games", Integer.toString(games),
            "--pause-after", "0", "--quiet", "--threads", "2").waitFor();
        check(status == 0, "the last run ends with status " + status);
        faults.forEach((fault, count) -> tell(fault, count));
        List<Row> rows = rows("many").stream().filter(Row::counts).toList();
        Map<String, Integer> decisions = new TreeMap<>();
        Set<String> places = new HashSet<>();
        int doubled = 0;
        for (Row row : rows) {
            decisions.merge(row.place().replaceAll(" .*", ""), 1, Integer::sum);
            doubled += places.add(row.place()) ? 0 : 1;
        }
        int last = decisions.keySet().stream().mapToInt(Integer::parseInt).max().orElse(-1);
        int lost = 2 * (last + 1) - places.size();
        tell("games", rows.size());
        tell("lost", lost);
        tell("doubled", doubled);
        Map<String, Integer> players = tellPlayers(rows);
        WorkerList list = WorkerList.read(new LeagueFolder(folder.resolve("many")));
        List<String> convicted = list.workers().stream().filter(worker -> worker.revoked() != null)
            .map(WorkerList.Worker::name).toList();
        tell("convicted", convicted);
        tell("most periods of " + PERIOD_S + " s in a row without a game", stalled);
        check(lost == 0 && doubled == 0 && rows.size() == games, "games are lost or doubled");
        check(convicted.equals(List.of("states")), "convicted: " + convicted + ", expected the forger of states");
        check(players.keySet().containsAll(List.of("worker one", "worker two", "worker three")),
            "an honest worker has played no game");
        check(!players.containsKey("worker late") && !players.containsKey("worker states"), "a forged game counts");
        check(stalled < 3, "nothing was stored for " + stalled * PERIOD_S + " s");
    }
}
