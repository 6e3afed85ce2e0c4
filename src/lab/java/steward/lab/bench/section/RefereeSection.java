package steward.lab.bench.section;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import steward.contest.Contest;
import steward.contest.KeptReplays;
import steward.contest.Series;
import steward.contest.SeriesPlay;
import steward.files.Folders;
import steward.game.GameSetup;
import steward.guest.GuestType;
import steward.lab.bench.Comparison;
import steward.lab.bench.Contender;
import steward.lab.bench.Effort;
import steward.lab.bench.Row;
import steward.lab.bench.Section;
import steward.lab.timing.Stretch;
import steward.match.Protocol;
import tools.jackson.databind.json.JsonMapper;

/**
 * Bench section on referees made with CodinGame's SDK: games of a small one, in resident JVMs and in one JVM per game.
 */
public record RefereeSection(MatchFixture fixture, Path sdk) implements Section {

    private static final List<String> SOURCES = List.of("Player.java", "Referee.java");
    private static final String MAIN = "com.codingame.gameengine.core.RefereeMain";
    private static final String BOT = "sh -c 'while read -r line; do echo \"$line\"; done'";

    /** Ways to run a referee, and games of a round: about ten seconds of each. */
    private enum Way {
        COLD("a JVM a game", 12), FRESH("resident, fresh classes", 120), KEPT("resident, classes kept", 400);

        private final String words;
        private final int games;

        Way(String words, int games) {
            this.words = words;
            this.games = games;
        }
    }

    @Override
    public String name() {
        return "referees";
    }

    @Override
    public String about() {
        return "Games of 100 turns on CodinGame's SDK between two shells that answer at once, by the wall clock. The"
            + " SDK's own main class runs in a JVM for each game; resident referees keep a JVM from game to game,"
            + " after a round of warm-up. There are as many threads as processors. All referees are kept apart as"
            + " bots are.";
    }

    @Override
    public int steps(Effort effort) {
        return effort.few().steps(Way.values().length);
    }

    @Override
    public void run(Effort effort, Runnable step, Consumer<Row> rows) throws Exception {
        Path folder = Files.createTempDirectory("steward-bench");
        try {
            List<String> classPath = compile(folder);
            List<Contender> contenders = new ArrayList<>();
            for (Way way : Way.values()) {
                GameSetup setup = fixture.types().open(scene(way, classPath), "bench");
                contenders.add(new Contender(way.words, least -> play(setup, way.games)));
            }
            new Comparison(name(), "games", contenders).run(effort.few(), step, rows);
        } finally {
            GuestType.endIdle();
            Folders.delete(folder);
        }
    }

    /** Compiles the referee and returns its class path. */
    private List<String> compile(Path folder) throws IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        if (compiler == null) {
            throw new IOException("found a Java without a compiler, expected a JDK");
        }
        List<String> classPath = new ArrayList<>(List.of(folder.toString()));
        try (Stream<Path> files = Files.list(sdk)) {
            files.filter(file -> file.toString().endsWith(".jar")).sorted()
                .forEach(file -> classPath.add(file.toAbsolutePath().toString()));
        }
        List<String> words = new ArrayList<>(List.of("-proc:none", "-d", folder.toString(), "-cp",
            String.join(File.pathSeparator, classPath)));
        for (String source : SOURCES) {
            try (InputStream text = RefereeSection.class.getResourceAsStream("referee/" + source)) {
                Files.copy(text, folder.resolve(source));
            }
            words.add(folder.resolve(source).toString());
        }
        OutputStream nothing = OutputStream.nullOutputStream();   // of jars that are not the SDK's it says a page
        if (compiler.run(null, nothing, nothing, words.toArray(new String[0])) != 0) {
            throw new IOException(sdk + ": found no jars that the referee compiles with, expected those of the SDK");
        }
        return classPath;
    }

    private static String scene(Way way, List<String> classPath) {
        Map<String, Object> referee = way == Way.COLD
            ? Map.of("command", List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Dgame.mode=multi", "--add-opens", "java.base/java.lang=ALL-UNNAMED", "-cp",
                String.join(File.pathSeparator, classPath), MAIN))
            : Map.of("classPath", classPath, "reuse", way == Way.KEPT ? "classes" : "nothing");
        return JsonMapper.shared().writeValueAsString(
            Map.of("name", "bench", "game", "guest", "players", 2, "referee", referee));
    }

    private static Stretch play(GameSetup setup, int games) throws InterruptedException, IOException {
        Contest contest = Contest.of(setup, List.of("one=" + BOT, "other=" + BOT), Protocol.CODINGAME, 1);
        SeriesPlay play = new SeriesPlay(new Series(contest, 1, games, false, null, KeptReplays.NONE), false);
        int[] played = new int[1];
        String[] problem = new String[1];
        long began = System.nanoTime();
        play.play(Runtime.getRuntime().availableProcessors(), (Series.Played game) -> {
            played[0] += game.result() == null ? 0 : 1;
            problem[0] = game.failure() == null ? problem[0] : game.failure();
        });
        double nanos = System.nanoTime() - began;
        if (played[0] != games) {
            throw new IOException(played[0] + " games of " + games + " have a result: " + problem[0]);
        }
        return new Stretch(nanos / games, Double.NaN);
    }
}
