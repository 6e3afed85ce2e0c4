package steward.machines.serve;

import java.util.List;
import steward.league.StoredGame;
import steward.league.play.Elsewhere;
import steward.league.play.Roster.Member;

/** Games of workers, for those who add something to them. */
public abstract class ForwardedGames implements Elsewhere {

    private final RemoteGames games;

    /** @param games which all is handed on to */
    protected ForwardedGames(RemoteGames games) {
        this.games = games;
    }

    protected final RemoteGames games() {
        return games;
    }

    @Override
    public final int takePlace(long waitMs) throws InterruptedException {
        return games.takePlace(waitMs);
    }

    @Override
    public final void leavePlace() {
        games.leavePlace();
    }

    @Override
    public List<List<StoredGame>> play(List<Game> together) throws InterruptedException {
        return games.play(together);
    }

    @Override
    public final void hurry() {
        games.hurry();
    }

    @Override
    public final boolean canPlay(List<Member> members) {
        return games.canPlay(members);
    }

    @Override
    public final boolean isAway() {
        return games.isAway();
    }

    @Override
    public final String obstacle(List<Member> members) {
        return games.obstacle(members);
    }

    @Override
    public final boolean isTrusted(String machine) {
        return games.isTrusted(machine);
    }
}
