package steward.contest.loss;

import java.util.ArrayList;
import java.util.List;
import steward.game.Game;

/** Log of who led in a game: for each player, the last turn after which no other was ahead of it. Not thread-safe. */
public final class LeadLog {

    /** Stands for a game of which it is not known. */
    public static final int UNKNOWN = -1;

    private final int[] last;

    /** Nothing is played yet, and nobody is behind. */
    public LeadLog(int players) {
        last = new int[players];
    }

    /** Notes the standing after a turn. */
    public void note(Game game) {
        int[] ranks = game.ranks();
        for (int player = 0; player < last.length; player++) {
            last[player] = ranks[player] == 0 ? game.turn() : last[player];
        }
    }

    /** Returns by player the turn, counted from 1, from which on another was ahead of it to the end. */
    public List<Integer> behindFrom() {
        List<Integer> turns = new ArrayList<>();
        for (int turn : last) {
            turns.add(turn + 1);
        }
        return turns;
    }
}
