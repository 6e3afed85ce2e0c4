package steward.contest;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;
import steward.bot.command.Program;
import steward.contest.Contest.Entrant;
import steward.files.ElfFile;
import steward.files.Sha256;
import steward.match.Protocol;

/**
 * Watch over the files of the bots' programs while several games are played. If a file is missing or being written, it
 * waits until all files are present, have been unchanged for a second, are not cut off, and each program can be
 * started. Thread-safe.
 */
public final class ProgramWatch {

    /** How long files have to stand unchanged, in nanoseconds. */
    private static final long REST_NANOS = TimeUnit.SECONDS.toNanos(1);
    /** How long a thread sleeps that waits for files, in milliseconds. */
    private static final long LOOK_MS = 50;
    private static final String CLASS = ".class";

    private final List<Watched> programs;
    private final Consumer<String> teller;
    /** By program: files that have to be there. */
    private final List<List<Path>> files;
    /** Guarded by this, as is all below. */
    private String accepted;
    private Map<Path, String> digests = new LinkedHashMap<>();
    private String seen = "";
    private long since;
    private String told = "";
    private String waitsFor;
    private String changed;

    /** State of the programs. */
    public enum State {
        /** No file has been touched. */
        SAME,
        /** Files are missing or being written, or a program cannot be started. */
        WAITING,
        /** Files were touched, and have come to rest. */
        TOUCHED
    }

    /**
     * A program.
     *
     * @param name    of its bot
     * @param problem why it cannot be started now; gives {@code null} if it can be
     */
    public record Watched(String name, Program program, Supplier<String> problem) { }

    /**
     * Begins to watch programs as they are now.
     *
     * @param teller is told what is waited for, by any thread
     */
    public ProgramWatch(List<Watched> programs, Consumer<String> teller) {
        this.programs = List.copyOf(programs);
        this.teller = teller;
        files = programs.stream().map(each -> each.program().paths()).toList();
        accepted = stamp();
    }

    /** Begins to watch the programs of a contest's bots; their content is compared when they have been touched. */
    public static ProgramWatch of(Contest contest, Consumer<String> teller) {
        ProgramWatch watch = new ProgramWatch(contest.entrants().stream().map(ProgramWatch::watched).toList(), teller);
        watch.digests = watch.read();
        return watch;
    }

    private static Watched watched(Entrant entrant) {
        return new Watched(entrant.name(), entrant.program(), () -> entrant.problem() != null || entrant.isBuiltin()
            ? null : Contest.entrant(entrant.bot(), entrant.program().folder(), null, Protocol.JSON).problem());
    }

    private String stamp() {
        StringBuilder stamps = new StringBuilder();
        programs.forEach(each -> stamps.append(each.program().stamp()).append('\n'));
        return stamps.toString();
    }

    /** Looks at all files. */
    public synchronized State look() {
        String now = stamp();
        waitsFor = null;
        if (now.equals(accepted)) {
            seen = now;
            return State.SAME;
        }
        if (!now.equals(seen)) {
            seen = now;
            since = System.nanoTime();
        }
        return System.nanoTime() - since < REST_NANOS || !isUsable() ? State.WAITING : State.TOUCHED;
    }

    /** True if no file is missing and every program can be started; otherwise it is told, once. */
    private boolean isUsable() {
        for (int k = 0; k < programs.size(); k++) {
            String bot = "bot '" + programs.get(k).name() + "': ";
            Path missing = missing(files.get(k));
            Path cut = files.get(k).stream().filter(ElfFile::isCutOff).findFirst().orElse(null);
            String problem = missing != null ? bot + "there is no file " + missing
                : cut != null ? bot + cut + " is cut off: its header promises more" : programs.get(k).problem().get();
            if (problem != null) {
                if (!problem.equals(told)) {
                    teller.accept(problem + "; it is waited for");
                }
                told = problem;
                waitsFor = programs.get(k).name();
                return false;
            }
        }
        told = "";
        return true;
    }

    /** The bot that could not be started when files were looked at, all of them at rest; or {@code null}. */
    public synchronized String waitsFor() {
        return waitsFor;
    }

    /** A file that is not there, or {@code null}; of classes only where none is: they come and go with the source. */
    private static Path missing(List<Path> files) {
        List<Path> gone = files.stream().filter(file -> !Files.exists(file)).toList();
        boolean noClass = files.stream().filter(ProgramWatch::isClass).noneMatch(Files::exists);
        return gone.stream().filter(file -> noClass || !isClass(file)).findFirst().orElse(null);
    }

    private static boolean isClass(Path file) {
        return file.toString().endsWith(CLASS);
    }

    /** Returns what {@link #isSince} takes: the programs as they were when they last were at rest. */
    public synchronized String mark() {
        return accepted;
    }

    /** True if no file has been touched since a mark. */
    public boolean isSince(String mark) {
        return stamp().equals(mark);
    }

    /**
     * Waits while files are missing or being written.
     *
     * @param over asked now and then whether waiting is in vain
     * @return false if a program has become another one, or it is over
     */
    public boolean await(BooleanSupplier over) throws InterruptedException {
        while (!over.getAsBoolean()) {
            synchronized (this) {
                State state = changed != null ? State.TOUCHED : look();
                if (state == State.SAME || state == State.TOUCHED && isTakenAsBefore()) {
                    return true;
                }
                if (changed != null) {
                    return false;
                }
            }
            Thread.sleep(LOOK_MS);
        }
        return false;
    }

    /** Compares contents: files that were only touched, or made anew alike, are the same program. */
    private boolean isTakenAsBefore() {
        Map<Path, String> now = changed == null ? read() : digests;
        if (changed != null || !stamp().equals(seen)) {
            return false;                              // written while it was read: it is looked at again
        }
        List<Path> all = new ArrayList<>(digests.keySet());
        now.keySet().stream().filter(file -> !digests.containsKey(file)).forEach(all::add);
        changed = all.stream().filter(file -> !Objects.equals(digests.get(file), now.get(file))).findFirst()
            .map(Path::toString).orElse(null);
        accepted = changed == null ? seen : accepted;
        return changed == null;
    }

    private Map<Path, String> read() {
        Map<Path, String> read = new LinkedHashMap<>();
        for (Watched each : programs) {
            for (Path file : each.program().paths()) {
                read.put(file, digest(file));
            }
        }
        return read;
    }

    private static String digest(Path file) {
        try {
            return Sha256.hex(file);
        } catch (IOException unreadable) {
            return "";
        }
    }

    /** The file by which a program became another one, or {@code null}. */
    public synchronized String changed() {
        return changed;
    }
}
