package steward.lab.cli.bench;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import steward.cli.shared.Games;
import steward.game.GameSetup;
import steward.lab.bench.Section;
import steward.lab.bench.section.CrowdSection;
import steward.lab.bench.section.HeapSection;
import steward.lab.bench.section.FixedAnswerBot;
import steward.lab.bench.section.MatchFixture;
import steward.lab.bench.section.MatchSection;
import steward.lab.bench.section.ProcessSection;
import steward.lab.bench.section.StartupSection;
import steward.lab.bench.section.ToolSection;
import steward.lab.bench.section.VerifySection;
import steward.scene.SceneFiles;
import steward.scene.SceneText;

/** List of the sections that {@code steward bench} measures. */
final class BenchSuite {

    /** Property in which the launcher passes its own path. */
    static final String LAUNCHER = "steward.launcher";

    /** The class that the launcher starts; it is in a package above this one, so it is named and not imported. */
    private static final String MAIN_CLASS = "steward.cli.Main";
    private static final String SCENE = "mad-pod-racing";
    /** A valid answer for two pods, which never reach a checkpoint. */
    private static final String ANSWER = "{\"pods\":[{\"x\":8000,\"y\":4500,\"thrust\":50},"
        + "{\"x\":8000,\"y\":4500,\"thrust\":50}]}";
    private static final String TURNS_LEFT = "\"turnsWithoutCheckpoint\": 100";
    private static final String MAXIMUM = "\"maximumTurns\": 500";
    /** Turns of a match long enough to warm up the JVM that plays it. */
    private static final String LONG = "5000";
    private static final List<String> QUICK_JVM = List.of("-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC",
        "-Xshare:auto", "-XX:-UsePerfData");

    /**
     * All sections, in the order of the table.
     *
     * @param bodies the numbers of bodies of the crowds
     * @param tools  a folder of tools of others
     */
    static List<Section> all(List<Integer> bodies, Path tools) {
        MatchFixture fixture = fixture();
        return List.of(new MatchSection(fixture), new VerifySection(fixture), new ProcessSection(fixture,
                scene(TURNS_LEFT, TURNS_LEFT.replace("100", LONG), MAXIMUM, MAXIMUM.replace("500", LONG)),
                Integer.parseInt(LONG), scene(MAXIMUM, MAXIMUM.replace("500", "1")),
                List.of("sh", "-c", "while read -r line; do echo '" + ANSWER + "'; done")),
            new StartupSection(fixture), new ToolSection(fixture, tools), new CrowdSection(bodies), new HeapSection());
    }

    static MatchFixture fixture() {
        List<String> java = List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        String classes = System.getProperty("java.class.path");
        List<String> responder = new ArrayList<>(java);
        responder.addAll(QUICK_JVM);
        responder.addAll(List.of("-cp", classes, FixedAnswerBot.class.getName(), ANSWER));
        List<String> plain = new ArrayList<>(java);
        plain.addAll(boot("picocli"));       // what the launcher puts on the boot class path is not on the class path
        plain.addAll(List.of("-cp", classes, MAIN_CLASS));
        String launcher = System.getProperty(LAUNCHER);
        return new MatchFixture(Games.types(), Games.open(SCENE), BenchDirectBot::new, BenchLineBot::new, responder,
            launcher == null ? null : List.of(launcher), plain);
    }

    private static List<String> boot(String part) {
        return java.lang.management.ManagementFactory.getRuntimeMXBean().getInputArguments().stream()
            .filter(word -> word.startsWith("-Xbootclasspath/a:") && word.contains(part)).toList();
    }

    /** The official scene with some texts replaced: pairs of old and new text. */
    private static GameSetup scene(String... changes) {
        SceneText text = SceneFiles.load(SCENE);
        String changed = text.text();
        for (int k = 0; k < changes.length; k += 2) {
            if (!changed.contains(changes[k])) {
                throw new IllegalStateException("the scene " + SCENE + " has no " + changes[k]);
            }
            changed = changed.replace(changes[k], changes[k + 1]);
        }
        return Games.types().open(changed, text.source());
    }
}
