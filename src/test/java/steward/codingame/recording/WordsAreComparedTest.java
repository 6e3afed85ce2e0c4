package steward.codingame.recording;

import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.StringJoiner;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.game.ChangedWords;
import steward.game.GroundTruth;
import steward.match.TestSize;
import steward.replay.verify.Verification;
import steward.replay.verify.ViewComparison;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * Numbers and words of the frames of a turn of the server, changed one at a time: the import refuses it, or the
 * verification finds it or names it as near, or it is among those that the verification says are not compared. Every
 * 13th is changed in {@code test}, and each in {@code campaigns}.
 */
@Tag("slow")
@Tag("sized")
@Execution(ExecutionMode.CONCURRENT)
class WordsAreComparedTest {

    private static final Pattern WORD = Pattern.compile("[^\\s\"]+");
    private static final Pattern JSON_WORD = Pattern.compile("-?[0-9]+(\\.[0-9]+)?|[A-Za-z]+");

    private final Map<String, Integer> missed = new TreeMap<>();
    private int changed;
    private int words;

    /** Of so many words one is changed. */
    private static int step() {
        return TestSize.of(13, 1);
    }

    /** Requires that exactly these are not found, or no others where words are left out. */
    private void assertMissed(Set<String> expected, String why) {
        assertTrue(expected.containsAll(missed.keySet()) && (step() > 1 || missed.size() == expected.size()),
            () -> "not found: " + missed + " " + why);
    }

    /** The excerpt lacks what the server's referee was given: it is put together from the first frame. */
    @Test
    void ofThePodRace(TestReporter report) throws IOException {
        ObjectNode game = upTo(GroundTruth.replay("game_870230020_excerpt.json"), 2);
        String map = game.get("frames").get(0).get("view").asString().split("\n")[3];
        check(report, "pod-race", game.put("refereeInput", "seed=1\nmap=" + map + "\n"));
        assertMissed(Set.of("view line 10, word 0"), "and the number of an impact");
    }

    @Test
    void ofMeanMax(TestReporter report) throws IOException {
        check(report, "mean-max", upTo(GroundTruth.RECORDINGS.files("mean-max", "skill_1.json.gz").get(0), 9));
        assertMissed(Set.of(), "");
    }

    @Test
    void ofThePokerChipRace(TestReporter report) throws IOException {
        check(report, "poker-chip-race", upTo(GroundTruth.RECORDINGS.files("poker-chip-race", ".json.gz").get(0), 38));
        assertMissed(Set.of("gameInformation"), "");
    }

    /** Turn played here in which a checkpoint is passed; {@code refereeInput} names the map. */
    @Test
    void ofTheSearchRace(TestReporter report) {
        ObjectNode game = ServerGame.searchRace();
        ArrayNode frames = (ArrayNode) game.get("frames");
        int last = 1;
        while (frames.get(last).path("summary").asString().isEmpty()) {
            last++;
        }
        ImportedRecording.cut(game, last + 1);
        Matcher place = Pattern.compile("x = ([0-9]+)\\\\ny = ([0-9]+)").matcher(frames.get(0).get("view").asString());
        StringJoiner map = new StringJoiner(";");
        while (place.find()) {
            map.add(place.group(1) + " " + place.group(2));
        }
        check(report, "search-race", game.put("refereeInput", map.toString()));
        assertMissed(Set.of(), "");
    }

    /** Lines of a game of the server; after the last answer no more is shown. */
    @Test
    void ofTheLinesOfASearchRace(TestReporter report) throws IOException {
        ObjectNode game = (ObjectNode) JsonMapper.shared().readTree(Files.readString(
            GroundTruth.RECORDINGS.files("search-race", "game1.json").get(0)));
        assertNull(difference(game), "as it is");
        for (String name : List.of("stdin", "stdout")) {
            ArrayNode lines = (ArrayNode) game.get(name);
            for (int line = 0; line < lines.size(); line++) {
                String text = lines.get(line).stringValue();
                for (ChangedWords change : ChangedWords.of(text, WORD, ChangedWords::otherEnd)) {
                    lines.set(line, change.text());
                    look(game, name + (line == lines.size() - 1 ? ", the last line" : ""));
                }
                lines.set(line, text);
            }
        }
        GroundTruth.tell(report, ChangedWords.told("search-race, lines", changed, missed));
        assertMissed(Set.of("stdout, the last line"), "");
    }

