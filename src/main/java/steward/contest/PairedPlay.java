package steward.contest;

import java.io.UncheckedIOException;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import steward.contest.repeat.GameFacts;
import steward.contest.repeat.Repeats;
import steward.contest.seeds.Seeds;
import steward.match.MatchResult;

/**
 * Play of a few bots' games seed after seed, each seed from all seats, until the results suffice or no seed is left.
 * Results are delivered to a receiver in the order of seeds, however many threads play. Games that are still being
 * played when the receiver has enough do not count.
 */
public final class PairedPlay {

    private final Tables tables;
    private final Hiccups hiccups;
    private final Taker taker;

    /** Guarded by this, as is all below: games that are to be begun. */
    private final Deque<Game> waiting = new ArrayDeque<>();
    /** Seeds that are not over, by number. */
    private final TreeMap<Integer, Seed> open = new TreeMap<>();
    /** Games of these that were played here and in which a bot failed. */
    private final Map<Integer, Map<Contest, Map<Series.Played, List<Failure>>>> failed = new HashMap<>();
    /** How many of their games are not over. */
    private final TreeMap<Integer, Integer> missing = new TreeMap<>();
    private int begun;
    private boolean over;
    private final ProgramWatch watch;

    /**
     * Contests that all play a seed.
     *
     * @param contests whose games on it belong together, in their order
     */
    public record Table(long seed, List<Contest> contests) { }

    /** Source of what is played, and the place for what has been played. */
    public interface Tables {

        /** Returns who plays at a place from 0 on; {@code null} if that is behind the last. */
        Table at(int place);

        /** Returns how a game went that need not be played, or {@code null}. */
        Outcome known(Contest contest, long seed, int rotation);

        /** Takes a game that is over, from any thread; what it throws ends everything. */
        void keep(Contest contest, Series.Played game);

        /** Returns where failures are counted, with games numbered in the order of seeds and rotations. */
        FailureCounts failures(Contest contest);
    }

    /**
     * A game that is over.
     *
     * @param values    by player, more is better; {@code null} where the game has no result, or all players failed in
     *                  the same turn, which tells of none that it is better
     * @param allFailed whether it is that
     * @param transcript see {@link GameFacts}; 0 if it is not known
     * @param failed    by player, whether it failed
     */
    public record Outcome(double[] values, boolean allFailed, long transcript, boolean... failed) {

        private static final Outcome NONE = new Outcome(null, false, 0);
    }

    /** A game that has been played before. */
    public interface Known {

        /** Returns how it went, or {@code null} if that is not known. */
        Outcome outcome(long seed, int rotation);
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
     * @param games by rotation; of several contests, those of the first stand first
     */
    public record Seed(long seed, Outcome... games) {

        /** True if every game has values. */
        public boolean isWhole() {
            return Arrays.stream(games).allMatch(game -> game.values() != null);
        }

        /** Adds the games. @return true if each had been played before, see {@link Repeats} */
        public boolean isRepeat(Repeats repeats) {
            boolean all = true;
            for (int rotation = 0; rotation < games.length; rotation++) {
                all &= repeats.isRepeat(rotation, games[rotation].transcript());
            }
            return all;
        }

        /** True if in one of the games all players failed in the same turn. */
        public boolean allFailed() {
            return Arrays.stream(games).anyMatch(Outcome::allFailed);
        }

