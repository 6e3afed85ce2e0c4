package steward.cli.setup;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;
import steward.bot.command.CommandLine;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Streams;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.text.NearestName;

/** {@code steward new}: writes a bot to start from. */
@Command(name = "new", description = "Writes a commented bot to start from, which races at once, into a new or empty "
    + "folder, and prints how to run it.",
    footer = {"", "Examples:", "  steward new python mybot", "  steward new cpp mybot",
        "", "Exit status: 0 written; 2 the folder is not empty, or cannot be written into."})
public final class NewCommand implements Callable<Integer> {

    private final Streams streams;

    @Parameters(index = "0", paramLabel = "LANGUAGE", completionCandidates = Languages.class,
        description = "One of ${COMPLETION-CANDIDATES}.")
    private String language;

    @Parameters(index = "1", paramLabel = "DIR", description = "The folder; made if it is not there.")
    private String folder;

    public NewCommand(Streams streams) {
        this.streams = streams;
    }

    /** The words for the languages. */
    static final class Languages implements Iterable<String> {

        static final List<String> ALL = Arrays.stream(Starter.values()).map(Starter::word).toList();

        @Override
        public Iterator<String> iterator() {
            return ALL.iterator();
        }
    }

    @Override
    public Integer call() {
        Starter starter = Arrays.stream(Starter.values()).filter(each -> each.word().equals(language)).findFirst()
            .orElseThrow(() -> new InputException("LANGUAGE: found '" + language + "', expected one of "
                + String.join(", ", Languages.ALL) + NearestName.of(language, Languages.ALL)
                .map(near -> "; did you mean '" + near + "'?").orElse("")));
        Path path = OutputFiles.path(folder);
        refuseUnlessEmpty(path);
        try {
            Files.createDirectories(path);
            for (String file : starter.files()) {
                Files.write(path.resolve(file), starter.read(file));
            }
        } catch (IOException problem) {
            throw new InputException(path + ": cannot be written into: " + OutputFiles.reason(path, problem));
        }
        streams.out().println("Written: " + path.resolve(starter.files().get(0)) + ". To race it:");
        streams.out().println("  cd " + CommandLine.quote(List.of(folder)));
        starter.compile().forEach(command -> streams.out().println("  " + command));
        streams.out().println("  steward match --bot " + CommandLine.quote(List.of("me=" + starter.bot()))
            + " --bot builtin:racer");
        return ExitStatus.DONE;
    }

    /** Refuses to overwrite anything. */
    private static void refuseUnlessEmpty(Path path) {
        if (!Files.exists(path)) {
            return;
        }
        if (!Files.isDirectory(path)) {
            throw new InputException(path + ": found a file, expected a new or empty folder");
        }
        try (Stream<Path> files = Files.list(path)) {
            if (files.findAny().isPresent()) {
                throw new InputException(path + ": found a folder with files in it, expected a new or empty one");
            }
        } catch (IOException problem) {
            throw new InputException(path + ": cannot be read: " + problem.getMessage());
        }
    }
}
