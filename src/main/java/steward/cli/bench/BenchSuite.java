package steward.cli.bench;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import steward.bench.Section;
import steward.bench.section.FixedAnswerBot;
import steward.bench.section.MatchFixture;
import steward.bench.section.Sections;
import steward.cli.shared.Games;
import steward.game.GameSetup;
import steward.game.podrace.protocol.PodRaceType;
import steward.scene.SceneFiles;
import steward.scene.SceneText;

/** What {@code steward bench} measures. */
final class BenchSuite {

    /** The launcher tells where it stands. */
    static final String LAUNCHER = "steward.launcher";

    /** What the launcher starts; a class above this room, so it is named and not imported. */
    private static final String MAIN_CLASS = "steward.cli.Main";
    private static final String SCENE = "mad-pod-racing";
    /** A good answer for two pods, which never arrive. */
    private static final String ANSWER = "{\"pods\":[{\"x\":8000,\"y\":4500,\"thrust\":50},"
        + "{\"x\":8000,\"y\":4500,\"thrust\":50}]}";
    private static final String TURNS_LEFT = "\"turnsWithoutCheckpoint\": 100";
    private static final String MAXIMUM = "\"maximumTurns\": 500";
    /** Turns of a match in which a JVM that plays it gets warm. */
    private static final String LONG = "5000";
    private static final String PLAYERS = "\"players\": 2";
    private static final List<String> QUICK_JVM = List.of("-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC",
        "-Xshare:auto", "-XX:-UsePerfData");

    private BenchSuite() {
    }

    /** All parts, in the order of the table. */
    static List<Section> all(int threads, int games, List<Integer> bodies) {
        MatchFixture kit = kit();
        List<Section> sections = new ArrayList<>();
        sections.add(new PodTurnSection((PodRaceType.PodRaceSetup) kit.setup(), threads));
        sections.add(Sections.matches(kit, threads, games));
        sections.add(Sections.growth(kit, growth()));
        sections.add(Sections.frames(kit, new BenchRaceStates(kit.setup()), ANSWER));
        sections.add(Sections.verify(kit));
        sections.add(Sections.processes(kit,
            scene(TURNS_LEFT, TURNS_LEFT.replace("100", LONG), MAXIMUM, MAXIMUM.replace("500", LONG)),
            Integer.parseInt(LONG), scene(MAXIMUM, MAXIMUM.replace("500", "1")),
            List.of("sh", "-c", "while read -r line; do echo '" + ANSWER + "'; done")));
        sections.add(Sections.start(kit));
        sections.add(Sections.crowds(bodies));
        return sections;
    }

    static MatchFixture kit() {
        List<String> java = List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        String classes = System.getProperty("java.class.path");
        List<String> responder = new ArrayList<>(java);
        responder.addAll(QUICK_JVM);
        responder.addAll(List.of("-cp", classes, FixedAnswerBot.class.getName(), ANSWER));
        List<String> plain = new ArrayList<>(java);
        // What the launcher puts on the boot class path is missing from the class path.
        for (String option : List.of("picocli")) {
            plain.addAll(boot(option));
        }
        plain.addAll(List.of("-cp", classes, MAIN_CLASS));
        String launcher = System.getProperty(LAUNCHER);
        return new MatchFixture(Games.types(), Games.open(SCENE), BenchDirectBot::new, BenchLineBot::new, responder,
            launcher == null ? null : List.of(launcher), plain);
    }

    private static List<String> boot(String part) {
        return java.lang.management.ManagementFactory.getRuntimeMXBean().getInputArguments().stream()
            .filter(word -> word.startsWith("-Xbootclasspath/a:") && word.contains(part)).toList();
    }

    private static Map<String, GameSetup> growth() {
        Map<String, GameSetup> scenes = new LinkedHashMap<>();
        scenes.put("2 players", Games.open(SCENE));
        for (int players : new int[] {1, 4, 8}) {
            scenes.put(players + (players == 1 ? " player" : " players"),
                scene(PLAYERS, PLAYERS.replace("2", Integer.toString(players))));
        }
        for (int turns : new int[] {50, 100, 200}) {
            scenes.put("2 players, at most " + turns + " turns",
                scene(MAXIMUM, MAXIMUM.replace("500", Integer.toString(turns))));
        }
        return scenes;
    }

    /** The official scene with some things changed: what, and into what. */
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
