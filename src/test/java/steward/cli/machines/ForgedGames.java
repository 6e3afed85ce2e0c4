package steward.cli.machines;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import steward.cli.FreePort;
import steward.league.LeagueFolder;
import steward.machines.serve.HostileWorker.Way;
import steward.machines.token.WorkerList;

/**
 * A league with two honest workers, each in a process of its own, and one with a valid token that forges games. It is
 * compared with the same league played on a single machine: no forged game may count.
 */
public final class ForgedGames extends MachinesProof {

    private static final int GAMES = 120;
    private static final int PAUSE_MS = 100;
    private static final long PATIENCE_S = 200;

    private ForgedGames(Path folder) throws IOException {
        super(folder, GAMES, 0, PAUSE_MS, line -> { });
    }

    /**
     * Plays.
     *
     * @param folder for all files, empty
     * @return what counts that should not, or was not found; empty if there is nothing
     */
    public static List<String> problems(Path folder, Way way) throws IOException, InterruptedException {
        ForgedGames forged = new ForgedGames(folder);
        try {
            forged.play(way);
        } finally {
            forged.end();
        }
        return forged.problems;
    }

    private void play(Way way) throws IOException, InterruptedException {
        make("alone");
        run("league", "run", folder.resolve("alone").toString(), "--games", "" + GAMES, "--pause-after", "0",
            "--threads", "4");
        make("many");
        port = FreePort.next();
        List.of("one", "two", "bad").forEach(this::add);
        worker("one", port);
        worker("two", port);
        hostile("bad", way);
        String said = served(1);
        if (way == Way.ANSWERS) {                      // who is right is for the operator to judge
            check(said.contains("worker bad is doubtful"), "the forger is not named: " + said);
            run("league", "worker", "revoke", folder.resolve("many").toString(), "bad", "--set-aside");
            served(2);
        } else {
            check(said.contains("worker bad is caught and revoked"), "the forger is not caught: " + said);
        }
        List<Row> counting = rows("many").stream().filter(Row::counts).toList();
        List<String> games = counting.stream().map(ForgedGames::game).sorted().toList();
        List<String> alone = rows("alone").stream().map(ForgedGames::game).sorted().toList();
        check(games.equals(alone), "games are others than on one machine: " + without(games, alone) + " for "
            + without(alone, games));
        check(counting.stream().noneMatch(row -> row.machine().startsWith("worker bad")), "a forger's game counts");
        for (String honest : List.of("one", "two")) {
            check(counting.stream().anyMatch(row -> row.machine().startsWith("worker " + honest)),
                "worker " + honest + " has played no game");
        }
        check(WorkerList.read(new LeagueFolder(folder.resolve("many"))).workers().stream()
            .filter(worker -> worker.revoked() != null).map(WorkerList.Worker::name).toList().equals(List.of("bad")),
            "others than the forger are revoked");
    }

    /** The game without the number of its attempt: a forged one is played again as a further attempt. */
    private static String game(Row row) {
        return row.game().replaceFirst("^(\\S+ \\S+) \\S+", "$1");
    }

    private static List<String> without(List<String> games, List<String> others) {
        return games.stream().filter(game -> !others.contains(game)).toList();
    }

    /** Plays the league to its end. @return what it said */
    private String served(int number) throws IOException, InterruptedException {
        Process league = start("league " + number, "league", "run", "many", "--games", "" + GAMES, "--pause-after", "0",
            "--serve", "127.0.0.1:" + port);
        check(league.waitFor(PATIENCE_S, TimeUnit.SECONDS) && league.exitValue() == 0, "the league does not end");
        return Files.readString(folder.resolve("league " + number + ".err"));
    }
}
