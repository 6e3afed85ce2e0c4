package steward.cli.league.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.Cli;
import steward.cli.FreePort;
import steward.cli.ShellBots;
import steward.cli.TextShellBots;
import steward.league.page.WorkerRow;

@Tag("process")
@Timeout(120)
class LeagueMetricsTest {

    @TempDir
    private Path folder;

    @Test
    void figuresOfWorkersAreInTheTextFormatOfPrometheus() {
        StringBuilder built = new StringBuilder();
        LeagueMetrics.workers(built, List.of(
            new WorkerRow("attic", "2 at a time", 30, 0, 0.5, 3, 1, "1", 1500, List.of("a doubt")),
            new WorkerRow("cellar", "caught", 0, 12, 0, 0, 0, "1", 0, List.of())));
        String text = built.toString();
        assertForm(text);
        assertEquals(List.of("steward_workers 1", "steward_worker_games{worker=\"attic\"} 30",
            "steward_worker_games{worker=\"cellar\"} 0", "steward_worker_set_aside{worker=\"attic\"} 0",
            "steward_worker_set_aside{worker=\"cellar\"} 12", "steward_worker_faults{worker=\"attic\"} 3",
            "steward_worker_faults{worker=\"cellar\"} 0", "steward_worker_hiccups{worker=\"attic\"} 1",
            "steward_worker_hiccups{worker=\"cellar\"} 0", "steward_worker_suspicions{worker=\"attic\"} 1",
            "steward_worker_suspicions{worker=\"cellar\"} 0", "steward_worker_silent_seconds{worker=\"attic\"} 1.500",
            "steward_worker_silent_seconds{worker=\"cellar\"} 0"),
            text.lines().filter(line -> !line.startsWith("#")).toList());
    }

    private static void assertForm(String text) {
        assertTrue(text.lines().allMatch(line -> line.matches("# (HELP|TYPE) steward_[a-z_]+ .+"
            + "|steward_[a-z_]+(\\{worker=\"[A-Za-z0-9_-]+\"\\})? [0-9]+(\\.[0-9]+)?")), text);
    }

    private static double figure(String text, String name) {
        return text.lines().filter(line -> line.startsWith("steward_" + name + " "))
            .mapToDouble(line -> Double.parseDouble(line.replaceAll(".* ", ""))).findFirst().orElseThrow();
    }

    /**
     * The league is served and has no worker, so it plays all by itself and nothing waits in the queue. Its third game
     * waits until the figures have been read.
     */
    @Test
    void aServedLeagueTellsItsFiguresOverHttp() throws Exception {
        ShellBots.shortDuel(folder);
        TextShellBots bots = new TextShellBots(folder);
        Path script = Files.writeString(folder.resolve("gate.sh"), "cd '" + folder + "'; echo >>starts\n"
            + "[ $(wc -l <starts) -le 4 ] || until [ -e go ]; do sleep 0.02; done\nexec \"$@\"\n");
        String gate = "sh '" + script + "' ";
        Cli.league(folder, "init", "TMP/night", "--scene", "TMP/short.json").done();
        Cli.league(folder, "add", "TMP/night", "a=codingame:" + gate + bots.driver()).done();
        Cli.league(folder, "add", "TMP/night", "b=codingame:" + gate + bots.idler(0)).done();
        int page = FreePort.next();
        CompletableFuture<Cli> run = CompletableFuture.supplyAsync(() -> {
            try {
                return Cli.league(folder, "run", "TMP/night", "--games", "4", "--threads", "1", "--json", "--watch",
                    "--port", Integer.toString(page), "--serve", "127.0.0.1:" + FreePort.next()).done();
            } catch (IOException problem) {
                throw new IllegalStateException(problem);
            }
        });
        String text = null;
        while (!run.isDone() && (text == null || figure(text, "games_total") < 1)) {
            try {
                HttpResponse<String> answer = HttpClient.newHttpClient().send(HttpRequest.newBuilder(URI.create(
                    "http://127.0.0.1:" + page + "/metrics")).build(), HttpResponse.BodyHandlers.ofString());
                assertEquals(200, answer.statusCode());
                text = answer.body();
            } catch (IOException notYet) {
                TimeUnit.MILLISECONDS.sleep(50);
            }
        }
        Files.createFile(folder.resolve("go"));
        assertForm(text);
        assertTrue(figure(text, "games_under_way") <= 1, text);
        assertEquals(0, figure(text, "workers"));
        assertEquals(0, figure(text, "queue_games"));
        assertEquals(64, figure(text, "lag_limit_decisions"));
        assertTrue(figure(text, "lag_decisions") >= 0 && figure(text, "lag_decisions") <= 64, text);
        Cli cli = run.get(100, TimeUnit.SECONDS);
        assertTrue(cli.err().lines().allMatch(line -> line.matches(
            "\\{\"time\":\"\\d{4}-[-0-9T:.]+Z\",\"event\":\"[^\"]+\"\\}")), cli.err());
        assertTrue(cli.err().contains("\"event\":\"Watch the league at http://127.0.0.1:" + page), cli.err());
    }
}
