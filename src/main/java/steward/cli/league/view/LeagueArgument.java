package steward.cli.league.view;

import java.nio.file.Path;
import picocli.CommandLine.Parameters;
import steward.cli.streams.Streams;
import steward.files.OutputFiles;
import steward.league.LeagueFolder;

/** Parameter that names a league's folder. */
public final class LeagueArgument {

    @Parameters(index = "0", paramLabel = "DIR", description = "The folder of the league.")
    private String folder;

    /** The folder as it was typed; it need not be there. */
    public Path path() {
        return OutputFiles.path(folder);
    }

    public LeagueFolder open() {
        return LeagueFolder.open(path());
    }

    /** The league in it, which is about to be written to; warns if its folder was open to others. */
    public LeagueFolder openToWrite(Streams streams) {
        return LeagueFolder.openToWrite(path(), streams::warn);
    }
}
