package steward.cli.tournament;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import steward.cli.Cli;
import steward.cli.ShellBots;

/** Programs of one pod that are handed in for a short duel, and the tournament of their folder. */
final class ProgramFolder {

    private static final String BOT = "read -r setup\nwhile read -r turn; do\n%s"
        + "echo '{\"pods\":[{\"x\":1,\"y\":%s,\"thrust\":100}]}'\ndone\n";

    private final Path folder;

    /** Writes the duel. @param turns that a game has */
    ProgramFolder(Path folder, int turns) throws IOException {
        this.folder = folder;
        ShellBots.shortDuel(folder, turns);
    }

    /** Hands in a program that drives to a place. @param more shell before each answer */
    void add(String name, String y, String more) throws IOException {
        Path own = Files.createDirectories(folder.resolve("in").resolve(name));
        Files.writeString(own.resolve("run"), "sh main.sh");
        Files.writeString(own.resolve("main.sh"), BOT.formatted(more, y));
    }

    /** Words of a call of the tournament, whose pages are in the folder {@code out}. */
    List<String> words(String... more) {
        return Stream.concat(Stream.of("tournament", folder.resolve("in").toString(), "--scene",
            folder.resolve("short.json").toString(), "--protocol", "json", "--page", folder.resolve("out").toString()),
            Stream.of(more)).toList();
    }

    Cli call(String... more) {
        return Cli.run(words(more));
    }
}
