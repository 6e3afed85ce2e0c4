package steward.machines.token;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import steward.bot.command.Program;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.league.LeagueFolder;
import steward.scene.json.Block;

/**
 * List of a league's workers and invitations, in the private file {@code machines/workers.json}. A worker has a name, a
 * hash of its secret, and marks: revoked or suspected, with the reason, and whether its games are to be set aside. With
 * an invitation, machines become workers by themselves.
 *
 * @param workers     in the order in which they were added
 * @param invitations in the order in which they were made
 */
public record WorkerList(List<Worker> workers, List<Invitation> invitations) {

    /** Form of a worker's name. */
    public static final Pattern NAME = Pattern.compile("[A-Za-z0-9_-]{1,40}");
    /** How many there may be. */
    public static final int MOST = 1000;

    static final Pattern HASH = Pattern.compile("[0-9a-f]{64}");

    /**
     * A worker.
     *
     * @param name    unlike the others'
     * @param hash    SHA-256 of its secret
     * @param revoked why it may play no more, or {@code null}
     * @param aside   true if its games are not to count
     * @param invited name of the invitation with which it came, or {@code null}
     * @param doubt   why its answers are doubted and its games do not count until somebody decides, or {@code null}
     * @param trusted true if it was pardoned after a doubt: later ones are told, and its games count
     */
    public record Worker(String name, String hash, String revoked, boolean aside, String invited, String doubt,
                         boolean trusted) {

        Worker(String name, String hash, String invited) {
            this(name, hash, null, false, invited, null, false);
        }
    }

