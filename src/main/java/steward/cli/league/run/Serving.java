package steward.cli.league.run;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import steward.contest.Contest;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.page.WorkerRow;
import steward.league.play.LeagueRun;
import steward.league.play.RemoteMachines;
import steward.machines.check.WorkerBook;

/** Options of a run that let other machines play too. */
public interface Serving {

    /** Other machines, while a run lasts. */
    interface Service extends AutoCloseable {

        /** Returns what plays the games. */
        RemoteMachines games();

        /**
         * Says for which run they play, and what is to be done when games that counted do no more.
         *
         * @param book    who played which games before this run, read anew at each call
         * @param changed is called then, by any thread
         */
        void follow(LeagueRun run, Supplier<WorkerBook> book, Runnable changed) throws InterruptedException;

        /** A game that is handed over to be stored, by any thread. */
        void stored(StoredGame game);

        /** Returns how many games wait for a worker. */
        int waiting();

        List<WorkerRow> workers();

        @Override
        void close();
    }

    /** True if the call says that other machines may play. */
    boolean isServed();

    /**
     * Begins to serve, if the call says so.
     *
     * @param teller is told what happens, by any thread
     * @return {@code null} if it does not
     */
    Service start(LeagueFolder folder, Season season, Contest contest, LeagueSettings settings,
                  Consumer<String> teller);
}