    /** Turn played here: the form is that of the published referee. */
    @Test
    void ofFantasticBits(TestReporter report) {
        ObjectNode game = ServerGame.fantasticBits();
        check(report, "fantastic-bits", game);
        assertMissed(Set.of("view line 19, word 1", "view line 20, word 1"), "numbers of meetings");
    }

    /** Changes the frames of the last turn, and frame 0. */
    private void check(TestReporter report, String name, ObjectNode game) {
        assertNull(difference(game), "as it is");
        ArrayNode frames = (ArrayNode) game.get("frames");
        int last = frames.size() - 1;
        int from = last;
        while (from > 1 && !frames.get(from - 1).get("keyframe").asBoolean()) {
            from--;
        }
        changeAll(game, 0);
        for (int frame = from; frame <= last; frame++) {
            changeAll(game, frame);
        }
        assertTrue(words > 100, "there are words");
        GroundTruth.tell(report, ChangedWords.told(name, changed, missed));
    }

    private static ObjectNode upTo(Path file, int last) throws IOException {
        JsonNode json = JsonMapper.shared().readTree(GroundTruth.text(file));
        ObjectNode game = (ObjectNode) (json.has("success") ? json.get("success") : json);
        game.remove(List.of("scores", "ranks"));
        ImportedRecording.cut(game, last + 1);
        return game;
    }

    private void changeAll(ObjectNode game, int frame) {
        ObjectNode of = ImportedRecording.frame(game, frame);
        for (String name : new ArrayList<>(of.propertyNames())) {
            JsonNode value = of.get(name);
            if (value.isString() && !name.equals("stderr")) {
                changeWords(game, of, name, value.stringValue());
            } else if (value.isBoolean()) {
                of.put(name, !value.booleanValue());
                look(game, name);
            } else if (value.isNumber()) {
                of.put(name, value.intValue() + 1);
                look(game, name);
            }
            of.set(name, value);
        }
    }

    private void changeWords(ObjectNode game, ObjectNode frame, String name, String text) {
        Pattern pattern = text.contains("\n{") ? JSON_WORD : WORD;
        for (ChangedWords change : ChangedWords.of(text, pattern,
            name.equals("stdout") ? WordsAreComparedTest::otherCommand : ChangedWords::otherEnd)) {
            frame.put(name, change.text());
            look(game, name.equals("gameInformation") ? name
                : name + " line " + change.line() + ", word " + change.word());
        }
    }

    /** Of a number of a command so much that it has an effect. */
    private static String otherCommand(String word) {
        if (!word.matches("-?[0-9]+")) {
            return ChangedWords.otherEnd(word);
        }
        long value = Long.parseLong(word);
        return Long.toString(value > 0 && value < 1000 ? value / 2 - 1 : value + 3000);
    }

    private void look(ObjectNode game, String where) {
        words++;
        if (words % step() != 0) {
            return;
        }
        changed++;
        if (difference(game) == null) {
            missed.merge(where, 1, Integer::sum);
        }
    }

    /** Text that is refused or found; {@code null} for nothing. */
    private static String difference(ObjectNode game) {
        try {
            ViewComparison views = new ViewComparison();
            Verification found = ImportedRecording.of(game.toString()).verified(views);
            return found.difference() != null ? found.difference().toString()
                : views.near().stream().findFirst().orElse(null);
        } catch (IllegalArgumentException | DifferentGameException refused) {
            return refused.getMessage();
        }
    }
}
