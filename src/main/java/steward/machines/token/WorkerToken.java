package steward.machines.token;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.Base64;
import java.util.regex.Pattern;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.files.Sha256;
import steward.scene.json.Block;

/**
 * Token with which a worker joins a league: its name, its secret, and the expected fingerprint of the broker's key.
 *
 * @param secret     43 characters of base64url: 256 bits by lot
 * @param broker     see {@link BrokerKey#fingerprint()}
 * @param invitation secret with which the league takes in a worker that it does not know yet; {@code null} without one,
 *                   and never in the file
 */
public record WorkerToken(String worker, String secret, String broker, String invitation) {

    static final String EXPECTED = "a token, as 'steward league worker add' or 'invite' makes it";
    static final Pattern SECRET = Pattern.compile("[A-Za-z0-9_-]{43}");
    static final Pattern BROKER = Pattern.compile("[0-9a-f]{64}");
    private static final int SECRET_BYTES = 32;
    private static final int LONGEST_HOST = 30;
    private static final int NAME_DIGITS = 6;

    /** Token of a worker that the league knows. */
    public WorkerToken(String worker, String secret, String broker) {
        this(worker, secret, broker, null);
    }

    static String newSecret() {
        byte[] random = new byte[SECRET_BYTES];
        new SecureRandom().nextBytes(random);
        return Base64.getUrlEncoder().withoutPadding().encodeToString(random);
    }

    /** Returns the SHA-256 of a secret, as lists keep it. */
    static String hash(String secret) {
        return Sha256.hex(secret.getBytes(StandardCharsets.UTF_8));
    }

    /**
     * Returns the token of this machine for an invitation: the one in a file, or a new one that is written there. Its
     * name is the host's, with the first digits of the hash of its key, so that hosts of the same name differ.
     *
     * @throws InputException if the file is the token of another league, or cannot be read or written
     */
    public static WorkerToken invited(Invitation.Letter letter, Path file, String host) {
        if (Files.notExists(file)) {
            String secret = newSecret();
            String name = host.replaceAll("\\..*", "").replaceAll("[^A-Za-z0-9_-]", "-");
            String worker = (name.isEmpty() ? "worker" : name.substring(0, Math.min(LONGEST_HOST, name.length())))
                + "-" + hash(secret).substring(0, NAME_DIGITS);
            OutputFiles.privateFolder(file.toAbsolutePath().getParent());
            PrivateFile.write(file, new WorkerToken(worker, secret, letter.broker()).text(), false);
        }
        WorkerToken own = read(file);
        if (!own.broker().equals(letter.broker())) {
            throw new InputException(file + ": found the key for another league, expected that for the league of the "
                + "invitation " + letter.name() + ", or another file");
        }
        return new WorkerToken(own.worker(), own.secret(), own.broker(), letter.secret());
    }

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
        return PrivateFile.parse(text, source, "a token", block -> {
            block.integer("token", 1, 1);
            return new WorkerToken(pattern(block, "worker", WorkerList.NAME), pattern(block, "secret", SECRET),
                pattern(block, "broker", BROKER));
        });
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
