package steward.contest;

import java.io.UncheckedIOException;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.Objects;
import java.util.TreeMap;
import java.util.function.Consumer;
import steward.Internal;
import steward.match.MatchResult;

/**
 * The same bots on one seed after the other, each seed from all seats, until the taker of the results has enough. What
 * it is handed comes in the order of seeds, however many threads play: when it says that it has enough, nothing that
 * is played besides counts.
 */
@Internal
public final class PairedPlay {

    private final Contest contest;
    private final long first;
    private final Hiccups hiccups;
    private final Known known;
    private final Consumer<Series.Played> keeper;
    private final Taker taker;

    /** Guarded by this, as is all below: games that are to be begun. */
    private final Deque<Game> waiting = new ArrayDeque<>();
    /** Seeds that are not over, by number. */
    private final TreeMap<Integer, Seed> open = new TreeMap<>();
    /** How many of their games are not over. */
    private final TreeMap<Integer, Integer> missing = new TreeMap<>();
    private int begun;
    private int number;
    private boolean over;

    /** A game that has been played before. */
    public interface Known {

        /** What it came to; {@code null} if it is not known. */
        Past game(long seed, int rotation);
    }

    /**
     * A game that is over.
     *
     * @param transcript see {@link GameFacts}
     * @param values     by player, more is better
     */
    public record Past(long transcript, double... values) {
    }

    /** Takes the results of seeds, in their order. */
    public interface Taker {

        /** Returns whether more are wanted. */
        boolean take(Seed seed);
    }

    /**
     * All games of a seed.
     *
     * @param seed  it
     * @param games by rotation; {@code null} for a game without a result
     */
    public record Seed(long seed, Past... games) {

        /** Whether every game has a result. */
        public boolean isWhole() {
            return Arrays.stream(games).allMatch(Objects::nonNull);
        }

        /** Adds the games. @return true if each had been played before, see {@link Repeats} */
        public boolean isRepeat(Repeats repeats) {
            boolean all = true;
            for (int rotation = 0; rotation < games.length; rotation++) {
                all &= repeats.isRepeat(rotation, games[rotation].transcript());
            }
            return all;
        }

        /**
         * Points of one bot less those of another, averaged over the games, -1..1. A bot's points in a game are the
         * share of the others that it is before, half for those that it is level with.
         */
        public double difference(Contest contest, int one, int other) {
            int bots = contest.entrants().size();
            double sum = 0;
            if (contest.isAlone()) {
                return Math.signum(games[one].values()[0] - games[other].values()[0]);
            }
            for (int rotation = 0; rotation < games.length; rotation++) {
                for (int player = 0; player < bots; player++) {
                    int bot = contest.entrantOf(player, rotation);
                    sum += bot == one ? points(games[rotation].values(), player)
                        : bot == other ? -points(games[rotation].values(), player) : 0;
                }
            }
            return sum / games.length;
        }

        private static double points(double[] values, int player) {
            double points = 0;
            for (int other = 0; other < values.length; other++) {
                points += other == player ? 0 : values[player] > values[other] ? 1
                    : values[player] == values[other] ? 0.5 : 0;
            }
            return points / (values.length - 1);
        }
    }

    private record Game(int number, long seed, int rotation) {
    }

    /**
     * @param first  the first seed
     * @param known  games that need not be played
     * @param keeper is told of every game that is over, by any thread; what it throws ends everything
     */
    public PairedPlay(Contest contest, long first, Hiccups hiccups, Known known, Consumer<Series.Played> keeper,
                      Taker taker) {
        this.contest = contest;
        this.first = first;
        this.hiccups = hiccups;
        this.known = known;
        this.keeper = keeper;
        this.taker = taker;
    }

    /** Plays until the taker has enough, or somebody breaks it off. */
    public void play(int threads) throws InterruptedException {
        try {
            WorkerThreads.run("seeds", threads, thread -> () -> {
                for (Game game = next(); game != null; game = next()) {
                    play(game);
                }
                return null;
            });
        } finally {
            breakOff();
        }
    }

    /** Ends it: games that are under way do not count. */
    public synchronized void breakOff() {
        over = true;
    }

    private synchronized Game next() {
        while (!over && waiting.isEmpty()) {
            long seed = first + begun;
            int games = contest.isAlone() ? contest.entrants().size() : contest.players();
            Past[] past = new Past[games];
            open.put(begun, new Seed(seed, past));
            missing.put(begun, 0);
            for (int rotation = 0; rotation < games; rotation++) {
                past[rotation] = known.game(seed, rotation);
                if (past[rotation] == null) {
                    waiting.add(new Game(begun, seed, rotation));
                    missing.merge(begun, 1, Integer::sum);
                }
            }
            begun++;
            deliver();
        }
        return over ? null : waiting.remove();
    }

    private void deliver() {
        while (!over && !open.isEmpty() && missing.get(open.firstKey()) == 0) {
            missing.remove(open.firstKey());
            over = !taker.take(open.pollFirstEntry().getValue());
        }
    }

    private void play(Game game) throws InterruptedException {
        Series.Played before = null;
        Series.Played played = null;
        for (int attempt = 1; attempt <= 2; attempt++) {
            GameLog log = new GameLog(contest, game.rotation());
            MatchResult result = null;
            String problem = null;
            try {
                result = contest.play(game.seed(), game.rotation(), null, log);
            } catch (UncheckedIOException failed) {
                problem = String.valueOf(failed.getMessage());
            }
            synchronized (this) {
                if (over) {
                    return;
                }
                number++;
                played = new Series.Played(number, game.seed(), game.rotation(), result, problem,
                    log.failures().stream().map(Failure::brief).toList(), null, log.facts(), before);
            }
            if (!hiccups.demandAnother(played)) {
                break;
            }
            before = played;
        }
        keeper.accept(played);
        synchronized (this) {
            Seed seed = open.get(game.number());
            seed.games()[game.rotation()] = played.result() == null ? null
                : new Past(played.facts().transcript(), values(played.result()));
            missing.merge(game.number(), -1, Integer::sum);
            deliver();
        }
    }

    private double[] values(MatchResult result) {
        if (!contest.isAlone()) {
            return result.players().stream().mapToDouble(player -> -player.rank()).toArray();
        }
        double score = result.players().get(0).score();
        return new double[] {contest.lowerScoreIsBetter() ? -score : score};
    }
}
