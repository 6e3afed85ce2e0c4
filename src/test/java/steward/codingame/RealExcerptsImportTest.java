package steward.codingame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.match.TestScenes;
import steward.replay.verify.Verification;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * What CodinGame's server said of games of 2026, imported and verified: the first frames of one in its own JSON, and
 * the first turns of others, whose numbers stand at full precision in text files, put into that form.
 */
class RealExcerptsImportTest {

    private static final int PODS = 4;
    private static final int POD_WORDS = 7;

    private final ByteArrayOutputStream replay = new ByteArrayOutputStream();

    private static Path file(String name) {
        Path file = Path.of(System.getProperty("steward.replays", "../shared/replays")).resolve(name);
        assumeTrue(Files.isRegularFile(file),
            () -> "skipped: there is no " + file.toAbsolutePath() + " (set -Dsteward.replays)");
        return file;
    }

    private Verification verified(String json, String name) throws InterruptedException {
        GameRecordingImport.of(json, name, TestScenes.TYPES).write(replay);
        return TextMatches.verify(replay.toByteArray());
    }

    @Test
    void theSitesOwnJsonVerifies() throws IOException, InterruptedException {
        Verification verification = verified(Files.readString(file("game_870230020_excerpt.json")), "excerpt");
        assertNull(verification.difference());
        assertEquals(1, verification.turns());
        String text = replay.toString(StandardCharsets.UTF_8);
        assertTrue(text.contains("\"turnsLeft\":[99,99]},\"ranks\":[0,1]"), text);
        assertTrue(text.contains("\"ax\":11574,\"ay\":3374,\"bx\":10884,\"by\":3778,") && text.contains(
            "\"meanVx\":3,\"meanVy\":639}"), text);
    }

    /** Impact times and impulses are among what is compared: to the last bit in these turns. */
    @ParameterizedTest
    @CsvSource({"turns_870230020.txt, 12, 3", "turns_888655750.txt, 8, 3"})
    void theFirstTurnsOfAGameVerify(String name, int turns, int impacts) throws IOException, InterruptedException {
        String json = json(Files.readAllLines(file(name)), turns);
        Verification verification = verified(json, name);
        assertNull(verification.difference());
        assertEquals(turns, verification.turns());
        assertEquals(impacts, replay.toString(StandardCharsets.UTF_8).split("\"impulse\"", -1).length - 1);
    }

    /** As many turns, in the form of the site's own JSON. */
    private static String json(List<String> lines, int turns) {
        ObjectNode game = JsonMapper.shared().createObjectNode();
        ArrayNode frames = game.putArray("frames");
        String map = "";
        Counters counters = null;
        List<String> impacts = new ArrayList<>();
        for (String line : lines) {
            String[] words = line.split(" ");
            switch (words[0]) {
                case "CHECKPOINTS" -> map = line.substring("CHECKPOINTS ".length());
                case "S" -> {
                    if (frames.isEmpty()) {
                        counters = new Counters(map.split(" "));
                        frames.addObject().put("agentId", -1).put("keyframe", true).put("view",
                            " 0\nCodersStrikeBack\n16000 9000 400 600 4 0.3141592653589793\n" + map + "\nstarts\n"
                                + pods(words));
                    } else {
                        ((ObjectNode) frames.get(frames.size() - 1)).put("view", " " + words[1] + "\n" + pods(words)
                            + counters.after(words) + "\n" + String.join("\n", impacts));
                    }
                    impacts.clear();
                }
                case "M" -> {
                    if (frames.size() > 2 * turns) {
                        return game.toString();
                    }
                    for (int player = 0; player < 2; player++) {
                        String[] said = Arrays.copyOfRange(words, 1 + 6 * player, 7 + 6 * player);
                        frames.addObject().put("agentId", player).put("keyframe", player == 1).put("stdout",
                            String.join(" ", said[0], said[1], said[2]) + "\n" + String.join(" ", said[3], said[4],
                                said[5]) + "\n");
                    }
                }
                case "C" -> impacts.add(impacts.size() + line.substring(1));
                default -> { }
            }
        }
        return game.toString();
    }

    private static String pods(String[] words) {
        StringBuilder view = new StringBuilder();
        for (int pod = 0; pod < PODS; pod++) {
            String[] row = Arrays.copyOfRange(words, 2 + POD_WORDS * pod, 2 + POD_WORDS * (pod + 1));
            view.append(String.join(" ", row[0], row[1], row[2], row[3], "0 0 0 0", row[4], row[5], row[6], "1"))
                .append("\n\"\"\n");
        }
        return view.toString();
    }

    /** The counters of both players, which the text files do not have, from their states: no lap is done in them. */
    private static final class Counters {

        private final String[] map;
        private final int[] left = {100, 100};
        private final int[] passed = {2, 2};

        Counters(String[] map) {
            this.map = map;
        }

        String after(String[] words) {
            double[] nearest = new double[2];
            int[] best = new int[2];
            for (int player = 0; player < 2; player++) {
                int sum = 0;
                for (int pod = 2 * player; pod < 2 * player + 2; pod++) {
                    int next = Integer.parseInt(words[2 + POD_WORDS * pod + 6]);
                    double distance = Math.hypot(number(words, pod, 0) - Double.parseDouble(map[2 * next]),
                        number(words, pod, 1) - Double.parseDouble(map[2 * next + 1]));
                    boolean better = next > best[player] || next == best[player] && distance < nearest[player];
                    nearest[player] = better ? distance : nearest[player];
                    best[player] = Math.max(next, best[player]);
                    sum += next;
                }
                left[player] = sum > passed[player] ? 100 : left[player] - 1;
                passed[player] = sum;
            }
            boolean first = best[0] > best[1] || best[0] == best[1] && nearest[0] < nearest[1];
            return (first ? 1 : 2) + ":" + left[0] + " " + (first ? 2 : 1) + ":" + left[1];
        }

        private static double number(String[] words, int pod, int column) {
            return Double.parseDouble(words[2 + POD_WORDS * pod + column]);
        }
    }
}
