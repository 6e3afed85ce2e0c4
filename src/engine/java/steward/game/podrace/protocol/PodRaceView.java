package steward.game.podrace.protocol;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.game.ServerView;
import steward.game.ShownSeed;
import steward.scene.SceneFiles;
import steward.text.ViewLines;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * Reader of a pod race's map from a server's recording: the first view has the checkpoints, {@code refereeInput} may
 * too.
 */
final class PodRaceView implements ServerView {

    static final String TITLE = "CodersStrikeBack";

    private static final int PODS = 4;
    private static final int SIZES_LINE = 2;
    private static final int CHECKPOINT_LINE = 3;
    private static final int PODS_WORD = 4;
    private static final Pattern MAP = Pattern.compile("(?m)^map=(.*)$");

    @Override
    public String title() {
        return TITLE;
    }

    /** The official scene on the recorded map. */
    @Override
    public Start open(ViewLines first, String input) {
        String[] sizes = first.words(SIZES_LINE);
        if (sizes.length > PODS_WORD && first.number(sizes[PODS_WORD], SIZES_LINE) != PODS) {
            throw first.wrong(SIZES_LINE, PODS + " pods as the fifth number: two players with two each");
        }
        String[] words = first.words(CHECKPOINT_LINE);
        if (words.length < 4 || words.length % 2 != 0) {
            throw first.wrong(CHECKPOINT_LINE, "x y of two or more checkpoints");
        }
        ObjectNode scene = (ObjectNode) JsonMapper.shared().readTree(SceneFiles.load("mad-pod-racing").text());
        ObjectNode race = ((ObjectNode) scene.get("race")).put("shift", false).put("jitter", 0);
        ArrayNode checkpoints = race.putArray("maps").addObject().putArray("checkpoints");
        for (int k = 0; k < words.length; k += 2) {
            checkpoints.addObject().put("x", first.number(words[k], CHECKPOINT_LINE))
                .put("y", first.number(words[k + 1], CHECKPOINT_LINE));
        }
        Matcher map = MAP.matcher(input);
        if (map.find() && !isSame(map.group(1).strip().split("\\s+"), words)) {
            throw new IllegalArgumentException(first.source() + ": refereeInput: found "
                + ViewLines.quote(map.group().strip()) + ", expected the checkpoints of frame 0");
        }
        return new Start(scene.toString(), ShownSeed.of(input).orElse(0));
    }

    private static boolean isSame(String[] map, String... words) {
        boolean same = map.length == words.length;
        for (int k = 0; same && k < words.length; k++) {
            same = map[k].matches("-?[0-9]{1,9}") && Double.parseDouble(map[k]) == Double.parseDouble(words[k]);
        }
        return same;
    }

    /** Every pod aims at its own place, which has no effect. */
    @Override
    public List<String> idle(String sent, int lines) {
        return sent.lines().limit(lines).map(line -> line.split(" "))
            .map(pod -> pod[0] + " " + pod[1] + " 0 not asked any more").toList();
    }
}
