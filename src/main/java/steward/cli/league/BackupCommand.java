package steward.cli.league;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;
import steward.cli.league.view.LeagueArgument;
import steward.cli.league.view.LeagueOpening;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.FailedException;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.text.TextFormat;

/** {@code steward league backup}: copies a league's database of games. */
@Command(name = "backup", description = "Copies the games of a league into a file, also while it is played.",
    footer = {
        "", "Copying league.db by other means is not safe while the league is played. The",
        "copy is a league.db. To restore it, end all runs, put it in the place of the",
        "old one, and remove league.db-wal and league.db-shm.",
        "", "Example:",
        "  steward league backup night night-copy.db"})
final class BackupCommand extends ProgramCommand {

    @Mixin
    private final LeagueArgument league = new LeagueArgument();

    @Parameters(index = "1", paramLabel = "FILE", description = "Where the copy goes; must not exist.")
    private String file;

    @Override
    public Integer call() {
        Path copy = OutputFiles.path(file);
        if (Files.exists(copy)) {
            throw new InputException(copy + ": exists already, and is kept; expected the name of a new file");
        }
        Path folder = copy.toAbsolutePath().getParent();
        if (folder != null && !Files.isDirectory(folder)) {
            throw new InputException(copy + ": cannot be written: there is no folder " + folder);
        }
        Path part = copy.resolveSibling(copy.getFileName() + ".part");
        try (LeagueOpening.Opened opened = LeagueOpening.read(league.open())) {
            begin(part, copy);
            long games = opened.games().results().games();
            opened.store().backup(part.toAbsolutePath());
            Files.move(part, copy, StandardCopyOption.ATOMIC_MOVE);
            streams.out().println("Copied: " + copy + ", " + TextFormat.count(games, "game") + " of "
                + opened.season().sceneName() + ", " + Sizes.text(Files.size(copy)));
        } catch (IOException problem) {
            throw new FailedException(copy + ": cannot be written: " + OutputFiles.reason(copy, problem));
        } catch (InputException problem) {
            part.toFile().delete();
            throw problem;
        }
        return ExitStatus.DONE;
    }

    /** An empty file: whether it can be written is known before the library is asked, which would not say what. */
    private static void begin(Path part, Path copy) {
        try {
            Files.deleteIfExists(part);
            Files.createFile(part);
        } catch (IOException problem) {
            throw new InputException(copy + ": cannot be written: " + OutputFiles.reason(copy, problem));
        }
    }
}
