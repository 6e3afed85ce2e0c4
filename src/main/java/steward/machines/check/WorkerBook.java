package steward.machines.check;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.IntFunction;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import steward.league.StoredGame;
import steward.league.StoredGame.StoredSeat;

/**
 * Statistics of a league's games by worker, which tell whose games differ from all others' by more than chance. If bots
 * use random numbers, nothing else distinguishes a forged game from a played one.
 *
 * <p>For each bot in each seat four frequencies are compared: how often it failed, how often nobody was ahead of it,
 * how often its score is above the median, and how often its mean answer time is (only if the medians differ by a
 * factor of two, since machines may differ). Games of one lineup are alike, and who plays them is decided before they
 * begin; so {@link DrawnWithout} is exact. It is applied when a worker has 20, 40, 80, ... games, at a level that
 * halves each time, divided by the number of comparisons. So an honest worker whose machine is like the others is ever
 * called doubtful with a probability of at most {@value #LEVEL}. Thread-safe.
 */
public final class WorkerBook {

    /** The chance that an honest worker is ever called doubtful. */
    public static final double LEVEL = 0.01;
    private static final int FIRST = 20;
    private static final double FACTOR = 2;
    /** The names of machines begin so where a worker has played. */
    public static final String WORKER = "worker ";

    private final IntFunction<String> names;
    private final Map<String, Entry> workers = new TreeMap<>();
    private final Map<String, Group> groups = new LinkedHashMap<>();

    /** A worker's games. */
    private static final class Entry {
        private final int number;
        private long games;
        private long aside;
        private boolean suspended;
        private long faults;
        private long repeated;
        private int looks;
        private List<String> doubts = List.of();

        Entry(int number) {
            this.number = number;
        }
    }

    /**
     * A worker, as its games tell.
     *
     * @param games    that count
     * @param aside    that were set aside or are suspended
     * @param suspended true if some are suspended
     * @param faults   of bots in those that count
     * @param repeated games that were played again
     * @param doubts   what is doubtful, a sentence each
     */
    public record Line(String name, long games, long aside, boolean suspended, long faults, long repeated,
                       List<String> doubts) {

        public Line {
            doubts = List.copyOf(doubts);
        }
    }

    /** One bot in one seat of one lineup: of each game who played it (0: the league itself), and what it came to. */
    private static final class Group {
        private final int version;
        private final int seat;
        private int size;
        private int[] players = new int[8];
        private double[][] values = new double[Measure.values().length][8];

        Group(int version, int seat) {
            this.version = version;
            this.seat = seat;
        }

        void add(int player, StoredSeat what) {
            if (size == players.length) {
                players = Arrays.copyOf(players, 2 * size);
                for (int k = 0; k < values.length; k++) {
                    values[k] = Arrays.copyOf(values[k], 2 * size);
                }
            }
            for (Measure measure : Measure.values()) {
                values[measure.ordinal()][size] = measure.value.applyAsDouble(what);
            }
            players[size++] = player;
        }
    }

    /** What is compared. */
    private enum Measure {
        FAULTS("failed in", seat -> seat.fault() == null ? 0 : 1),
        FIRST_PLACES("had nobody ahead of it in", seat -> seat.rank() == 0 ? 1 : 0),
        SCORES("had a score above the median in", StoredSeat::score),
        TIMES("took longer than the median to answer in", StoredSeat::meanNanos);

        private final String words;
        private final ToDoubleFunction<StoredSeat> value;

        Measure(String words, ToDoubleFunction<StoredSeat> value) {
            this.words = words;
            this.value = value;
        }

        /** What is more than this has the mark. */
        private double threshold(Group group) {
            if (this == FAULTS || this == FIRST_PLACES) {
                return 0.5;
            }
            double[] sorted = Arrays.copyOf(group.values[ordinal()], group.size);
            Arrays.sort(sorted);
            return sorted[(sorted.length - 1) / 2];
        }
    }

    /** @param names of versions, for people */
    public WorkerBook(IntFunction<String> names) {
        this.names = names;
    }

    /** Returns how the texts begin that say where a worker's games were played. */
    public static String machine(String worker) {
        return WORKER + worker + ": ";
    }

    /** The name of the worker that played on this machine, or {@code null} for the league itself. */
    public static String worker(String machine) {
        int end = machine.indexOf(": ");
        return machine.startsWith(WORKER) && end > 0 ? machine.substring(WORKER.length(), end) : null;
    }