    public WorkerList {
        workers = List.copyOf(workers);
        invitations = List.copyOf(invitations);
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
            return new WorkerList(List.of(), List.of());
        }
        return PrivateFile.parse(PrivateFile.read(file, "the workers of a league"), file.toString(),
            "a list of workers", block -> {
                List<Worker> workers = new ArrayList<>();
                for (Block each : block.blocks("workers")) {
                    workers.add(new Worker(WorkerToken.pattern(each, "name", NAME),
                        WorkerToken.pattern(each, "hash", HASH), each.has("revoked") ? each.text("revoked") : null,
                        each.flag("aside", false), each.has("invited") ? WorkerToken.pattern(each, "invited", NAME)
                        : null, each.has("doubt") ? each.text("doubt") : null, each.flag("trusted", false)));
                    each.done();
                }
                return new WorkerList(workers, block.has("invitations")
                    ? block.blocks("invitations").stream().map(Invitation::read).toList() : List.of());
            });
    }

    /** Returns a stamp that changes when the file does. */
    public static String stamp(LeagueFolder folder) {
        return Program.stamp(file(folder));
    }

    private WorkerList write(LeagueFolder folder) {
        OutputFiles.privateFolder(folder(folder));
        StringBuilder text = new StringBuilder("{ \"workers\": [");
        for (Worker worker : workers) {
            text.append(text.charAt(text.length() - 1) == '[' ? "\n" : ",\n").append("  { \"name\": \"")
                .append(worker.name()).append("\", \"hash\": \"").append(worker.hash()).append('"');
            if (worker.revoked() != null) {
                text.append(", \"revoked\": \"").append(shown(worker.revoked())).append('"')
                    .append(worker.aside() ? ", \"aside\": true" : "");
            }
            text.append(worker.doubt() == null ? "" : ", \"doubt\": \"" + shown(worker.doubt()) + "\"")
                .append(worker.trusted() ? ", \"trusted\": true" : "");
            text.append(worker.invited() == null ? "" : ", \"invited\": \"" + worker.invited() + "\"").append(" }");
        }
        text.append("\n]");
        if (!invitations.isEmpty()) {
            text.append(", \"invitations\": [\n  ").append(invitations.stream().map(Invitation::text)
                .collect(Collectors.joining(",\n  "))).append("\n]");
        }
        PrivateFile.write(file(folder), text + " }\n", true);
        return this;
    }

    private static String shown(String text) {
        return text.replaceAll("[^ -!#-\\[\\]-~]", "?");
    }

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
        WorkerList list = read(folder).without(name);
        BrokerKey key = new BrokerKey(folder);
        key.make();
        String secret = WorkerToken.newSecret();
        PrivateFile.write(token, new WorkerToken(name, secret, key.fingerprint()).text(), false);
        return list.with(new Worker(name, WorkerToken.hash(secret), null)).write(folder);
    }

    /** @throws InputException if a worker or an invitation cannot have this name, or has it */
    private void checkNew(String name) {
        if (!NAME.matcher(name).matches()) {
            throw new InputException("found the name '" + name + "', expected 1 to 40 letters, digits, underscores and "
                + "hyphens");
        }
        if (of(name).isPresent() || invitation(name).isPresent()) {
            throw new InputException("found " + (of(name).isPresent() ? "a worker" : "an invitation") + " '" + name
                + "' already, expected another name");
        }
    }

    /** Returns this without a revoked worker of a name. @throws InputException if no worker of the name can be added */
    private WorkerList without(String name) {
        List<Worker> others = new ArrayList<>(workers);
        others.removeIf(worker -> worker.name().equals(name) && worker.revoked() != null);
        new WorkerList(others, invitations).checkNew(name);
        if (others.size() == MOST) {
            throw new InputException("found " + MOST + " workers, expected fewer before one is added");
        }
        return new WorkerList(others, invitations);
    }

    private WorkerList with(Worker worker) {
        return new WorkerList(Stream.concat(workers.stream(), Stream.of(worker)).toList(), invitations);
    }

    public Optional<Invitation> invitation(String name) {
        return invitations.stream().filter(invitation -> invitation.name().equals(name)).findFirst();
    }

    /** Returns how many machines have used an invitation. */
    public long used(Invitation invitation) {
        return workers.stream().filter(worker -> invitation.name().equals(worker.invited())).count();
    }

    /**
     * Makes an invitation, and a key for the broker if there is none.
     *
     * @param file where it is written
     * @throws InputException if the name is taken, or the file cannot be written
     */
    public static void invite(LeagueFolder folder, String name, int count, Instant until, Path file) {
        PrivateFile.alone(folder(folder), () -> {
            WorkerList list = read(folder);
            list.checkNew(name);
            BrokerKey key = new BrokerKey(folder);
            key.make();
            String secret = WorkerToken.newSecret();
            PrivateFile.write(file, new Invitation.Letter(name, secret, key.fingerprint()).text(), false);
            return new WorkerList(list.workers(), Stream.concat(list.invitations().stream(), Stream.of(
                new Invitation(name, WorkerToken.hash(secret), count, until, false))).toList()).write(folder);
        });
    }

    /**
     * Takes a machine in with an invitation, under a name and with a key of its own.
     *
     * @return why not, or {@code null} if it is a worker now
     */
    public static String enrol(LeagueFolder folder, String name, String secret, String invitation, Instant now) {
        String[] refusal = {"the invitation is unknown"};
        Predicate<Invitation> isThis = each -> MessageDigest.isEqual(each.hash().getBytes(StandardCharsets.UTF_8),
            WorkerToken.hash(invitation).getBytes(StandardCharsets.UTF_8));
        if (read(folder).invitations().stream().noneMatch(isThis)) {
            return refusal[0];                         // strangers take no lock
        }
        PrivateFile.alone(folder(folder), () -> {
            WorkerList list = read(folder);
            Invitation found = list.invitations().stream().filter(isThis).findFirst().orElseThrow();
            refusal[0] = list.of(name).isPresent() || list.invitation(name).isPresent()
                ? "the key of " + name + " is revoked, or another machine has this name"
                : !NAME.matcher(name).matches() ? "the name of the machine is none of a worker"
                : list.workers().size() == MOST ? "the league has " + MOST + " workers, the most there may be"
                : found.refusal(list.used(found), now);
            return refusal[0] != null ? list
                : list.with(new Worker(name, WorkerToken.hash(secret), found.name())).write(folder);
        });
        return refusal[0];
    }

    /**
     * Revokes a worker: a broker that runs closes its connection. Or an invitation: the workers that came with it stay.
     *
     * @param aside true if its games are not to count
     * @throws InputException if there is none of the name
     */
    public static void revoke(LeagueFolder folder, String name, String why, boolean aside) {
        PrivateFile.alone(folder(folder), () -> {
            WorkerList list = read(folder);
            if (list.invitation(name).isPresent()) {
                return new WorkerList(list.workers(), list.invitations().stream().map(each ->
                    new Invitation(each.name(), each.hash(), each.count(), each.until(),
                        each.revoked() || each.name().equals(name))).toList()).write(folder);
            }
            return changed(folder, name, worker -> new Worker(name, worker.hash(), worker.revoked() == null ? why
                : worker.revoked(), aside || worker.aside() || worker.doubt() != null, worker.invited(), null, false));
        });
    }

    /**
     * Lets a worker play again that is revoked or doubted, with the token that it has.
     *
     * @throws InputException if there is none of the name, or it is neither
     */
    public static void pardon(LeagueFolder folder, String name) {
        PrivateFile.alone(folder(folder), () -> changed(folder, name, worker -> {
            if (worker.revoked() == null && worker.doubt() == null) {
                throw new InputException("found the worker '" + name + "', who may play, expected one that is revoked "
                    + "or doubtful");
            }
            return new Worker(name, worker.hash(), null, false, worker.invited(), null,
                worker.trusted() || worker.doubt() != null);
        }));
    }

    /**
     * Keeps a doubt about the answers of a worker until it is pardoned or revoked.
     *
     * @return false if it is revoked, or was pardoned after an earlier one
     */
    public static boolean doubt(LeagueFolder folder, String name, String why) {
        boolean[] kept = new boolean[1];
        PrivateFile.alone(folder(folder), () -> changed(folder, name, worker -> {
            kept[0] = worker.revoked() == null && !worker.trusted();
            return kept[0] ? new Worker(name, worker.hash(), null, false, worker.invited(), why, false) : worker;
        }));
        return kept[0];
    }

    private static WorkerList changed(LeagueFolder folder, String name, UnaryOperator<Worker> change) {
        WorkerList list = read(folder);
        if (list.of(name).isEmpty()) {
            throw new InputException("found no worker '" + name + "', expected " + (list.workers().isEmpty()
                ? "one that was added" : "one of " + String.join(", ",
                    list.workers().stream().map(Worker::name).toList())));
        }
        return new WorkerList(list.workers().stream().map(worker ->
            worker.name().equals(name) ? change.apply(worker) : worker).toList(), list.invitations()).write(folder);
    }

    /** True if this is the secret of a worker that may play. */
    public boolean admits(String name, String secret) {
        return name != null && secret != null && of(name).filter(worker -> worker.revoked() == null
            && MessageDigest.isEqual(worker.hash().getBytes(StandardCharsets.UTF_8),
                WorkerToken.hash(secret).getBytes(StandardCharsets.UTF_8))).isPresent();
    }
}
