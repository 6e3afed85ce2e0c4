package steward.machines.serve;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.cli.Cli;
import steward.machines.check.GzipText;
import steward.machines.token.WorkerToken;
import steward.machines.wire.WireMessage;
import steward.match.TestSize;

/** A scene that lists thousands of bodies in a CSV file: played, verified, and a league's game of it by a worker. */
@Tag("process")
@Tag("slow")
@Timeout(300)
@Execution(ExecutionMode.CONCURRENT)
class ListedBodiesTest extends ServedLeague {

    private static final int ROW = 400;
    /** Their list does not fit into the header of a message, and what is sent of it not into one piece. */
    private static final int FEW = 9_000;
    private static final int MANY = 100_000;
    private static final String SCENE = """
        { "name": "listed", "game": "bodies", "players": %d, %s
          "field": { "width": 8000, "height": 5000, "walls": "box" }, "bodies": { "csv": "listed.csv" },
          "play": { "maximumTurns": 2%s }, "accuracy": { "advance": "event", "arithmetic": "double" } }
        """;

    /** A bot that pushes its body to the right; the argument says how hard. */
    public static final class Pusher {

        private Pusher() { }

        public static void main(String[] thrust) throws IOException {
            BufferedReader in = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
            in.readLine();
            while (in.readLine() != null) {
                System.out.println("{\"thrusts\":[{\"x\":" + thrust[0] + ",\"y\":0}]}");
            }
        }
    }

    private void list(int count, boolean owned) throws IOException {
        StringBuilder rows = new StringBuilder(owned ? "x,y,vx,vy,radius,owner\n" : "x,y,vx,vy,radius\n");
        Random random = new Random(5);
        for (int k = 0; k < count; k++) {
            rows.append(10 + 20 * (k % ROW) + random.nextDouble()).append(',')
                .append(10 + 20 * (k / ROW) + random.nextDouble()).append(',')
                .append(random.nextDouble() - 0.5).append(',').append(random.nextDouble() - 0.5).append(',')
                .append(5 + random.nextDouble())
                .append(owned ? k < 2 ? "," + k : "," : "").append('\n');
        }
        Files.writeString(folder.resolve("listed.csv"), rows);
        assertTrue(GzipText.compressed(rows.toString().getBytes(StandardCharsets.UTF_8)).length > WireMessage.CHUNK,
            "more than a piece");
        Files.writeString(folder.resolve("listed.json"), SCENE.formatted(owned ? 2 : 0,
            owned ? "\"time\": { \"firstAnswerMs\": 60000, \"answerMs\": 60000 }," : "",
            owned ? ", \"maximumThrust\": 9" : ""));
    }

    @Test
    @Tag("sized")
    void itIsPlayedAndVerified() throws IOException {
        int count = TestSize.of(FEW, MANY);
        list(count, false);
        String replay = folder.resolve("listed.jsonl").toString();
        Cli run = Cli.run("run", folder.resolve("listed.json").toString(), "--out", replay).done();
        Cli verified = Cli.run("replay", replay, "--verify").done();
        assertEquals("verified: states of 1 of 2 turns, hashes of all and the result\n", verified.out());
    }

    @Test
    @Tag("campaign")
    void aWorkerPlaysGamesOfALeagueWithALongList() throws Exception {
        assertAWorkerPlaysAGameOfALeague(MANY, 2);
    }

    /** The scene has its CSV file in the league's folder, and goes to the worker in pieces. */
    private void assertAWorkerPlaysAGameOfALeague(int count, int played) throws Exception {
        list(count, true);
        done("init", "TMP/many", "--scene", "TMP/listed.json", "--seed", "5");
        Path classes = Path.of(Pusher.class.getProtectionDomain().getCodeSource().getLocation().toURI());
        for (int bot = 1; bot <= 2; bot++) {
            Path script = folder.resolve("bot" + bot + ".sh");
            Files.writeString(script, "exec '" + Path.of(System.getProperty("java.home"), "bin", "java")
                + "' -XX:TieredStopAtLevel=1 -XX:+UseSerialGC -XX:-UsePerfData -cp '" + classes + "' '"
                + Pusher.class.getName() + "' " + bot);
            done("add", "TMP/many", "bot" + bot + "=sh " + script);
        }
        WorkerToken token = token("many", "one");
        CompletableFuture<String> run = serve("many", played, "--threads", "0");
        play(worker(token, 1, Long.MAX_VALUE));
        String said = run.get();
        List<Row> games = games("many");
        assertEquals(played, games.size(), said);
        assertTrue(games.stream().allMatch(game -> game.counts() && game.machine().startsWith("worker one")),
            games + said);
    }
}