    /** A game that is stored. @return what has become doubtful of its worker, a sentence each */
    public synchronized List<String> add(StoredGame game) {
        String name = worker(game.machine());
        Entry entry = name == null ? null
            : workers.computeIfAbsent(name, any -> new Entry(workers.size() + 1));
        if (!game.counts()) {
            if (entry != null) {
                boolean suspended = game.problem() != null && game.problem().startsWith(StoredGame.SUSPENDED);
                boolean aside = game.problem() != null && game.problem().startsWith(StoredGame.SET_ASIDE);
                entry.aside += aside || suspended ? 1 : 0;
                entry.suspended |= suspended;
                entry.repeated += game.problem() == null ? 1 : 0;
            }
            return List.of();
        }
        for (int seat = 0; seat < game.seats().size(); seat++) {
            StoredSeat what = game.seats().get(seat);
            int place = seat;
            groups.computeIfAbsent(Arrays.toString(game.lineup()) + seat, key -> new Group(what.version(), place))
                .add(entry == null ? 0 : entry.number, what);
            if (entry != null) {
                entry.faults += what.fault() == null ? 0 : 1;
            }
        }
        if (entry != null) {
            entry.games++;
            if (entry.games == (long) FIRST << entry.looks) {
                entry.looks++;
                List<String> before = entry.doubts;
                look(entry);
                return before.equals(entry.doubts) ? List.of() : entry.doubts;
            }
        }
        return List.of();
    }

    /** Compares a worker with all others. */
    private void look(Entry entry) {
        Map<String, List<Group>> bots = new LinkedHashMap<>();
        for (Group group : groups.values()) {
            if (Arrays.stream(group.players, 0, group.size).anyMatch(player -> player == entry.number)) {
                bots.computeIfAbsent(group.version + " " + group.seat, key -> new ArrayList<>()).add(group);
            }
        }
        double level = LEVEL / (1L << entry.looks) / (bots.size() * Measure.values().length);
        List<String> found = new ArrayList<>(entry.doubts);
        for (List<Group> bot : bots.values()) {
            for (Measure measure : Measure.values()) {
                String doubt = doubt(entry, bot, measure, level);
                if (doubt != null) {
                    found.removeIf(old -> old.startsWith(doubt.substring(0, doubt.indexOf(measure.words))
                        + measure.words));
                    found.add(doubt);
                }
            }
        }
        entry.doubts = List.copyOf(found);
    }

    private String doubt(Entry entry, List<Group> bot, Measure measure, double level) {
        DrawnWithout test = new DrawnWithout();
        int all = 0;
        int marked = 0;
        int own = 0;
        int hits = 0;
        for (Group group : bot) {
            double threshold = measure.threshold(group);
            int groupMarked = 0;
            int groupOwn = 0;
            int groupHits = 0;
            for (int k = 0; k < group.size; k++) {
                boolean mark = group.values[measure.ordinal()][k] > threshold;
                boolean mine = group.players[k] == entry.number;
                groupMarked += mark ? 1 : 0;
                groupOwn += mine ? 1 : 0;
                groupHits += mark && mine ? 1 : 0;
            }
            test.add(group.size, groupMarked, groupOwn, groupHits);
            all += group.size;
            marked += groupMarked;
            own += groupOwn;
            hits += groupHits;
        }
        double chance = test.chance();
        if (chance > level || measure == Measure.TIMES && !isApart(entry, bot)) {
            return null;
        }
        return names.apply(bot.get(0).version) + " in seat " + (bot.get(0).seat + 1) + " " + measure.words + " " + hits
            + " of " + own + " games, elsewhere in " + (marked - hits) + " of " + (all - own)
            + String.format(Locale.ROOT, " (p = %.1e)", chance);
    }

    /** Whether the medians of answer times differ by the factor, in any one lineup's games and all others'. */
    private static boolean isApart(Entry entry, List<Group> bot) {
        double[] own = times(bot, entry.number, true);
        double[] others = times(bot, entry.number, false);
        if (own.length == 0 || others.length == 0) {
            return false;
        }
        double mine = Math.max(1, own[own.length / 2]);
        double theirs = Math.max(1, others[others.length / 2]);
        return Math.max(mine, theirs) >= FACTOR * Math.min(mine, theirs);
    }

    private static double[] times(List<Group> bot, int number, boolean mine) {
        double[] times = bot.stream().flatMapToDouble(group -> IntStream.range(0, group.size)
            .filter(k -> (group.players[k] == number) == mine)
            .mapToDouble(k -> group.values[Measure.TIMES.ordinal()][k])).toArray();
        Arrays.sort(times);
        return times;
    }

    /** All workers that have played, by name. */
    public synchronized List<Line> lines() {
        List<Line> lines = new ArrayList<>();
        workers.forEach((name, entry) -> lines.add(new Line(name, entry.games, entry.aside, entry.suspended,
            entry.faults, entry.repeated, entry.doubts)));
        return lines;
    }
}
