package steward.league.play;

import java.util.List;
import steward.league.LeagueSettings;
import steward.league.Schedule;
import steward.league.StoredGame;
import steward.league.play.Roster.Member;

/** Other machines that play games of a run. All methods are called by any thread. */
public interface Elsewhere {

    /**
     * Waits for a place for one more game, which then is taken.
     *
     * @return whether there is one; {@code false} after so many milliseconds
     */
    boolean takePlace(long waitMs) throws InterruptedException;

    /** Gives a place back. */
    void leavePlace();

    /**
     * Plays a game there.
     *
     * @param members by seat
     * @return the attempts, of which the last one counts; {@code null} if it has to be played once more, anywhere
     */
    List<StoredGame> play(Schedule.Task task, LeagueSettings settings, List<Member> members)
        throws InterruptedException;

    /** Whether games are to be believed that were played on this machine; asked just before they are stored. */
    boolean isTrusted(String machine);
}
