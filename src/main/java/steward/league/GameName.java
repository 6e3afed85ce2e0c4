package steward.league;

import java.util.List;

/** The name of a game: what is played by whom, so that the same game has the same name wherever it is played. */
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
