package steward.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.bot.command.CommandLine;
import steward.bot.command.ProgramFinder;
import steward.cli.shared.ExitStatus;
import steward.game.GameTypes;
import steward.league.LeagueFolder;
import steward.machines.token.SharedBrokerKey;
import tools.jackson.core.JsonGenerator;

/** A game that is no part of the program: four files, compiled against the engine's jar alone, in a folder of jars. */
@Tag("process")
class OutsideGameTest {

    private static final Path SOURCES = Path.of("src/examples/games/sumo");

    @TempDir
    static Path folder;

    private static Path games;
    private static Path scene;

    @BeforeAll
    static void buildJar() throws IOException, URISyntaxException {
        Path classes = compile("classes", sources(".java"));
        games = Files.createDirectories(folder.resolve("games"));
        pack(games.resolve("sumo.jar"), classes, "");
        scene = Files.copy(SOURCES.resolve("sumo.json"), folder.resolve("sumo.json"));
    }

    private static Path compile(String to, Stream<Path> sources) throws IOException, URISyntaxException {
        Path classes = Files.createDirectories(folder.resolve(to));
        List<String> call = Stream.concat(
            Stream.of("-d", classes.toString(), "-proc:none", "-cp",
                source(GameTypes.class) + ":" + source(JsonGenerator.class)),
            sources.map(Path::toString)).toList();
        assertEquals(0, ToolProvider.getSystemJavaCompiler().run(null, null, null, call.toArray(new String[0])));
        return classes;
    }

