package steward.lab.cli.shared;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Option;
import steward.cli.options.CallCheck;
import steward.files.InputException;
import steward.files.OutputFiles;

/** Options of a measuring command for the folder of its tables, and for replacing older ones. */
public final class TableFolder {

    private final CallCheck check = CallCheck.brief();

    @Option(names = "--overwrite", description = "Replaces the files if they exist.")
    private boolean overwrite;

    /** Starts files in a folder. */
    @FunctionalInterface
    public interface Start<T> {

        /** @throws IOException if a file cannot be written */
        T start() throws IOException;
    }

    /** True if older files are replaced. */
    public boolean overwrite() {
        return overwrite;
    }

    /** @param out the folder as it was called for, or {@code null} */
    public void check(String out) {
        check.that(!overwrite || out != null, "--overwrite: expected --out with it");
    }

    /**
     * Makes the folder, unless it is there, and starts the files.
     *
     * @param names of all files that the command will have written in the end; older ones are deleted now
     * @throws InputException if one exists and is to be kept, or the folder cannot be written into
     */
    public <T> T start(Path folder, List<String> names, Start<T> files) {
        OutputFiles.prepareFolder(folder);
        for (String name : names) {
            OutputFiles.check(folder.resolve(name), overwrite);
        }
        try {
            for (String name : names) {
                Files.deleteIfExists(folder.resolve(name));
            }
            return files.start();
        } catch (IOException problem) {
            throw new InputException(folder + ": cannot be written into: " + OutputFiles.reason(folder, problem));
        }
    }
}