        /** True if a player failed in one of the games. */
        public boolean isAnyFailed() {
            for (Outcome game : games) {
                for (boolean each : game.failed()) {
                    if (each) {
                        return true;
                    }
                }
            }
            return false;
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

        /**
         * Advantage of a seat, 0..1/2: the greatest distance of the mean points of a seat from 1/2, whoever sits there.
         * It is 0 where each plays alone.
         */
        public double seatAdvantage() {
            double most = 0;
            for (int player = 0; games[0].values().length > 1 && player < games[0].values().length; player++) {
                double sum = 0;
                for (Outcome game : games) {
                    sum += points(game.values(), player);
                }
                most = Math.max(most, Math.abs(sum / games.length - 0.5));
            }
            return most;
        }

        /**
         * Sum of a bot's points over the games of one contest.
         *
         * @param first place of its first game among those of the seed
         */
        public double points(Contest contest, int bot, int first) {
            double sum = 0;
            for (int rotation = 0; rotation < PairedPlay.games(contest); rotation++) {
                for (int player = 0; player < contest.players(); player++) {
                    sum += contest.entrantOf(player, rotation) == bot
                        ? points(games[first + rotation].values(), player) : 0;
                }
            }
            return sum;
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

    /**
     * A game to be played.
     *
     * @param first place of its contest's first game among those of the seed
     */
    private record Game(int number, Contest contest, long seed, int rotation, int first) { }

    /**
     * @param seeds  in the order in which they are played
     * @param known  games that need not be played
     * @param keeper is told of every game that is over, by any thread; what it throws ends everything
     * @param failures takes the failures of games, numbered in the order of seeds and rotations
     * @param watch    over the programs: when one becomes another, no further game is begun
     */
    public PairedPlay(Contest contest, Seeds seeds, Hiccups hiccups, Known known, Consumer<Series.Played> keeper,
                      FailureCounts failures, ProgramWatch watch, Taker taker) {
        this(new Tables() {
            @Override
            public Table at(int place) {
                return place < seeds.count() ? new Table(seeds.at(place), List.of(contest)) : null;
            }

            @Override
            public Outcome known(Contest any, long seed, int rotation) {
                return known.outcome(seed, rotation);
            }

            @Override
            public void keep(Contest any, Series.Played game) {
                keeper.accept(game);
            }

            @Override
            public FailureCounts failures(Contest any) {
                return failures;
            }
        }, hiccups, watch, taker);
    }

    /** A play of several contests. @param watch over the programs of all */
    public PairedPlay(Tables tables, Hiccups hiccups, ProgramWatch watch, Taker taker) {
        this.tables = tables;
        this.hiccups = hiccups;
        this.watch = watch;
        this.taker = taker;
    }

    /** Plays until the taker has enough, or somebody breaks it off. */
    public void play(int threads) throws InterruptedException {
        try {
            WorkerThreads.run("seeds", threads, thread -> () -> {
                while (watch.await(this::isOver)) {
                    Game game = next();
                    if (game != null) {
                        play(game);
                    }
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

    /** True if no game is left to begin. */
    private synchronized boolean isOver() {
        return over || waiting.isEmpty() && tables.at(begun) == null;
    }

    /** Number of games of a contest on a seed. */
    public static int games(Contest contest) {
        return contest.isAlone() ? contest.entrants().size() : contest.players();
    }

    private synchronized Game next() {
        for (Table table = next(waiting.isEmpty()); table != null; table = next(waiting.isEmpty())) {
            Outcome[] outcomes = new Outcome[table.contests().stream().mapToInt(PairedPlay::games).sum()];
            open.put(begun, new Seed(table.seed(), outcomes));
            missing.put(begun, 0);
            int first = 0;
            for (Contest contest : table.contests()) {
                for (int rotation = 0; rotation < games(contest); rotation++) {
                    outcomes[first + rotation] = tables.known(contest, table.seed(), rotation);
                    if (outcomes[first + rotation] == null) {
                        waiting.add(new Game(begun, contest, table.seed(), rotation, first));
                        missing.merge(begun, 1, Integer::sum);
                    }
                }
                first += games(contest);
            }
            begun++;
            deliver();
        }
        return over || waiting.isEmpty() ? null : waiting.remove();
    }

    private Table next(boolean isWanted) {
        return over || !isWanted ? null : tables.at(begun);
    }

    private void deliver() {
        while (!over && !open.isEmpty() && missing.get(open.firstKey()) == 0) {
            missing.remove(open.firstKey());
            Map<Contest, Map<Series.Played, List<Failure>>> found = failed.remove(open.firstKey());
            for (Contest contest : tables.at(open.firstKey()).contests()) {
                tables.failures(contest).addSeed(games(contest), found == null ? Map.of()
                    : found.getOrDefault(contest, Map.of()));
            }
            over = !taker.take(open.pollFirstEntry().getValue());
        }
    }

    private void play(Game game) throws InterruptedException {
        Series.Played before = null;
        Series.Played played = null;
        List<Failure> found = List.of();
        Contest contest = game.contest();
        Attempts attempts = new Attempts(contest, hiccups, game.rotation());
        String mark = watch.mark();
        boolean again = true;
        while (again) {
            GameLog log = new GameLog(contest, game.rotation());
            MatchResult result = null;
            String problem = null;
            try {
                result = attempts.contest().play(game.seed(), game.rotation(), null, log);
            } catch (UncheckedIOException failed) {
                problem = String.valueOf(failed.getMessage());
            }
            synchronized (this) {
                if (over) {
                    return;
                }
                if (!watch.isSince(mark)) {
                    waiting.addFirst(game);            // a file was touched meanwhile: it does not count
                    return;
                }
                found = log.failures();
                played = new Series.Played(game.rotation() + 1, game.seed(), game.rotation(), result, problem,
                    found.stream().map(Failure::brief).toList(), null, log.facts(), before);
            }
            again = result != null && attempts.demandAnother(played.failures());
            before = played;
        }
        if (attempts.discarded() != null) {
            played = played.without(attempts.discarded());
            found = List.of();
        }
        tables.keep(contest, played);
        synchronized (this) {
            open.get(game.number()).games()[game.first() + game.rotation()] = outcome(contest, played);
            if (!found.isEmpty()) {
                failed.computeIfAbsent(game.number(), any -> new LinkedHashMap<>())
                    .computeIfAbsent(contest, any -> new LinkedHashMap<>()).put(played, found);
            }
            missing.merge(game.number(), -1, Integer::sum);
            deliver();
        }
    }

    private static Outcome outcome(Contest contest, Series.Played game) {
        MatchResult result = game.result();
        if (result == null) {
            return Outcome.NONE;
        }
        boolean[] faults = new boolean[result.players().size()];
        for (int player = 0; player < faults.length; player++) {
            faults[player] = result.players().get(player).fault() != null;
        }
        return new Outcome(game.allFailed() ? null : values(contest, result), game.allFailed(),
            game.facts().transcript(), faults);
    }

    private static double[] values(Contest contest, MatchResult result) {
        if (!contest.isAlone()) {
            return result.players().stream().mapToDouble(player -> -player.rank()).toArray();
        }
        double score = result.players().get(0).score();
        return new double[] {contest.lowerScoreIsBetter() ? -score : score};
    }
}
