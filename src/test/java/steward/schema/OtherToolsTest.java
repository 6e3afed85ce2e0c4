package steward.schema;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static steward.schema.PageShell.assertContains;

import java.io.BufferedReader;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * Recipes of {@code docs/compatibility.md}, run as they stand there by the tools that they are for, with a bot of
 * {@code steward new cpp}. The tools are in the folder {@code -Psteward.tools}; without one, its test is skipped. Only
 * the numbers of games are smaller than shown.
 */
@Tag("process")
@Tag("slow")
@Timeout(300)
class OtherToolsTest {

    private static final String PAGE = "docs/compatibility.md";
    private static final String BRUTALTESTER = "cg-brutaltester.jar";

    private final Path tools = Path.of(System.getProperty("steward.tools", "../shared/tools")).toAbsolutePath();

    @TempDir
    private Path folder;
    private PageShell shell;

    /** Puts the program and a compiled bot into the folder. */
    @BeforeEach
    void prepare() throws IOException, InterruptedException {
        assumeTrue(Files.isDirectory(tools), "skipped: no folder of other tools, -Psteward.tools=FOLDER");
        assumeTrue(Stream.of(System.getenv("PATH").split(":")).anyMatch(at -> Files.exists(Path.of(at, "g++"))),
            "skipped: there is no g++");
        shell = new PageShell(folder, "", tools.resolve("bin"));
        shell.runLine(0, "steward new cpp bot && g++ -O2 -o mine bot/bot.cpp && cp mine other");
    }

    private Path tool(String name) {
        Path tool = tools.resolve(name);
        assumeTrue(Files.exists(tool), () -> "skipped: there is no " + tool);
        return tool;
    }

    /** The line with another number of games. */
    private static String shortened(String line) {
        assertTrue(line.contains("-n 100"), line);
        return line.replace("-n 100", "-n 2");
    }

    @Test
    void brutaltesterPlaysEachOfItsLinesWithoutAComplaint() throws IOException, InterruptedException {
        Files.copy(tool(BRUTALTESTER), folder.resolve(BRUTALTESTER));
        Files.copy(Path.of("src/test/resources/codingame/pilot.py"), folder.resolve("other.py"));
        Files.createDirectory(folder.resolve("logs"));
        List<String> lines = PageShell.lines(PAGE, "java -jar " + BRUTALTESTER);
        assertEquals(3, lines.size());
        for (String line : lines) {
            String said = shell.runLine(0, shortened(line));
            assertContains("End of games", said);
            assertContains("End of game 2", said);
            assertTrue(!said.contains("ERROR"), () -> line + "\n" + said);
        }
        assertTrue(Files.size(folder.resolve("logs/game2.json")) > 10_000);
    }

    @Test
    void brutaltesterTellsWhyABotHasFailed() throws IOException, InterruptedException {
        Files.copy(tool(BRUTALTESTER), folder.resolve(BRUTALTESTER));
        String line = shortened(PageShell.lines(PAGE, "java -jar " + BRUTALTESTER).get(1));
        Files.writeString(folder.resolve("other.cpp"), "volatile int x; int main() { for (;;) x++; }");
        shell.runLine(0, "g++ -o other other.cpp");
        String late = shell.runLine(0, line);
        assertContains("no answer within 1000 ms of CPU time", late);
        Files.delete(folder.resolve("other"));
        String missing = shell.runLine(0, line);
        assertContains("there is no file './other'", missing);
        for (String said : List.of(late, missing)) {
            assertTrue(Pattern.compile("Player 1 \\|\\s+\\| 100[.,]00%").matcher(said).find(), said);
        }
    }

    @Test
    void psyleaguePlaysWithBothOfItsLines() throws IOException, InterruptedException {
        tool("bin/psyleague");
        List<String> games = PageShell.lines(PAGE, "cmd_play_game = ");
        assertEquals(2, games.size());
        shell.runLine(0, "psyleague config && mkdir bots && cp bot/bot.cpp a.cpp && cp bot/bot.cpp b.cpp");
        configure("psyleague.cfg", games.get(0));
        assertPsyleaguePlays("a", "b");

        configure("psyleague.cfg", games.get(1));
        configure("psyleague.cfg", PageShell.line(PAGE, "cmd_bot_setup = "));
        shell.runLine(0, "rm psyleague.db psyleague.games && echo ./mine > c.bot && echo builtin:racer > d.bot");
        assertPsyleaguePlays("c", "d");
    }

