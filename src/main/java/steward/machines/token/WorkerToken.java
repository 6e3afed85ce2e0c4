package steward.machines.token;

import java.nio.file.Path;
import java.util.regex.Pattern;
import steward.files.InputException;
import steward.scene.json.Block;
import steward.scene.json.JsonTree;
import steward.scene.json.SceneException;

/**
 * Token with which a worker joins a league: its name and secret, and the fingerprint of the key that the broker has to
 * have.
 *
 * @param worker its name
 * @param secret 43 characters of base64url: 256 bits by lot
 * @param broker see {@link BrokerKey#fingerprint()}
 */
public record WorkerToken(String worker, String secret, String broker) {

    private static final String EXPECTED = "a token, as 'steward league worker add' makes it";
    private static final Pattern SECRET = Pattern.compile("[A-Za-z0-9_-]{43}");
    private static final Pattern BROKER = Pattern.compile("[0-9a-f]{64}");

    /**
     * Reads the file of a token.
     *
     * @throws InputException if it is none
     */
    public static WorkerToken read(Path file) {
        return parse(PrivateFile.read(file, EXPECTED), file.toString());
    }

    /**
     * Reads a token.
     *
     * @param source names it in errors
     * @throws InputException if it is none
     */
    public static WorkerToken parse(String text, String source) {
        try {
            Block block = new Block(source, "", JsonTree.read(text, source, "a token"));
            block.integer("token", 1, 1);
            WorkerToken token = new WorkerToken(name(block), pattern(block, "secret", SECRET),
                pattern(block, "broker", BROKER));
            block.done();
            return token;
        } catch (SceneException problem) {
            throw new InputException(problem.getMessage());
        }
    }

    private static String name(Block block) {
        return pattern(block, "worker", WorkerList.NAME);
    }

    /** A text of a form; what is wrong is not shown, it may be a secret. */
    static String pattern(Block block, String field, Pattern pattern) {
        String text = block.text(field);
        if (!pattern.matcher(text).matches()) {
            throw block.error(field, "a text of " + text.length() + " characters", "one that matches "
                + pattern.pattern());
        }
        return text;
    }

    /** Returns the token as it stands in its file. */
    public String text() {
        return "{ \"token\": 1, \"worker\": \"" + worker + "\", \"secret\": \"" + secret + "\", \"broker\": \"" + broker
            + "\" }\n";
    }

    /** Without the secret. */
    @Override
    public String toString() {
        return "token of " + worker;
    }
}