    /** The folder or jar of a class; its URL has spaces and accents encoded. */
    private static Path source(Class<?> type) throws URISyntaxException {
        return Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI());
    }

    private static Stream<Path> sources(String suffix) throws IOException {
        return Files.walk(SOURCES).filter(file -> file.toString().endsWith(suffix)).sorted();
    }

    /** @param comment makes another jar of the same classes */
    private static void pack(Path jar, Path classes, String comment) throws IOException {
        try (OutputStream file = Files.newOutputStream(jar); JarOutputStream out = new JarOutputStream(file);
             Stream<Path> all = Files.walk(classes)) {
            out.setComment(comment);
            for (Path each : all.filter(Files::isRegularFile).sorted().toList()) {
                out.putNextEntry(new JarEntry(classes.relativize(each).toString()));
                Files.copy(each, out);
            }
            out.putNextEntry(new JarEntry("META-INF/services/steward.game.GameType"));
            Files.copy(SOURCES.resolve("META-INF/services/steward.game.GameType"), out);
        }
    }

    private static Cli call(Path gamesPath, String... words) {
        return Cli.run(List.of("--games-path", gamesPath.toString()), words);
    }

    private static Path play(String name) {
        Path replay = folder.resolve(name);
        call(games, "match", "--scene", scene.toString(), "--bot", bot(1), "--bot", bot(-3), "--seed", "4",
            "--out", replay.toString(), "--view", replay + ".html").done();
        return replay;
    }

    /** Pushes in one direction in every turn. */
    private static String bot(int x) {
        return "sh -c 'while read line; do echo \"{\\\"x\\\":" + x + ",\\\"y\\\":-2}\"; done'";
    }

    private static String league(String name) {
        String league = folder.resolve(name).toString();
        assertEquals("", call(games, "league", "init", league, "--scene", scene.toString()).err());
        call(games, "league", "add", league, "one=" + bot(1), "two=" + bot(2)).done();
        return league;
    }

    @Test
    void isPlayedDrawnAndVerified() throws IOException {
        Path replay = play("played.jsonl");
        String header = Files.readAllLines(replay).get(0);
        assertTrue(header.contains("\"game\":\"sumo\",\"jar\":\"sha256:"), header);
        assertTrue(header.contains("\"kind\":\"wrestler\""), header);
        assertTrue(Files.readString(Path.of(replay + ".html")).contains("<canvas"));
        Cli verified = call(games, "replay", replay.toString(), "--verify").done();
        assertTrue(verified.out().contains("verified"), verified.out());
    }

    @Test
    void anotherJarOrNoneIsRefusedByName() throws IOException {
        Path replay = play("refused.jsonl");
        Path others = Files.createDirectories(folder.resolve("others"));
        pack(others.resolve("sumo.jar"), folder.resolve("classes"), "another");
        Cli other = call(others, "replay", replay.toString(), "--verify");
        assertEquals(ExitStatus.UNUSABLE, other.status());
        assertTrue(other.err().matches("steward: .*refused.jsonl:1: jar: found sha256:\\w+.*, expected sha256:\\w+, "
            + "which is installed\n"), other.err());
        Cli.run("replay", replay.toString(), "--verify").assertRefused("put its jar into the folder of games");
        call(folder.resolve("nowhere"), "scene").assertRefused("--games-path: found no folder ");
    }

    @Test
    void aLeagueEndsItsSeasonWithTheJar() throws IOException {
        String league = league("league");
        call(games, "league", "run", league, "--games", "4").done();
        Path others = Files.createDirectories(folder.resolve("changed"));
        pack(others.resolve("sumo.jar"), folder.resolve("classes"), "changed");
        call(others, "league", "run", league, "--games", "8").assertRefused("the files of the game are others");
    }

    @Test
    @Tag("slow")
    void aWorkerPlaysOnlyWithTheJar() throws Exception {
        String league = league("served");
        String token = folder.resolve("far.token").toString();
        SharedBrokerKey.put(new LeagueFolder(Path.of(league)));
        call(games, "league", "worker", "add", league, "far", "--out", token);
        String address = "127.0.0.1:" + FreePort.next();
        CompletableFuture<Cli> run = CompletableFuture.supplyAsync(() -> call(games, "league", "run", league,
            "--games", "4", "--threads", "0", "--serve", address));
        Path others = Files.createDirectories(folder.resolve("far"));
        Cli none = worker(others, address, token);
        assertEquals(ExitStatus.REFUSED, none.status(), none.err());
        assertTrue(none.err().matches("(?s).*found no jar of the league's game, expected sha256:\\w{64} .*"),
            none.err());
        pack(others.resolve("sumo.jar"), folder.resolve("classes"), "far");
        Cli other = worker(others, address, token);
        assertEquals(ExitStatus.REFUSED, other.status(), other.err());
        assertTrue(other.err().contains("found the jar sha256:"), other.err());
        worker(games, address, token, "--games", "4").done();
        Cli served = run.get(300, TimeUnit.SECONDS).done();
        String told = served.out() + served.err();
        assertTrue(told.contains("worker far: found no jar of the league's game, expected sha256:"), told);
        assertTrue(told.contains("worker far: found the jar sha256:"), told);
    }

    private static Cli worker(Path gamesPath, String address, String token, String... more) {
        return call(gamesPath, Stream.concat(Stream.of("worker", "--join", address, "--token-file", token, "--bundles",
            folder.resolve("bundles").toString(), "--sandbox", "off"), Stream.of(more)).toArray(String[]::new));
    }

    /** The starter ends inside the ring, which who always pushes on does not. */
    @ParameterizedTest
    @ValueSource(strings = {"python", "java", "cpp", "js"})
    void aStarterPlaysIt(String language) throws IOException, InterruptedException {
        Path place = folder.resolve("starter-" + language);
        Cli made = call(games, "new", language, place.toString(), "--game", "sumo");
        assertEquals(new Cli(ExitStatus.DONE, made.out(), ""), made);
        List<String> lines = made.out().lines().map(String::strip).toList();
        List<String> words = CommandLine.split(lines.get(lines.size() - 1));
        for (String compile : lines.subList(2, lines.size() - 1)) {
            List<String> compiler = CommandLine.split(compile);
            assumeTrue(ProgramFinder.find(compiler.get(0)) != null, "there is no " + compiler.get(0));
            assertEquals(0, new ProcessBuilder(compiler).directory(place.toFile()).inheritIO().start().waitFor());
        }
        String bot = words.get(words.indexOf("--bot") + 1);
        String program = bot.replaceAll("me=| .*", "");
        assumeTrue(program.startsWith("./") || ProgramFinder.find(program) != null, "there is no " + program);
        Cli match = call(games, "match", "--scene", scene.toString(), "--bot", bot, "--in", place.toString(), "--bot",
            "on=" + bot(1), "--seed", "4", "--json", "--time-factor", "30").done();
        assertTrue(match.json().get("players").get(0).get("fault").isNull(), match.out());
        assertTrue(match.json().get("players").get(0).get("score").doubleValue() > 0, match.out());
    }

    @Test
    void aStarterInLinesThatItDoesNotDeclareSaysSo() throws IOException {
        Path place = folder.resolve("lines");
        Cli made = call(games, "new", "python", place.toString(), "--game", "sumo", "--protocol", "codingame").done();
        assertEquals("steward: warning: sumo does not declare its lines: the bot says where to read and answer them\n",
            made.err());
        String bot = Files.readString(place.resolve("bot.py"));
        assertTrue(bot.contains("# The game sumo does not declare its lines: read all of them,"), bot);
    }

    @Test
    void aDeclarationThatNoStarterCanHaveIsRefused() throws IOException, URISyntaxException {
        Path changed = Files.createDirectories(folder.resolve("changed-sources"));
        for (Path source : sources(".java").toList()) {
            Files.writeString(changed.resolve(source.getFileName()), Files.readString(source)
                .replace("let(\"rival\"", "let(\"class\""));
        }
        Path others = Files.createDirectories(folder.resolve("odd"));
        try (Stream<Path> all = Files.list(changed)) {
            pack(others.resolve("sumo.jar"), compile("odd-classes", all), "");
        }
        Cli refused = call(others, "new", "java", folder.resolve("odd-bot").toString(), "--game", "sumo");
        assertEquals(new Cli(ExitStatus.UNUSABLE, "", "steward: --game sumo: its type declares input or answer that no "
            + "starter can have: found the name \"class\", expected letters and digits that are no word of Python, "
            + "Java, C++ or JavaScript\n"), refused);
        assertTrue(Files.notExists(folder.resolve("odd-bot")));
    }

    @Test
    void aJarThatIsNoGameIsRefused() throws IOException {
        Path broken = Files.createDirectories(folder.resolve("broken"));
        try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(broken.resolve("x.jar")))) {
            out.putNextEntry(new JarEntry("META-INF/services/steward.game.GameType"));
            out.write("no.such.Type\n".getBytes());
        }
        call(broken, "scene").assertRefused("whose game cannot be loaded");
    }
}
