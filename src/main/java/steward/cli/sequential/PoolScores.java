package steward.cli.sequential;

import java.util.ArrayList;
import java.util.List;
import steward.contest.Contest;
import steward.contest.PairedPlay;
import steward.contest.repeat.Repeats;
import steward.league.sequential.Gsprt;
import steward.league.sequential.ScoreCounts;
import steward.numerics.SplitMix64;

/**
 * Scores of two bots against the same opponents on the same seeds. The new bot and the base have played a seed against
 * an opponent from each seat. The value of a seat is the difference of their points there, -1..1; an observation is the
 * mean d of all seats of a seed, as the score (1 + d) / 2. The seed draws the opponent, so that observations are
 * independent and of one distribution, whatever the order and number of opponents. Games that repeat those of an
 * earlier seed count too: without them an opponent that plays alike on all seeds would weigh less than the others. Not
 * thread-safe.
 */
final class PoolScores {

    /** Keeps the draw of an opponent apart from those of maps, which games begin with the seed itself. */
    private static final long STREAM = 0x706f6f6cL;

    private final Contest contest;
    private final ScoreCounts scores;
    private final boolean random;
    private final List<Opponent> opponents = new ArrayList<>();
    private long without;
    private long allFailed;
    private long repeats;
    private int repeatsInARow;
    private int idleInARow;

    /** Sums against one opponent, or a group of them. */
    static final class Opponent {
        private final String name;
        private final Repeats seen = new Repeats();
        private long seeds;
        private double ofNew;
        private double ofBase;

        private Opponent(String name) {
            this.name = name;
        }

        String name() {
            return name;
        }

        long seeds() {
            return seeds;
        }

        /** Mean points of the new bot. */
        double ofNew() {
            return ofNew / seeds;
        }

        /** Mean points of the base. */
        double ofBase() {
            return ofBase / seeds;
        }
    }

    /**
     * None yet.
     *
     * @param contest of any game of the test: who is tested is its first bot
     * @param names   of the opponents
     * @param random  whether equal games count
     */
    PoolScores(Contest contest, List<String> names, boolean random) {
        this.contest = contest;
        this.random = random;
        scores = new ScoreCounts(contest.players());
        names.forEach(name -> opponents.add(new Opponent(name)));
    }

    /** Returns the opponent of a seed, each as likely. @param opponents their number */
    static int opponent(long seed, int opponents) {
        return new SplitMix64(seed ^ STREAM).nextInt(opponents);
    }

    /** Adds the games of a seed: those of the new bot from all seats, then those of the base. */
    void add(int opponent, PairedPlay.Seed seed) {
        Opponent other = opponents.get(opponent);
        if (!seed.isWhole()) {
            without += seed.allFailed() ? 0 : 1;
            allFailed += seed.allFailed() ? 1 : 0;
            idleInARow++;
        } else {
            boolean isRepeat = !random && seed.isRepeat(other.seen);
            repeats += isRepeat ? 1 : 0;
            repeatsInARow = isRepeat ? repeatsInARow + 1 : 0;
            double ofNew = points(seed, 0);
            double ofBase = points(seed, contest.players());
            other.seeds++;
            other.ofNew += ofNew;
            other.ofBase += ofBase;
            scores.add((1 + ofNew - ofBase) / 2);
            idleInARow = 0;
        }
    }

    private double points(PairedPlay.Seed seed, int first) {
        return seed.points(contest, 0, first) / contest.players();
    }

    ScoreCounts scores() {
        return scores;
    }

    List<Opponent> opponents() {
        return opponents;
    }

    /** Seeds that the test does not use, and those whose games are repeats. */
    SprtText.Unused unused() {
        return new SprtText.Unused(without, allFailed, repeats);
    }

    /** Returns how a test stands: it is open while fewer seeds than it needs have games that are no repeats. */
    Gsprt.State state(Gsprt test) {
        return scores.observations() - repeats < Gsprt.LEAST ? Gsprt.State.OPEN : test.state(scores);
    }

    int repeatsInARow() {
        return repeatsInARow;
    }

    /** Seeds in a row that tell nothing. */
    int idleInARow() {
        return idleInARow;
    }

    /** Number of games on a seed. */
    int gamesOfSeed() {
        return 2 * contest.players();
    }

    /** Number of seeds that were played. */
    long played() {
        return scores.observations() + without + allFailed;
    }

    /** Mean points of the base against all that it has met. */
    double ofBase() {
        return opponents.stream().mapToDouble(each -> each.ofBase).sum() / scores.observations();
    }

    /** Mean points of the new bot. */
    double ofNew() {
        return opponents.stream().mapToDouble(each -> each.ofNew).sum() / scores.observations();
    }
}
