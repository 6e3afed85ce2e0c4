package steward.guest;

import java.util.List;
import steward.scene.json.Block;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * Test cases of a guest for one player, and how its results are compared.
 *
 * @param tests         lines of the block INIT in place of the seed, for each test; empty if the seed is sent
 * @param criterion     key of the block METADATA whose value is the score; empty for the score of the block SCORES
 * @param lowerIsBetter whether a lower value is better
 */
record SoloTests(List<List<String>> tests, String criterion, boolean lowerIsBetter) {

    static final SoloTests NONE = new SoloTests(List.of(), "", false);
    /** Field of a scene: all tests, each an object with its lines. */
    static final String FIELD = "tests";
    static final String CRITERION = "criterion";
    static final String LOWER = "lowerIsBetter";
    /** Score of a game without a value where a lower one is better: worse than what games count. */
    private static final double WORST = 1e12;

    static SoloTests read(Block block) {
        if (block.contains("testIn") && block.contains(FIELD)) {
            throw block.error(FIELD, "testIn and tests", "one of them");
        }
        List<List<String>> tests = block.has("testIn") ? List.of(block.texts("testIn"))
            : block.has(FIELD) ? block.blocks(FIELD).stream().map(test -> test.texts("testIn")).toList()
            : List.of();
        if (block.has(FIELD) && tests.isEmpty()) {
            throw block.error(FIELD, "no tests", "at least one");
        }
        return new SoloTests(tests, block.has(CRITERION) ? block.text(CRITERION) : "", block.flag(LOWER, false));
    }

    /** Lines of the test of a seed: seed 1 plays the first, and after the last comes the first again. */
    List<String> lines(long seed) {
        return tests.isEmpty() ? List.of("seed=" + seed)
            : tests.get((int) Math.floorMod(seed - 1, (long) tests.size()));
    }

    /** Seed that plays the test with these lines. @throws IllegalArgumentException if there is none */
    long seed(List<String> lines) {
        for (int test = 0; test < tests.size(); test++) {
            if (tests.get(test).stream().map(String::strip).filter(line -> !line.isEmpty()).toList().equals(lines)) {
                return test + 1;
            }
        }
        throw new IllegalArgumentException("found " + (lines.isEmpty() ? "nothing" : "lines of no test of the scene")
            + ", expected those of one of its " + tests.size() + " tests");
    }

    /**
     * Returns the score of a game: the criterion's value, unless the referee says that the test was failed.
     *
     * @param metadata the last block METADATA, or {@code null}
     * @param score    in the block SCORES, more than 0 where the test was passed
     */
    double score(String metadata, double score) {
        if (criterion.isEmpty() || score <= 0) {
            return lowerIsBetter && !criterion.isEmpty() ? WORST - score : score;
        }
        try {
            JsonNode value = JsonMapper.shared().readTree(metadata == null ? "{}" : metadata).path(criterion);
            double number = Double.parseDouble(value.asString("").strip());
            if (Math.abs(number) < WORST) {
                return number;
            }
        } catch (JacksonException | NumberFormatException textual) {
            // Without a number in it the score counts.
        }
        return lowerIsBetter ? WORST - score : score;
    }
}
