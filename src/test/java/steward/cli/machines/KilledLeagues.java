package steward.cli.machines;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import steward.cli.FreePort;
import steward.cli.ShellBots;
import steward.league.LeagueFolder;
import steward.machines.token.SharedBrokerKey;

/**
 * Kills leagues with SIGKILL at random points, and compares their games with those of leagues that nobody disturbs: of
 * 2, 3 and 12 bots, round robin and adaptive, on one thread and two, with a worker that comes and is killed as well.
 * The bots are deterministic and fail in bursts, so that some are paused; after a third of the games the program of one
 * changes, after another third there is one more. Prints the seed and what came of it; exit status 1 if games differ.
 *
 * <p>{@code --kills N} (100), {@code --games N} of a league (120), {@code --seed N} (another each time).
 */
public final class KilledLeagues extends MachinesProof {

    private static final int PHASES = 3;
    private static final int LAG = 8;
    private static final int MOST_LATER = 8;
    private static final int START_MS = 1500;
    private static final String SCRIPT = """
        #!/bin/sh
        # arguments: drive or stay, on how many of ten maps it fails, which these are
        turn=0
        while read -r x y nextX nextY distance angle && read -r otherX otherY; do
          turn=$((turn + 1))
          [ $turn = 1 ] && place=$(((nextX + nextY + $3) % 10))
          if [ $turn = 3 ] && [ $place -lt $2 ]; then echo nonsense; continue; fi
          if [ "$1" = drive ]; then echo "$nextX $nextY 100"; else echo "$x $y 0"; fi
        done
        """;
    /** On how many of ten maps a bot fails, by turns. */
    private static final int[] FAILURES = {0, 6, 2, 8};

    private final int kills;
    private final int games;
    private final SplittableRandom random;
    private int killed;
    private int served;
    private int compared;

    private KilledLeagues(Path folder, int kills, int games, long seed, Consumer<String> teller) throws IOException {
        super(folder, games, 0, 0, teller);
        this.kills = kills;
        this.games = games;
        random = new SplittableRandom(seed);
        ShellBots.drawn(folder.resolve("short.json"));
    }

    /** Reads the options, plays, prints. */
    public static void main(String[] arguments) throws Exception {
        List<String> options = List.of(arguments);
        exit(kill(Files.createTempDirectory("killed-"), option(options, "--kills", 100),
            option(options, "--games", 120), option(options, "--seed", (int) System.nanoTime() >>> 1),
            System.out::print));
    }

    /** Plays and kills. @return what is not as it should be */
    static List<String> kill(Path folder, int kills, int games, long seed, Consumer<String> teller) throws Exception {
        teller.accept("seed " + seed + "\n");
        KilledLeagues leagues = new KilledLeagues(folder, kills, games, seed, teller);
        try {
            for (int bots : new int[] {2, 3, 12}) {
                for (String pairing : new String[] {"round-robin", "adaptive"}) {
                    leagues.play(bots, pairing);
                }
            }
        } finally {
            leagues.end();
        }
        leagues.tell("killed (SIGKILL)", leagues.killed);
        leagues.tell("  with a worker, which was killed too", leagues.served);
        leagues.tell("games compared", leagues.compared);
        leagues.tell("problems", leagues.problems.size());
        if (leagues.killed < kills) {
            leagues.problems.add(leagues.killed + " were killed, expected " + kills);
        }
        return leagues.problems;
    }

    private void bot(String name, String bot, int number) throws IOException {
        Path script = folder.resolve(name + "-" + bot + ".sh");
        Files.writeString(script, SCRIPT + "# " + bot + "\n");
        for (String league : List.of(name, name + "-whole")) {
            run("league", "add", folder.resolve(league).toString(), bot + "=codingame:sh '" + script + "' "
                + (number % 2 == 0 ? "drive " : "stay ") + FAILURES[number % FAILURES.length] + " " + 3 * number);
        }
    }

