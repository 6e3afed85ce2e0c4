package steward.cli.league.view;

import java.nio.file.Path;
import picocli.CommandLine.Parameters;
import steward.files.OutputFiles;
import steward.league.LeagueFolder;

/** The parameter that names a league. */
public final class LeagueArgument {

    @Parameters(index = "0", paramLabel = "DIR", description = "The folder of the league.")
    private String folder;

    /** The folder as it was typed; it need not be there. */
    public Path path() {
        return OutputFiles.path(folder);
    }

    /** The league in it. */
    public LeagueFolder open() {
        return LeagueFolder.open(path());
    }
}
