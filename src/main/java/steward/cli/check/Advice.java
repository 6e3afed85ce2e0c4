package steward.cli.check;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import steward.bot.FaultMessages;
import steward.bot.command.Program;
import steward.contest.Contest;
import steward.contest.Failure;

/** Advice for a beginner about a failure. */
public final class Advice {

    static final String DEBUGGING = "Print nothing but answers on the standard output, and debugging on stderr "
        + "(Python: print(..., file=sys.stderr); Java: System.err; C++: std::cerr; JS: console.error)";
    private static final String FLUSH = "Flush after every answer (Python: print(..., flush=True); Java: "
        + "System.out.flush(); C++: std::endl), and read no more lines than are sent";
    private static final Map<String, String> COMPILE = Map.of(".java", "javac", ".cpp", "g++ -O2 -o bot", ".cc",
        "g++ -O2 -o bot", ".c", "gcc -O2 -o bot", ".rs", "rustc -O", ".cs", "dotnet build", ".go", "go build");

    private Advice() { }

    /** Explanation of a failure and of what to do, in a few sentences. */
    static String of(Failure failure, Contest contest) {
        Program bot = contest.entrants().get(0).program();
        return failure.reason() + ". " + uncompiled(bot.words()).or(() -> windowsScript(bot))
            .orElseGet(() -> about(failure));
    }

    static String about(Failure failure) {
        String reason = failure.reason();
        if (FaultMessages.isExit(reason, 0)) {
            return "It ended by itself: after an answer it has to read the next turn, until its input ends";
        }
        if (FaultMessages.isExit(reason)) {
            return failure.stderr().isEmpty() ? "It ended before it answered, and wrote nothing to its stderr"
                : "It ended with an error; its stderr says why: " + failure.error();
        }
        if (FaultMessages.isTime(reason)) {
            return late(failure);
        }
        return reason.contains("received: ") ? "That is no answer. " + DEBUGGING : "The protocol says what is expected";
    }

    private static String late(Failure failure) {
        String reason = failure.reason();
        if (reason.contains(" lines came")) {
            return "It wrote fewer lines than an answer has, or did not flush the last one. " + FLUSH;
        }
        if (reason.contains("without a line end")) {
            return "An answer ends with a line end. " + FLUSH;
        }
        if (failure.time() != null && (failure.time().overCpu()
            || failure.time().computed() > failure.time().taken() / 2)) {
            return "It computed all the time: " + (failure.turn() == 1 ? "let it start faster, or " : "")
                + "let it stop its search by the clock, with room to the limit";
        }
        if (failure.time() != null && failure.time().starved()) {
            return "Other programs used the processors: try again on a machine that is idle";
        }
        return "Nothing came, and it was not computing: the answer is still in a buffer, or it waits for more input. "
            + FLUSH;
    }

    /** A source file in place of a program, or beside a program that is not there. */
    private static Optional<String> uncompiled(List<String> words) {
        for (String word : words.subList(0, Math.min(1, words.size()))) {
            for (Map.Entry<String, String> each : COMPILE.entrySet()) {
                if (word.endsWith(each.getKey())) {
                    return Optional.of("That is a source file: compile it (" + each.getValue() + " " + word
                        + ") and name the program");
                }
            }
        }
        return Optional.empty();
    }

    /** Advice about a program that is not there, where its source is; empty for anything else. */
    public static Optional<String> missing(List<String> words, Path folder) {
        for (String word : words) {
            for (Map.Entry<String, String> each : COMPILE.entrySet()) {
                Path source = path(word + each.getKey(), folder);
                if (source != null && Files.isRegularFile(source) && !Files.exists(path(word, folder))) {
                    return Optional.of("There is " + source + ": compile it first (" + each.getValue() + " " + source
                        + ")");
                }
            }
        }
        return uncompiled(words);
    }

    private static Path path(String word, Path folder) {
        try {
            return folder.resolve(word);
        } catch (InvalidPathException none) {
            return null;
        }
    }

    private static Optional<String> windowsScript(Program bot) {
        for (String word : bot.words()) {
            Path file = path(word, bot.folder());
            if (file != null && Files.isRegularFile(file)) {
                try (InputStream in = Files.newInputStream(file)) {
                    String head = new String(in.readNBytes(200), StandardCharsets.ISO_8859_1);
                    int end = head.indexOf('\n');
                    if (head.startsWith("#!") && end > 0 && head.charAt(end - 1) == '\r') {
                        return Optional.of("The first line of " + file + " ends with a Windows line end, which becomes "
                            + "part of the interpreter's name: save it with Unix line ends (dos2unix " + file + ")");
                    }
                } catch (IOException unreadable) {
                    continue;
                }
            }
        }
        return Optional.empty();
    }
}