    private void assertPsyleaguePlays(String one, String other) throws IOException, InterruptedException {
        shell.runLine(0, "psyleague bot add " + one + " && psyleague bot add " + other);
        shell.runLine(0, "psyleague run --games 2 --silent");
        List<String> played = Files.readAllLines(folder.resolve("psyleague.games"));
        assertEquals(2, played.size());
        played.forEach(game -> assertContains("\"errors\": [0, 0]", game));
    }

    /** Puts a line into a file of settings, in place of the one of the same name. */
    private void configure(String file, String line) throws IOException {
        Path settings = folder.resolve(file);
        Pattern old = Pattern.compile("(?m)^" + line.replaceAll(" = .*", "") + " = .*$");
        Matcher found = old.matcher(Files.readString(settings));
        assertTrue(found.find(), file + ": " + line);
        Files.writeString(settings, found.replaceFirst(Matcher.quoteReplacement(line)));
    }

    @Test
    void theArenaPlaysAndShowsAMatch() throws IOException, InterruptedException {
        tool("bin/cgarena");
        String version = shell.runLine(0, "cgarena --version");
        assumeTrue(!version.matches("cgarena 1\\.[0-3]\\..*\\R"), () -> "skipped: the page's lines are for 1.4, found "
            + version);
        shell.runLine(0, "cgarena init arena && sed -i 's/^port = .*/port = 0/' arena/cgarena_config.toml");
        Process server = shell.start("exec cgarena run arena");
        try (BufferedReader out = server.inputReader(StandardCharsets.UTF_8)) {
            String line = out.readLine();
            while (line != null && !line.startsWith("Local:")) {
                line = out.readLine();
            }
            assertTrue(line != null, "expected an arena that says where it is");
            URI api = URI.create(line.replaceFirst("Local: *", "")).resolve("/api/");
            ask(api, "configuration", "PUT", Map.of(
                "game", Map.of("min_players", 2, "max_players", 2, "symmetric", true),
                "ranking", Map.of("algorithm", "BradleyTerry"),
                "workers", List.of(Map.of("type", "embedded", "threads", 1,
                    "referee", Map.of("type", "command", "play_match", value("play_match = "),
                        "watch_replay", value("watch_replay = ")),
                    "cmd_build", "g++ -x c++ {DIR}/source.txt -o {DIR}/a", "cmd_run", "./{DIR}/a"))));
            String source = Files.readString(folder.resolve("bot/bot.cpp"));
            for (String role : List.of("benchmark", "candidate")) {
                ask(api, "bots", "POST", Map.of("name", role, "source_code", source, "language", "cpp", "role", role));
            }
            JsonNode replay = null;
            for (int asked = 0; asked < 600 && replay == null; asked++) {
                Thread.sleep(100);
                replay = ask(api, "status", "GET", null).path("leaderboards").path(0).path("total_matches").asInt() == 0
                    ? null : ask(api, "matches/1/replay", "GET", null);
            }
            String log = Files.readString(folder.resolve("arena/cgarena.log"));
            assertTrue(replay != null && !log.contains("ERROR"), log);
            HttpResponse<String> page = send(HttpRequest.newBuilder(api.resolve(replay.get("viewer_url").asString())));
            assertContains("<title>", page.body());
        } finally {
            server.destroy();
            server.waitFor();
        }
    }

    /** A value as the page has it in TOML, in quotes. */
    private static String value(String begin) throws IOException {
        String quoted = PageShell.line(PAGE, begin).substring(begin.length());
        return quoted.substring(1, quoted.length() - 1);
    }

    private static JsonNode ask(URI api, String path, String method, Object body)
            throws IOException, InterruptedException {
        HttpRequest.BodyPublisher publisher = body == null ? HttpRequest.BodyPublishers.noBody()
            : HttpRequest.BodyPublishers.ofString(JsonMapper.shared().writeValueAsString(body));
        HttpResponse<String> answer = send(HttpRequest.newBuilder(api.resolve(path))
            .header("Content-Type", "application/json").method(method, publisher));
        assertEquals(200, answer.statusCode(), () -> path + ": " + answer.body());
        return JsonMapper.shared().readTree(answer.body());
    }

    private static HttpResponse<String> send(HttpRequest.Builder request) throws IOException, InterruptedException {
        return HttpClient.newHttpClient().send(request.build(), HttpResponse.BodyHandlers.ofString());
    }
}
