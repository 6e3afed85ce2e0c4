package steward.cli.league;

import java.util.List;
import java.util.function.Consumer;
import steward.contest.Contest;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Season;
import steward.league.play.Elsewhere;
import steward.league.play.LeagueRun;

/** The options of a run that let other machines play, too. */
public interface Serving {

    /** Other machines, while a run lasts. */
    interface Service extends Elsewhere, AutoCloseable {

        /**
         * Says for which run they play, and what is to be done when games that counted do no more.
         *
         * @param changed is called then, by any thread
         */
        void follow(LeagueRun run, Runnable changed);

        /** What is to be seen of them, a line each. */
        List<String> lines();

        @Override
        void close();
    }

    /**
     * Begins to serve, if the call says so.
     *
     * @param teller is told what happens, by any thread
     * @return {@code null} if it does not
     */
    Service start(LeagueFolder folder, Season season, Contest contest, LeagueSettings settings,
                  Consumer<String> teller);
}