    private void play(int bots, String pairing) throws Exception {
        String name = pairing + bots;
        for (String league : List.of(name, name + "-whole")) {
            Path path = folder.resolve(league);
            run("league", "init", path.toString(), "--scene", folder.resolve("short.json").toString(), "--seed", "5");
            Path settings = path.resolve("league.json");
            Files.writeString(settings, Files.readString(settings).replaceFirst("\"lag\": \\d+", "\"lag\": " + LAG)
                .replaceFirst("\"pairing\": \"[a-z-]+\"", "\"pairing\": \"" + pairing + "\""));
            if (!Files.readString(settings).contains(pairing)) {
                throw new IllegalStateException(Files.readString(settings));
            }
        }
        for (int bot = 0; bot < bots; bot++) {
            bot(name, "bot" + bot, bot);
        }
        SharedBrokerKey.put(new LeagueFolder(folder.resolve(name)));
        run("league", "worker", "add", folder.resolve(name).toString(), name, "--out",
            folder.resolve(name + ".token").toString());
        int before = killed;
        for (int phase = 1; phase <= PHASES; phase++) {
            if (phase == 2) {
                Files.writeString(folder.resolve(name + "-bot1.sh"), SCRIPT + "# bot1, the second\n");
            } else if (phase == 3) {
                bot(name, "late", 4);
            }
            int end = games * phase / PHASES / 2 * 2;
            Process whole = league(name + "-whole", end, 1, false);
            whole.waitFor();
            int share = (kills + 6 * PHASES - 1) / (6 * PHASES);
            for (int tries = 0, found = 0; tries < 3 * share && found < share; tries++) {
                found += killed(name, end) ? 1 : 0;
            }
            Process last = league(name, end, 2, false);
            last.waitFor();
            compare(name, whole.exitValue(), last.exitValue());
        }
        tell(bots + " bots, " + pairing + ": kills, games", killed - before + ", " + rows(name).size());
    }

    private Process league(String name, int end, int threads, boolean isServed) throws IOException {
        List<String> words = new ArrayList<>(List.of("league", "run", name, "--games", Integer.toString(end),
            "--threads", Integer.toString(threads), "--pause-after", name.matches("\\D+2\\D*") ? "0" : "4", "--quiet"));
        if (isServed) {
            words.addAll(List.of("--serve", "127.0.0.1:" + port));
        }
        return start(name, words.toArray(String[]::new));
    }

    /** Kills a league after some more games, or while it starts. @return whether it had not ended before */
    private boolean killed(String name, int end) throws IOException, InterruptedException {
        boolean withWorker = random.nextInt(4) == 0;
        port = withWorker ? FreePort.next() : 0;
        Process league = league(name, end, 1 + random.nextInt(2), withWorker);
        Process worker = withWorker ? worker(name, port) : null;
        int more = random.nextInt(MOST_LATER);
        if (more == 0) {
            league.waitFor(random.nextInt(START_MS), TimeUnit.MILLISECONDS);
        }
        int until = rows(name).size() + more;
        while (league.isAlive() && rows(name).size() < until) {
            league.waitFor(10 + random.nextInt(30), TimeUnit.MILLISECONDS);
        }
        boolean found = league.isAlive();
        league.destroyForcibly().waitFor();
        if (worker != null) {
            worker.destroyForcibly().waitFor();
        }
        killed += found ? 1 : 0;
        served += found && withWorker ? 1 : 0;
        return found;
    }

    private void compare(String name, int expectedStatus, int status) throws IOException {
        List<String> expected = rows(name + "-whole").stream().map(Row::game).sorted().toList();
        List<String> found = rows(name).stream().map(Row::game).sorted().toList();
        compared += expected.size();
        if (expected.equals(found) && expectedStatus == status) {
            return;
        }
        Set<String> lacks = new TreeSet<>(expected);
        found.forEach(lacks::remove);
        Set<String> has = new TreeSet<>(found);
        expected.forEach(has::remove);
        problems.add(name + ": status " + status + ", expected " + expectedStatus + "; " + found.size()
            + " games, expected " + expected.size() + "; it lacks " + lacks + ", and has " + has + "; "
            + Files.readString(folder.resolve(name + ".err")));
    }
}
