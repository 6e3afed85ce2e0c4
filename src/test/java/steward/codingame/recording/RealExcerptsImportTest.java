package steward.codingame.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.game.GroundTruth;
import steward.game.podrace.PodRace;
import steward.game.podrace.protocol.PodRaceType;
import steward.match.TestScenes;
import steward.replay.verify.ReplayDifference;
import steward.replay.verify.Verification;
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

    private final ByteArrayOutputStream replay = new ByteArrayOutputStream();

    private Verification verified(String json, String name) throws InterruptedException {
        RecordingImport.of(json, name, TestScenes.TYPES).write(replay);
        return TextMatches.verify(replay.toByteArray());
    }

    @Test
    void theSitesOwnJsonVerifies(TestReporter report) throws IOException, InterruptedException {
        Path file = GroundTruth.replay("game_870230020_excerpt.json");
        Verification verification = verified(Files.readString(file), "excerpt");
        assertNull(verification.difference());
        assertEquals(1, verification.turns());
        new GroundTruth.Report(report, "pod-race of 2026").add(file.getFileName().toString(), 1,
            verification.views().values(), null, verification.views().notCompared());
        String text = replay.toString(StandardCharsets.UTF_8);
        assertTrue(text.contains("\\n1:99 2:99\\n") && text.contains(" 11574 3374 ") && text.contains(" 3 639\\n"),
            text);
        assertEquals(0, verification.views().nearInAll());
    }

    /** Impact times and impulses are among what is compared: to the last bit in these turns. */
    @ParameterizedTest
    @CsvSource({"turns_870230020.txt, 12, 3", "turns_888655750.txt, 8, 3"})
    void theFirstTurnsOfAGameVerify(String name, int turns, int impacts) throws IOException, InterruptedException {
        String json = json(Files.readAllLines(GroundTruth.replay(name)), turns);
        Verification verification = verified(json, name);
        assertNull(verification.difference());
        assertEquals(turns, verification.turns());
        assertEquals(0, verification.views().nearInAll(), "all are equal to the last bit");
        assertEquals(impacts, replay.toString(StandardCharsets.UTF_8).split("\"impulse\"", -1).length - 1);
    }

    /** The server's own impacts; times and impulses are changed by little more than 1e-9 of them. */
    @ParameterizedTest
    @CsvSource({"turns_870230020.txt, 12, 30", "turns_888655750.txt, 8, 30"})
    void eachNumberOfEachImpactIsCompared(String name, int turns, int numbers) throws IOException,
            InterruptedException {
        ObjectNode game = (ObjectNode) JsonMapper.shared().readTree(json(Files.readAllLines(GroundTruth.replay(name)),
            turns));
        int changed = 0;
        for (int turn = 1; turn <= turns; turn++) {
            ObjectNode frame = (ObjectNode) game.get("frames").get(2 * turn);
            String view = frame.get("view").stringValue();
            List<String> lines = view.lines().toList();
            for (int line = FIRST_IMPACT; line < lines.size(); line++) {
                for (int word = 1; word < lines.get(line).split(" ").length; word++, changed++) {
                    String[] words = lines.get(line).split(" ");
                    double number = Double.parseDouble(words[word]);
                    words[word] = number == Math.rint(number) ? Long.toString((long) number + 1)
                        : Double.toString(number * (1 + 1.1e-9));
                    List<String> other = new ArrayList<>(lines);
                    other.set(line, String.join(" ", words));
                    frame.put("view", String.join("\n", other));
                    replay.reset();
                    ReplayDifference found = verified(game.toString(), name).difference();
                    assertEquals("turn " + turn + ", view line " + line + ", word " + word,
                        found == null ? null : "turn " + found.turn() + ", " + found.field());
                }
            }
            frame.put("view", view);
        }
        assertEquals(numbers, changed);
    }

    /** As many turns, in the form of the site's own JSON; what the text files do not have is ours. */
    private static String json(List<String> lines, int turns) {
        PodRaceType.PodRaceSetup official = (PodRaceType.PodRaceSetup) TestScenes.open("mad-pod-racing");
        ObjectNode game = JsonMapper.shared().createObjectNode();
        ArrayNode frames = game.putArray("frames");
        PodRace race = null;
        SiteViews views = null;
        List<String> impacts = new ArrayList<>();
        for (String line : lines) {
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
                        byte[] bytes = answer.getBytes(StandardCharsets.UTF_8);
                        assertNull(official.textCodec(race).orElseThrow().readAnswer(player, bytes, bytes.length));
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
