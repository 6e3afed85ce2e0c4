package steward.codingame.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.game.ChangedWords;
import steward.game.CodecText;
import steward.game.GroundTruth;
import steward.game.podrace.PodRace;
import steward.game.podrace.protocol.PodRaceType;
import steward.match.TestScenes;
import steward.replay.verify.ReplayDifference;
import steward.replay.verify.Verification;
import steward.replay.verify.ViewComparison;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * Games of 2026 by CodinGame's server, imported and verified: the first frames of one in its own JSON, and the first
 * turns of others, whose numbers stand at full precision in text files, put into that form.
 */
class RealExcerptsImportTest {

    private static final int PODS = 4;
    private static final int POD_WORDS = 7;
    private static final int FIRST_IMPACT = 10;

    private static final Pattern WORD = Pattern.compile("\\S+");

    @Test
    void theSitesOwnJsonVerifies(TestReporter report) throws IOException {
        Path file = GroundTruth.replay("game_870230020_excerpt.json");
        ImportedRecording recording = ImportedRecording.of(Files.readString(file));
        ViewComparison views = new ViewComparison();
        Verification verification = recording.verified(views);
        assertNull(verification.difference());
        assertEquals(1, verification.turns());
        new GroundTruth.Report(report, "pod-race of 2026").add(file.getFileName().toString(), 1,
            views.values(), null, views.notCompared());
        String text = recording.text();
        assertTrue(text.contains("\\n1:99 2:99\\n") && text.contains(" 11574 3374 ") && text.contains(" 3 639\\n"),
            text);
        assertEquals(0, views.nearInAll());
    }

    /** Impact times and impulses are among what is compared: to the last bit in these turns. */
    @ParameterizedTest
    @CsvSource({"turns_870230020.txt, 12, 3", "turns_888655750.txt, 8, 3"})
    void theFirstTurnsOfAGameVerify(String name, int turns, int impacts) throws IOException {
        ImportedRecording recording = ImportedRecording.of(json(name, turns));
        ViewComparison views = new ViewComparison();
        Verification verification = recording.verified(views);
        assertNull(verification.difference());
        assertEquals(turns, verification.turns());
        assertEquals(0, views.nearInAll(), "all are equal to the last bit");
        assertEquals(impacts, recording.text().split("\"impulse\"", -1).length - 1);
    }

    /** The server's own impacts; times and impulses are changed by little more than 1e-9 of them. */
    @ParameterizedTest
    @CsvSource({"turns_870230020.txt, 12, 30", "turns_888655750.txt, 8, 30"})
    void eachNumberOfEachImpactIsCompared(String name, int turns, int numbers) throws IOException {
        ObjectNode game = (ObjectNode) JsonMapper.shared().readTree(json(name, turns));
        int changed = 0;
        for (int turn = 1; turn <= turns; turn++) {
            ObjectNode frame = ImportedRecording.frame(game, 2 * turn);
            String view = frame.get("view").stringValue();
            for (ChangedWords change : ChangedWords.of(view, WORD, RealExcerptsImportTest::other)) {
                if (change.line() >= FIRST_IMPACT && change.word() > 0) {
                    changed++;
                    frame.put("view", change.text());
                    ReplayDifference found = ImportedRecording.verified(game).difference();
                    assertEquals("turn " + turn + ", view line " + change.line() + ", word " + change.word(),
                        found == null ? null : "turn " + found.turn() + ", " + found.field());
                }
            }
            frame.put("view", view);
        }
        assertEquals(numbers, changed);
    }

    private static String other(String word) {
        double number = word.matches("[-0-9.E]+") ? Double.parseDouble(word) : 0;
        return number == Math.rint(number) ? Long.toString((long) number + 1) : Double.toString(number * (1 + 1.1e-9));
    }

    /** As many turns, in the form of the site's own JSON; what the text files do not have is ours. */
    private static String json(String name, int turns) throws IOException {
        PodRaceType.PodRaceSetup official = (PodRaceType.PodRaceSetup) TestScenes.open("mad-pod-racing");
        ObjectNode game = JsonMapper.shared().createObjectNode();
        ArrayNode frames = game.putArray("frames");
        PodRace race = null;
        SiteViews views = null;
        List<String> impacts = new ArrayList<>();
        for (String line : Files.readAllLines(GroundTruth.replay(name))) {
            String[] words = line.split(" ");
            switch (words[0]) {
                case "CHECKPOINTS" -> {
                    race = official.create(points(words));
                    views = new SiteViews(race);
                }
                case "S" -> {
                    if (frames.isEmpty()) {
                        frames.addObject().put("agentId", -1).put("keyframe", true).put("view",
                            views.first(pods(words)));
                    } else {
                        ((ObjectNode) frames.get(frames.size() - 1)).put("view", views.after(Integer.parseInt(words[1]),
                            pods(words), "") + String.join("\n", impacts));
                    }
                    impacts.clear();
                }
                case "M" -> {
                    if (frames.size() > 2 * turns) {
                        return game.toString();
                    }
                    for (int player = 0; player < 2; player++) {
                        String[] said = Arrays.copyOfRange(words, 1 + 6 * player, 7 + 6 * player);
                        String answer = String.join(" ", said[0], said[1], said[2]) + "\n"
                            + String.join(" ", said[3], said[4], said[5]);
                        assertNull(CodecText.read(official.textCodec(race).orElseThrow(), player, answer));
                        frames.addObject().put("agentId", player).put("keyframe", player == 1).put("stdout", answer);
                    }
                    views.before();
                    race.play();
                }
                case "C" -> impacts.add(impacts.size() + line.substring(1));
                default -> { }
            }
        }
        return game.toString();
    }

    private static double[][] points(String[] words) {
        double[][] points = new double[words.length / 2][];
        for (int k = 0; k < points.length; k++) {
            points[k] = new double[] {Double.parseDouble(words[1 + 2 * k]), Double.parseDouble(words[2 + 2 * k])};
        }
        return points;
    }

    /** Of each pod {@code x y vx vy heading shield next}. */
    private static List<String[]> pods(String[] words) {
        List<String[]> pods = new ArrayList<>();
        for (int pod = 0; pod < PODS; pod++) {
            pods.add(Arrays.copyOfRange(words, 2 + POD_WORDS * pod, 2 + POD_WORDS * (pod + 1)));
        }
        return pods;
    }
}
