package steward.cli.league.run;

import java.util.function.Consumer;
import picocli.CommandLine.Command;
import steward.contest.Contest;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Season;

/** Placeholder for {@link Serving} if no other machines play. */
@Command
public final class NoServing implements Serving {

    @Override
    public boolean isServed() {
        return false;
    }

    @Override
    public Service start(LeagueFolder folder, Season season, Contest contest, LeagueSettings settings,
                         Consumer<String> teller) {
        return null;
    }
}
