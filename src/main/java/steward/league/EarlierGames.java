package steward.league;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;

/**
 * The games that earlier runs have played, by decision. A game takes eight bytes here, so that a league of a million
 * is resumed at once. Filled first, in any order; then asked for one decision after the other.
 *
 * <p>Not thread-safe.
 */
public final class EarlierGames {

    private final Map<List<Integer>, Integer> numbers = new HashMap<>();
    private final List<int[]> lineups = new ArrayList<>();
    /** The decision in the upper half, the number of the lineup in the lower one. */
    private long[] games = new long[16];
    private int count;
    private boolean sorted;
    /** The first game that has not been taken. */
    private int place;
    /** By the first lineup: how many decisions were taken as a whole. */
    private int[] whole = new int[16];

    /** The number of a lineup, for {@link #add}: it is 0 for the first one, then 1, and so on. */
    public int lineup(int... versions) {
        return numbers.computeIfAbsent(Arrays.stream(versions).boxed().toList(), key -> {
            lineups.add(versions.clone());
            if (lineups.size() > whole.length) {
                whole = Arrays.copyOf(whole, 2 * whole.length);
            }
            return lineups.size() - 1;
        });
    }

    /**
     * Adds a game.
     *
     * @param decision from 0
     * @param lineup   a number that {@link #lineup} has given
     */
    public void add(int decision, int lineup) {
        if (count == games.length) {
            games = Arrays.copyOf(games, 2 * count);
        }
        games[count++] = (long) decision << Integer.SIZE | lineup;
        sorted = false;
    }

    private void sort() {
        if (!sorted) {
            Arrays.sort(games, place, count);
            sorted = true;
        }
    }

    /** The last decision that has a game, or -1. */
    int last() {
        sort();
        return count == 0 ? -1 : decision(count - 1);
    }

    /** Tells of every game that was not taken, by decision. */
    void each(BiConsumer<Integer, int[]> decisionAndLineup) {
        sort();
        for (int game = place; game < count; game++) {
            decisionAndLineup.accept(decision(game), lineups.get((int) games[game]));
        }
    }

    /** The first decision that has no game. */
    public int firstOpen() {
        sort();
        int open = 0;
        for (int game = 0; game < count && decision(game) <= open; game++) {
            open = decision(game) + 1;
        }
        return open;
    }

    /** True if a decision, not less than in any call before, has games that were not taken. */
    boolean has(int decision) {
        moveTo(decision);
        return place < count && decision(place) == decision;
    }

    private int decision(int game) {
        return (int) (games[game] >>> Integer.SIZE);
    }

    /**
     * Takes a decision if it has just so many games, and counts it for {@link #tellWhole}.
     *
     * @param decision more than in the call before
     * @return whether it has
     */
    boolean takeWhole(int decision, int size) {
        moveTo(decision);
        int end = place + size;
        if (end > count || decision(place) != decision || decision(end - 1) != decision
            || end < count && decision(end) == decision) {
            return false;
        }
        whole[(int) games[place]]++;
        place = end;
        return true;
    }

    /** Tells how often which lineup was the first one of a decision that was taken as a whole, and forgets that. */
    void tellWhole(BiConsumer<Integer, int[]> timesAndLineup) {
        for (int lineup = 0; lineup < lineups.size(); lineup++) {
            if (whole[lineup] > 0) {
                timesAndLineup.accept(whole[lineup], lineups.get(lineup));
                whole[lineup] = 0;
            }
        }
    }

    /**
     * The lineups that a decision has had.
     *
     * @param decision more than in the call before, or one that was not taken as a whole
     */
    List<int[]> take(int decision) {
        moveTo(decision);
        List<int[]> taken = new ArrayList<>();
        while (place < count && decision(place) == decision) {
            taken.add(lineups.get((int) games[place++]));
        }
        return taken;
    }

    private void moveTo(int decision) {
        sort();
        while (place < count && decision(place) < decision) {
            place++;
        }
    }
}
