package steward.contest;

import java.util.HashMap;
import java.util.Map;
import steward.text.TextFormat;

/**
 * Counts, for each bot, of games in a row that it failed in; after enough of them, further games tell nothing about its
 * strength. Not thread-safe.
 */
public final class FailureStreaks {

    /** Number of games in a row that end a test or a search. */
    public static final int MOST = 10;

    private final Map<String, Integer> games = new HashMap<>();
    private String failing;

    /** Adds the games of a seed, in the order of seeds. */
    public void add(Contest contest, PairedPlay.Seed seed) {
        for (int rotation = 0; rotation < seed.games().length; rotation++) {
            boolean[] failed = seed.games()[rotation].failed();
            for (int player = 0; player < failed.length && failing == null; player++) {
                String name = contest.entrants().get(contest.entrantOf(player, rotation)).name();
                int row = failed[player] ? games.getOrDefault(name, 0) + 1 : 0;
                games.put(name, row);
                failing = row == MOST ? name : null;
            }
        }
    }

    /** Says why something ends. */
    public String ending(String what) {
        return what + " ends: " + TextFormat.plain(failing) + " failed in " + MOST + " games in a row; "
            + "--keep-going goes on all the same";
    }

    /** The first bot that failed in {@value #MOST} games in a row, or {@code null}. */
    public String failing() {
        return failing;
    }
}
