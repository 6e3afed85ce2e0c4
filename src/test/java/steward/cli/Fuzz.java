package steward.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import steward.cli.BrokenInputs.Kind;
import steward.cli.league.BrokenRows;
import steward.files.InputException;
import steward.machines.check.BrokenTranscripts;
import steward.machines.wire.IncomingBytes;
import steward.match.Protocol;
import steward.text.TextFormat;

/**
 * Tries broken inputs by the million, see {@link BrokenInputs}, and prints for every target how many were tried and
 * refused, how many a second, and how long the slowest took. Whatever ends in another way than the documented ones is
 * printed with the seed and the number that make it again, and the exit status is then 1.
 *
 * <p>{@code --inputs N} (1,000,000) for each target, {@code --seconds S} at most for all together, {@code --seed S}
 * (12), {@code --only WORD} targets with this word in their name, {@code --trace} the stack of each failure.
 */
public final class Fuzz {

    /** A command with everything that one can have. */
    private static final String COMMAND = "name=codingame:python3 'my bot.py' --level \"3 4\" x\\ y";

    private static final String ROW = "%-48s %9s %9s %9s %11s%n";
    /** After so many failures the next target is tried. */
    private static final int MOST_SHOWN = 5;
    /** Characters of a failure that are shown. */
    private static final int LONGEST_SHOWN = 400;

    private final long seed;
    private final Path folder;
    private final List<String> options;
    private int failures;

    private Fuzz(Path folder, long seed, List<String> options) {
        this.options = options;
        this.folder = folder;
        this.seed = seed;
    }

    /** Tries one input; whether it was refused. */
    interface Target {
        boolean check(int number) throws IOException, InterruptedException;
    }

    record Named(String name, Target target) {
        @Override
        public String toString() {
            return name;
        }
    }

    /** Reads the options, tries, prints. */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        List<String> options = List.of(arguments);
        long inputs = option(options, "--inputs", 1_000_000);
        long seconds = option(options, "--seconds", Long.MAX_VALUE / 2_000_000_000);
        int only = options.indexOf("--only");
        Fuzz fuzz = new Fuzz(Files.createTempDirectory("fuzz-"), option(options, "--seed", 12), options);
        List<Named> all = fuzz.targets();
        List<Named> targets = all.stream()
            .filter(each -> only < 0 || each.name().contains(options.get(only + 1))).toList();
        if (targets.isEmpty()) {
            throw new InputException("--only: found " + options.get(only + 1) + ", expected a part of one of "
                + all.stream().map(Named::name).toList());
        }
        System.out.printf(ROW, "target", "inputs", "refused", "a second", "slowest, ms");
        long nanosEach = TimeUnit.SECONDS.toNanos(seconds) / targets.size();
        for (Named each : targets) {
            fuzz.run(each, inputs, nanosEach);
        }
        System.out.println(fuzz.failures + " failures");
        System.exit(fuzz.failures == 0 ? 0 : 1);
    }

    private static long option(List<String> options, String name, long otherwise) {
        int place = options.indexOf(name);
        return place < 0 ? otherwise : Long.parseLong(options.get(place + 1));
    }

    private List<Named> targets() throws IOException, InterruptedException {
        List<Named> targets = new ArrayList<>(files(folder, seed));
        Kind run = BrokenInputs.league("run");
        targets.add(new Named(run.name(), target(run, Files.createDirectory(folder.resolve("run")), seed)));
        targets.addAll(words(folder, seed));
        BrokenRows rows = new BrokenRows(Files.createDirectory(folder.resolve("rows")), seed);
        targets.add(new Named("row of a league's database", number ->
            rows.check(number) == BrokenRows.Outcome.SEEN));
        targets.addAll(incoming(folder, seed));
        BrokenTranscripts transcripts = new BrokenTranscripts();
        targets.add(new Named("game of a worker", number -> transcripts.check(
            new Mutations(new SplittableRandom(seed * 1_000_003 + number)).of(transcripts.sent()), number % 10 == 0)));
        return targets;
    }

    /** Files of all kinds, each kind in a folder of its own. */
    static List<Named> files(Path folder, long seed) throws IOException {
        List<Named> targets = new ArrayList<>();
        for (Kind kind : BrokenInputs.kinds()) {
            Path own = Files.createDirectory(folder.resolve("kind" + targets.size()));
            targets.add(new Named(kind.name(), target(kind, own, seed)));
        }
        return targets;
    }

    private static Target target(Kind kind, Path folder, long seed) throws IOException {
        BrokenInputs inputs = new BrokenInputs(folder, seed);
        inputs.prepare(kind);
        return number -> inputs.check(kind, inputs.broken(kind, number));
    }

    /** Answers and commands of bots. */
    static List<Named> words(Path folder, long seed) {
        BrokenInputs inputs = new BrokenInputs(folder, seed);
        List<Named> targets = new ArrayList<>();
        for (String answer : List.of("{\"pods\":[{\"x\":1,\"y\":2.5,\"thrust\":100}],\"message\":\"hello\"}",
                "{\"pods\":[{\"x\":1,\"y\":2,\"shield\":true}]}", "1000 2000 100 hello", "1000 -20 SHIELD")) {
            Protocol protocol = answer.startsWith("{") ? Protocol.JSON : Protocol.CODINGAME;
            targets.add(new Named("answer " + answer, number -> inputs.answer(protocol, answer, number)));
        }
        targets.add(new Named("command of a bot", number -> inputs.command(COMMAND, number)));
        return targets;
    }

    /** Targets for bytes from other machines. */
    static List<Named> incoming(Path folder, long seed) throws IOException {
        IncomingBytes incoming = new IncomingBytes(Files.createDirectory(folder.resolve("incoming")), seed);
        return List.of(new Named("message of a worker", incoming::word), new Named("message of a league",
            incoming::league), new Named("job for a worker", incoming::job), new Named("bundle", incoming::bundle));
    }

    private void run(Named each, long inputs, long nanos) throws IOException, InterruptedException {
        long start = System.nanoTime();
        long before = start;
        long slowest = 0;
        int refused = 0;
        int failed = 0;
        int number = 0;
        for (; number < inputs && before - start < nanos && failed < MOST_SHOWN; number++) {
            try {
                refused += each.target().check(number) ? 1 : 0;
            } catch (AssertionError | RuntimeException | StackOverflowError | OutOfMemoryError problem) {
                failed++;
                System.out.println("FAILURE: " + each.name() + ", seed " + seed + ", input " + number + ": "
                    + TextFormat.beginning(String.valueOf(problem), LONGEST_SHOWN));
                if (options.contains("--trace")) {
                    problem.printStackTrace(System.out);
                }
            }
            long now = System.nanoTime();
            slowest = Math.max(slowest, now - before);
            before = now;
        }
        failures += failed;
        System.out.printf(ROW, each.name(), number, refused,
            Math.round(number / Math.max(1e-9, (before - start) / 1e9)), TimeUnit.NANOSECONDS.toMillis(slowest));
    }
}
