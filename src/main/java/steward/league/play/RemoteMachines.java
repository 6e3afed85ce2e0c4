package steward.league.play;

import java.util.List;
import steward.league.LeagueSettings;
import steward.league.Schedule;
import steward.league.StoredGame;
import steward.league.play.Roster.Member;

/** Interface to other machines that play games of a run. Any thread may call its methods. */
public interface RemoteMachines {

    /**
     * A game that is to be played.
     *
     * @param task     what the schedule has decided
     * @param settings of the league as it began
     * @param members  by seat
     * @param first    number of its first attempt; not 1 if earlier ones were forgiven
     */
    record Game(Schedule.Task task, LeagueSettings settings, List<Member> members, int first) { }

    /**
     * Waits for a place for more games, which then is taken.
     *
     * @return how many games are to go together there; 0 if there is no place after so many milliseconds
     */
    int takePlace(long waitMs) throws InterruptedException;

    void leavePlace();

    /**
     * Plays games there that go together.
     *
     * @return of each game the attempts, of which the last one counts; {@code null} for one that has to be played once
     *         more, anywhere
     */
    List<List<StoredGame>> play(List<Game> games) throws InterruptedException;

    /** Says that a thread has nothing to play before games under way end: those that take long may be given back. */
    void hurry();

    /**
     * True if there may be one machine where all of these bots run; asked before games are taken that go together.
     *
     * @param members of all of these games
     */
    boolean canPlay(List<Member> members);

    /** True if no machine is there at the moment. */
    boolean isAway();

    /**
     * Returns why none of the machines that are there can play with these bots, as each of them has said; {@code null}
     * if one may.
     */
    String obstacle(List<Member> members);

    /** True if games are to be believed that were played on this machine; asked just before they are stored. */
    boolean isTrusted(String machine);
}
