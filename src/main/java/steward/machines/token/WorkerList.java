package steward.machines.token;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.ArrayList;
import java.util.Base64;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.regex.Pattern;
import steward.files.InputException;
import steward.league.LeagueFolder;
import steward.scene.json.Block;
import steward.scene.json.JsonTree;
import steward.scene.json.SceneException;

/**
 * The workers of a league, in the private file {@code machines/workers.json}: of each its name, a hash of its secret,
 * and whether it is revoked, with the reason, and whether its games are to be set aside.
 *
 * @param workers in the order in which they were added
 */
public record WorkerList(List<Worker> workers) {

    /** Form of a worker's name. */
    public static final Pattern NAME = Pattern.compile("[A-Za-z0-9_-]{1,40}");
    /** How many there may be. */
    public static final int MOST = 1000;

    private static final Pattern HASH = Pattern.compile("[0-9a-f]{64}");
    private static final int SECRET_BYTES = 32;

    /**
     * A worker.
     *
     * @param name    unlike the others'
     * @param hash    SHA-256 of its secret
     * @param revoked why it may play no more, or {@code null}
     * @param aside   true if its games are not to count
     */
    public record Worker(String name, String hash, String revoked, boolean aside) {
    }

    /** Copies the list. */
    public WorkerList {
        workers = List.copyOf(workers);
    }

    /** The folder of what is private to a league's broker. */
    static Path folder(LeagueFolder folder) {
        return folder.path().resolve("machines");
    }

    private static Path file(LeagueFolder folder) {
        return folder(folder).resolve("workers.json");
    }

    /** Reads the workers of a league; none if there never were any. */
    public static WorkerList read(LeagueFolder folder) {
        Path file = file(folder);
        if (Files.notExists(file)) {
            return new WorkerList(List.of());
        }
        try {
            String source = file.toString();
            Block block = new Block(source, "", JsonTree.read(PrivateFile.read(file, "the workers of a league"), source,
                "a list of workers"));
            List<Worker> workers = new ArrayList<>();
            for (Block each : block.blocks("workers")) {
                workers.add(new Worker(WorkerToken.pattern(each, "name", NAME), WorkerToken.pattern(each, "hash", HASH),
                    each.has("revoked") ? each.text("revoked") : null, each.flag("aside", false)));
                each.done();
            }
            block.done();
            return new WorkerList(workers);
        } catch (SceneException problem) {
            throw new InputException(problem.getMessage());
        }
    }

    /** Returns a stamp that changes when the file does. */
    public static String stamp(LeagueFolder folder) {
        try {
            return Files.getLastModifiedTime(file(folder)).toInstant() + " " + Files.size(file(folder)) + " "
                + Files.readAttributes(file(folder), BasicFileAttributes.class).fileKey();
        } catch (IOException none) {
            return "none";
        }
    }

    private WorkerList write(LeagueFolder folder) {
        PrivateFile.folder(folder(folder));
        StringBuilder text = new StringBuilder("{ \"workers\": [");
        for (Worker worker : workers) {
            text.append(text.charAt(text.length() - 1) == '[' ? "\n" : ",\n").append("  { \"name\": \"")
                .append(worker.name()).append("\", \"hash\": \"").append(worker.hash()).append('"');
            if (worker.revoked() != null) {
                text.append(", \"revoked\": \"").append(worker.revoked().replaceAll("[^ -!#-\\[\\]-~]", "?"))
                    .append('"').append(worker.aside() ? ", \"aside\": true" : "");
            }
            text.append(" }");
        }
        PrivateFile.write(file(folder), text + "\n] }\n", true);
        return this;
    }

    /** The worker of a name. */
    public Optional<Worker> of(String name) {
        return workers.stream().filter(worker -> worker.name().equals(name)).findFirst();
    }

    /**
     * Adds a worker, or one that is revoked anew: its token is written, and a key for the broker is made if there is
     * none.
     *
     * @throws InputException if one of the name may play, or the token cannot be written
     */
    public static void add(LeagueFolder folder, String name, Path token) {
        PrivateFile.alone(folder(folder), () -> added(folder, name, token));
    }

    private static WorkerList added(LeagueFolder folder, String name, Path token) {
        if (!NAME.matcher(name).matches()) {
            throw new InputException("found the name '" + name + "', expected 1 to 40 letters, digits, underscores and "
                + "hyphens");
        }
        WorkerList list = read(folder);
        List<Worker> workers = new ArrayList<>(list.workers());
        workers.removeIf(worker -> worker.name().equals(name) && worker.revoked() != null);
        if (new WorkerList(workers).of(name).isPresent()) {
            throw new InputException("found a worker '" + name + "' already, expected another name");
        }
        if (workers.size() == MOST) {
            throw new InputException("found " + MOST + " workers, expected fewer before one is added");
        }
        BrokerKey key = new BrokerKey(folder);
        key.make();
        byte[] random = new byte[SECRET_BYTES];
        new SecureRandom().nextBytes(random);
        String secret = Base64.getUrlEncoder().withoutPadding().encodeToString(random);
        PrivateFile.write(token, new WorkerToken(name, secret, key.fingerprint()).text(), false);
        workers.add(new Worker(name, hash(secret), null, false));
        return new WorkerList(workers).write(folder);
    }

    /**
     * Revokes a worker: a broker that runs closes its connection.
     *
     * @param aside true if its games are not to count
     * @throws InputException if there is none of the name
     */
    public static void revoke(LeagueFolder folder, String name, String why, boolean aside) {
        PrivateFile.alone(folder(folder), () -> changed(folder, name, worker -> new Worker(name, worker.hash(),
            worker.revoked() == null ? why : worker.revoked(), aside || worker.aside())));
    }

    /**
     * Lets a revoked worker play again, with the token that it has.
     *
     * @throws InputException if there is none of the name, or it is not revoked
     */
    public static void pardon(LeagueFolder folder, String name) {
        PrivateFile.alone(folder(folder), () -> changed(folder, name, worker -> {
            if (worker.revoked() == null) {
                throw new InputException("found the worker '" + name + "', who may play, expected one that is revoked");
            }
            return new Worker(name, worker.hash(), null, false);
        }));
    }

    private static WorkerList changed(LeagueFolder folder, String name, UnaryOperator<Worker> change) {
        WorkerList list = read(folder);
        if (list.of(name).isEmpty()) {
            throw new InputException("found no worker '" + name + "', expected " + (list.workers().isEmpty()
                ? "one that was added" : "one of " + String.join(", ",
                    list.workers().stream().map(Worker::name).toList())));
        }
        return new WorkerList(list.workers().stream().map(worker ->
            worker.name().equals(name) ? change.apply(worker) : worker).toList()).write(folder);
    }

    private static String hash(String secret) {
        return HexFormat.of().formatHex(BrokerKey.sha256(secret.getBytes(StandardCharsets.UTF_8)));
    }

    /** True if this is the secret of a worker that may play. */
    public boolean admits(String name, String secret) {
        return name != null && secret != null && of(name).filter(worker -> worker.revoked() == null
            && MessageDigest.isEqual(worker.hash().getBytes(StandardCharsets.UTF_8),
                hash(secret).getBytes(StandardCharsets.UTF_8))).isPresent();
    }
}
