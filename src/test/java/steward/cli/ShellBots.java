package steward.cli;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import steward.bot.command.CommandLine;

/** Bot programs for tests: shell scripts, which start at once. They play with one pod. */
public final class ShellBots {

    static final String ANSWER = """
        #!/bin/sh
        # arguments: x y, the turn from which on it answers nonsense (0: never), a file for what it was sent
        x=$1 y=$2 turns=0
        while IFS= read -r line; do
          [ -z "$4" ] || printf '%s\\n' "$line" >>"$4"
          case $line in *'"type":"turn"'*) ;; *) continue ;; esac
          turns=$((turns + 1))
          if [ $turns = "$3" ]; then echo nonsense; continue; fi
          echo "{\\"pods\\":[{\\"x\\":$x,\\"y\\":$y,\\"thrust\\":100}]}"
        done
        """;

    /** A place: on the way to it from the start of the scene {@code duel} no checkpoint is passed. */
    public static final String NOWHERE = "5000 99000";
    /** The first checkpoint of the scene {@code duel} to be passed. */
    public static final String CHECKPOINT = "10500 3500";

    private final Path script;

    /** @param folder the scripts go there */
    public ShellBots(Path folder) {
        assumeRunnable();
        script = folder.resolve("pod.sh");
        try {
            Files.writeString(script, ANSWER);
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }

    /** A bot that drives to a place and stays there. */
    public String driver(String name, String place) {
        return name + "=sh " + CommandLine.quote(List.of(script.toString())) + " " + place + " 0";
    }

    /**
     * As {@link #driver}, but writes down what it is sent.
     *
     * @param nonsense the turn in which it fails, or 0
     */
    public String witness(String name, String place, int nonsense, Path file) {
        return name + "=sh " + CommandLine.quote(List.of(script.toString())) + " " + place + " " + nonsense + " "
            + CommandLine.quote(List.of(file.toString()));
    }

    /** Writes {@code short.json}, a duel of 8 turns in which nobody is late. */
    public static void shortDuel(Path folder) throws IOException {
        shortDuel(folder, 8);
    }

    /** As {@link #shortDuel(Path)}, of other turns. */
    public static void shortDuel(Path folder, int turns) throws IOException {
        assumeRunnable();
        Files.writeString(folder.resolve("short.json"), shortDuel(turns));
    }

    static String shortDuel(int turns) throws IOException {
        return Files.readString(Path.of("config/scenes/duel.json"))
            .replace("\"maximumTurns\": 200", "\"maximumTurns\": " + turns)
            .replace("\"answerMs\": 75", "\"answerMs\": 30000")
            .replace("\"firstAnswerMs\": 1000", "\"firstAnswerMs\": 60000");
    }

    /** Lets a duel draw its places from the seed, so that no two games are repeats. */
    public static void drawn(Path scene) throws IOException {
        Files.writeString(scene, drawn(Files.readString(scene)));
    }

    static String drawn(String duel) {
        return duel.replace("\"turnsWithoutCheckpoint\"", "\"jitter\": 30, \"turnsWithoutCheckpoint\"");
    }

    /** Skips a test where the scripts cannot run. */
    static void assumeRunnable() {
        assumeTrue(runnable(), "skipped: there is no /bin/sh");
    }

    /** True if the scripts can run here. */
    public static boolean runnable() {
        return Files.isExecutable(Path.of("/bin/sh"));
    }
}
