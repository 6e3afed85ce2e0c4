package steward.machines.token;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.DateTimeException;
import java.time.Instant;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import java.util.stream.Collectors;
import steward.files.InputException;
import steward.league.LeagueFolder;
import steward.scene.json.Block;

/**
 * Pauses of workers that cannot play: a second after the first failure, twice as long after each further one. After a
 * pause the worker gets one job as a test, and plays on if its result is accepted. Pauses are kept in the league's
 * private file {@code machines/pauses.json}, so that the next run continues them. Thread-safe.
 */
public final class WorkerPauses {

    private static final long FIRST_MS = TimeUnit.SECONDS.toMillis(1);
    private static final long LONGEST_MS = TimeUnit.MINUTES.toMillis(10);
    private static final int MOST_SECONDS = (int) TimeUnit.DAYS.toSeconds(1);

    private final LongSupplier clock;
    private final Path folder;
    private final Map<String, Pause> pauses = new HashMap<>();
    /** Workers that have been given their test. */
    private final Set<String> tested = new HashSet<>();

    /**
     * A pause.
     *
     * @param length in milliseconds, whole seconds
     * @param began  milliseconds since 1970
     */
    private record Pause(long length, long began) { }

    /**
     * Goes on with the pauses of earlier runs.
     *
     * @param clock milliseconds since 1970
     * @throws InputException if their file is damaged
     */
    public WorkerPauses(LongSupplier clock, LeagueFolder league) {
        this.clock = clock;
        folder = WorkerList.folder(league);
        if (Files.exists(file())) {
            read();
        }
    }

    /**
     * Begins a pause, or a longer one if the test has failed; failures of games that were under way change nothing.
     *
     * @return true if the worker was not paused before
     */
    public boolean failed(String worker) {
        Map<String, Pause> changed;
        boolean isNew;
        synchronized (this) {
            Pause pause = pauses.get(worker);
            isNew = pause == null;
            if (!isNew && !isDue(pause)) {
                return false;
            }
            pauses.put(worker, new Pause(isNew ? FIRST_MS : Math.min(LONGEST_MS, 2 * pause.length()),
                clock.getAsLong()));
            tested.remove(worker);
            changed = Map.copyOf(pauses);
        }
        write(changed);                                // the broker's threads do not wait for it
        return isNew;
    }

    /** Ends a pause. @return true if there was one */
    public boolean played(String worker) {
        Map<String, Pause> changed;
        synchronized (this) {
            if (pauses.remove(worker) == null) {
                return false;
            }
            changed = Map.copyOf(pauses);
        }
        write(changed);
        return true;
    }

    /** Returns how many jobs a worker may have at the same time, of so many without a pause. */
    public synchronized int places(String worker, int usual) {
        Pause pause = pauses.get(worker);
        return pause == null ? usual : isDue(pause) ? Math.min(1, usual) : 0;
    }

    /** True if a job may be handed to a worker: it is not paused, or is to be tested. */
    public synchronized boolean mayTake(String worker) {
        Pause pause = pauses.get(worker);
        return pause == null || isDue(pause) && !tested.contains(worker);
    }

    /** Voids a test that a worker was given: it has joined anew, or the games of the test go to others. */
    public synchronized void untested(String worker) {
        tested.remove(worker);
    }

    /**
     * Notes that a worker has been handed a job. One that was handed over before the pause was over is no test: its
     * failure is ignored, so that no other test would ever follow.
     */
    public synchronized void took(String worker) {
        Pause pause = pauses.get(worker);
        if (pause != null && isDue(pause)) {
            tested.add(worker);
        }
    }

    /** True if a pause is over, also when the clock was set back meanwhile. */
    private boolean isDue(Pause pause) {
        long now = clock.getAsLong();
        return now - pause.began() >= pause.length() || now < pause.began();
    }

    private Path file() {
        return folder.resolve("pauses.json");
    }

    private void read() {
        pauses.putAll(PrivateFile.parse(PrivateFile.read(file(), "the pauses of workers"), file().toString(),
            "pauses of workers", block -> {
                Map<String, Pause> read = new HashMap<>();
                for (Block each : block.blocks("pauses")) {
                    read.put(WorkerToken.pattern(each, "worker", WorkerList.NAME), new Pause(
                        TimeUnit.SECONDS.toMillis(each.integer("seconds", 1, MOST_SECONDS)), moment(each)));
                    each.done();
                }
                return read;
            }));
    }

    private static long moment(Block pause) {
        try {
            return Instant.parse(pause.text("since")).toEpochMilli();
        } catch (DateTimeException | ArithmeticException problem) {
            throw pause.error("since", pause.shown("since"), "a moment such as 2026-12-24T22:59:59Z");
        }
    }

    private void write(Map<String, Pause> all) {
        PrivateFile.alone(folder, () -> {
            PrivateFile.write(file(), all.entrySet().stream().map(each -> "  { \"worker\": \"" + each.getKey()
                + "\", \"seconds\": " + TimeUnit.MILLISECONDS.toSeconds(each.getValue().length())
                + ", \"since\": \"" + Instant.ofEpochMilli(each.getValue().began()) + "\" }")
                .collect(Collectors.joining(",\n", "{ \"pauses\": [\n", "\n] }\n")), true);
            return null;
        });
    }
}
