package steward.league;

import java.util.List;

/** Identity of a game within a league: a hash of what is played and by whom, equal wherever the game is played. */
public final class GameName {

    private GameName() { }

    /**
     * @param season     its key has the scene, the limits, the time mode and the version of the rules
     * @param identities of the bots' versions, in the order of seats
     * @param attempt    counted from 1: a game may be played again
     * @return 16 bytes
     */
    public static byte[] of(Season season, long seed, List<String> identities, int attempt) {
        return new TextHash().add(season.key()).add(Long.toString(seed)).addAll(identities)
            .add(Integer.toString(attempt)).bytes();
    }
}
