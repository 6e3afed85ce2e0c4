package steward.cli.tournament;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.ToIntFunction;
import java.util.stream.IntStream;
import steward.cli.league.view.OwnValues;
import steward.league.StoredGame;
import steward.league.StoredGame.StoredSeat;
import steward.league.rating.LeagueTable;
import steward.report.Table;
import steward.text.TextFormat;

/**
 * Table of a tournament, by points. A game gives 1 point to its winner and 1/2 for a draw; among several players, the
 * share of the others that are ranked below. In a game for one player, the results on one map are a game of all.
 *
 * @param rows best first
 * @param rule how ties are broken, in words
 */
record Scores(List<Row> rows, String rule) {

    /** Rule of ties where everybody meets everybody. */
    static final String DIRECT = "Ties: points in the games between those tied, then wins; then the place is shared.";

    private static final int WIDEST = 40;

    /**
     * One program.
     *
     * @param place  from 1; shared where nothing tells two apart
     * @param games  that count
     * @param failed games in which it failed
     * @param tie    what breaks ties: points against those with equal points, or Buchholz
     */
    record Row(int place, int version, String name, int games, int wins, int draws, int losses, double points,
               double tie, int failed) { }

    /** Sums of one program; points are halves of pairs, so that they are whole numbers. */
    private static final class Sum {
        private int games;
        private int wins;
        private int draws;
        private int failed;
        private int bye;
        private final Map<Integer, Integer> halves = new TreeMap<>();

        private int points() {
            return bye + halves.values().stream().mapToInt(Integer::intValue).sum();
        }
    }

    /** The table where everybody meets everybody. */
    static Scores of(PlayedGames played) {
        Map<Integer, Sum> sums = sums(played);
        return table(played, sums, DIRECT, (version, tied) -> tied.stream().mapToInt(other ->
            sums.get(version).halves.getOrDefault(other, 0)).sum());
    }

    /** Rule of ties of Swiss rounds. */
    static final String BUCHHOLZ = "Ties: the sum of the opponents' points (Buchholz), then wins; then the place is "
        + "shared. A bye counts as a round won.";

    /**
     * The table of Swiss rounds.
     *
     * @param games of a round, of each program
     */
    static Scores of(PlayedGames played, Rounds rounds, int games) {
        Map<Integer, Sum> sums = sums(played);
        int players = played.season().players();
        Map<Integer, List<Integer>> opponents = new HashMap<>();
        rounds.met().forEach((group, times) -> group.forEach(one -> group.stream().filter(other -> !other.equals(one))
            .forEach(other -> opponents.computeIfAbsent(played.versionOf(one), key -> new ArrayList<>())
                .addAll(Collections.nCopies(times, played.versionOf(other))))));
        rounds.byes(players).forEach((name, byes) -> sums.get(played.versionOf(name)).bye = byes * games * 2 * (players
            - 1));
        return table(played, sums, BUCHHOLZ, (version, tied) -> opponents.getOrDefault(version, List.of()).stream()
            .mapToInt(other -> sums.get(other).points()).sum());
    }

    /** True if the table is that of Swiss rounds, whose ties Buchholz breaks. */
    boolean isSwiss() {
        return rule.equals(BUCHHOLZ);
    }

    /** Breaks a tie. */
    interface TieBreak {
        /** Returns a number that is larger for the better one. @param tied all with as many points */
        int of(int version, List<Integer> tied);
    }

    private static Scores table(PlayedGames played, Map<Integer, Sum> sums, String rule, TieBreak tieBreak) {
        Map<Integer, List<Integer>> tied = new HashMap<>();
        sums.forEach((version, sum) -> tied.computeIfAbsent(sum.points(), points -> new ArrayList<>()).add(version));
        ToIntFunction<Integer> tie = version -> tieBreak.of(version, tied.get(sums.get(version).points()));
        Map<Integer, String> names = played.names();
        Comparator<Integer> better = Comparator.<Integer>comparingInt(version -> -sums.get(version).points())
            .thenComparingInt(version -> -tie.applyAsInt(version)).thenComparingInt(version -> -sums.get(version).wins);
        List<Integer> order = sums.keySet().stream().sorted(better.thenComparing(names::get)).toList();
        double unit = 2.0 * Math.max(1, others(played));
        List<Row> rows = new ArrayList<>();
        for (int version : order) {
            Sum sum = sums.get(version);
            int above = rows.size() - 1;
            int place = above >= 0 && better.compare(rows.get(above).version(), version) == 0 ? rows.get(above).place()
                : rows.size() + 1;
            rows.add(new Row(place, version, names.get(version), sum.games, sum.wins, sum.draws,
                sum.games - sum.wins - sum.draws, sum.points() / unit, tie.applyAsInt(version) / unit, sum.failed));
        }
        return new Scores(rows, rule);
    }

    /** Others in a game, for the share of them; alone, all others are met one by one. */
    private static int others(PlayedGames played) {
        return (played.season().players() == 1 ? played.entries().size() : played.season().players()) - 1;
    }

    /** Everything that a reader of the table has to know: how ties are broken, and why counts differ, if they do. */
    List<String> notes(PlayedGames played) {
        List<String> notes = new ArrayList<>(List.of("A win is 1 point, a draw 1/2"
            + (others(played) > 1 ? "; of several others, the share that is ranked below" : "") + ". " + rule));
        long again = played.games().stream().filter(game -> !game.counts() && game.problem() == null).count();
        if (again > 0) {
            notes.add(TextFormat.count(again, "attempt") + " at a game " + (again == 1 ? "was" : "were")
                + " repeated, as other programs used the processors; each game counts once.");
        }
        long allFailed = played.counted().stream().filter(StoredGame::allFailed).count();
        if (allFailed > 0) {
            notes.add("In " + TextFormat.count(allFailed, "game") + " all failed in the same turn: they count here as "
                + "the rules say, and in no rating.");
        }
        if (isSwiss()) {
            return notes;
        }
        int most = rows.stream().mapToInt(Row::games).max().orElse(0);
        rows.stream().filter(row -> row.games() < most).forEach(row -> notes.add(row.name() + " has "
            + TextFormat.count(row.games(), "game") + ", others up to " + most + ": "
            + missing(played, row.version())));
        return notes;
    }

    private static String missing(PlayedGames played, int version) {
        List<StoredGame> without = played.games().stream().filter(game -> game.problem() != null
            && game.seats().stream().anyMatch(seat -> seat.version() == version)).toList();
        return without.isEmpty() ? "the others are not played yet; the same command goes on."
            : TextFormat.count(without.size(), "game") + " without a result, such as "
                + TextFormat.plain(without.get(0).problem()) + ".";
    }

    private static Map<Integer, Sum> sums(PlayedGames played) {
        Map<Integer, Sum> sums = new TreeMap<>();
        played.entries().forEach(entry -> sums.put(entry.version(), new Sum()));
        Map<Long, List<StoredSeat>> maps = new TreeMap<>();
        for (StoredGame game : played.counted()) {
            for (StoredSeat seat : game.seats()) {
                Sum sum = sums.get(seat.version());
                sum.games++;
                sum.failed += seat.fault() == null ? 0 : 1;
            }
            if (game.seats().size() == 1) {
                maps.computeIfAbsent(game.seed(), seed -> new ArrayList<>()).add(game.seats().get(0));
            } else {
                add(sums, game.seats().stream().mapToInt(StoredSeat::version).toArray(),
                    game.seats().stream().mapToInt(StoredSeat::rank).toArray());
            }
        }
        int sign = played.season().lowerScoreIsBetter() ? 1 : -1;
        maps.values().forEach(seats -> add(sums, seats.stream().mapToInt(StoredSeat::version).toArray(),
            seats.stream().mapToInt(seat -> (int) seats.stream().filter(other ->
                sign * Double.compare(other.score(), seat.score()) < 0).count()).toArray()));
        return sums;
    }

    private static void add(Map<Integer, Sum> sums, int[] versions, int... ranks) {
        long first = IntStream.of(ranks).filter(rank -> rank == 0).count();
        for (int k = 0; k < versions.length; k++) {
            Sum sum = sums.get(versions[k]);
            sum.wins += ranks[k] == 0 && first == 1 ? 1 : 0;
            sum.draws += ranks[k] == 0 && first > 1 ? 1 : 0;
            for (int j = 0; j < versions.length; j++) {
                if (j != k) {
                    sum.halves.merge(versions[j], 1 + Integer.signum(ranks[j] - ranks[k]), Integer::sum);
                }
            }
        }
    }

    /** The columns for a terminal and JSON. */
    Table<Row> table() {
        Table<Row> table = new Table<Row>().value("place", Row::place).shown("  #", 3)
            .value("name", Row::name)
            .left("program", 1, row -> TextFormat.plain(TextFormat.shorten(row.name(), WIDEST)))
            .right("points", 9, row -> points(row.points()))
            .value("games", Row::games).shown("games", 7).value("won", Row::wins).shown("won", 7)
            .value("drawn", Row::draws).shown("drawn", 7).value("lost", Row::losses).shown("lost", 7)
            .value("failed", Row::failed).shown("failed", 8)
            .value("points", Row::points).value("tie", Row::tie);
        return isSwiss() ? table.right("Buchholz", 10, row -> points(row.tie())) : table;
    }

    /** The table with ratings and the games' own values, as comma-separated values. */
    String csv(PlayedGames played, LeagueTable ratings) {
        OwnValues own = new OwnValues();
        played.games().forEach(own::add);
        Map<Integer, LeagueTable.Row> rated = new HashMap<>();
        ratings.rows().forEach(row -> rated.put(row.entry().version(), row));
        return own.addTo(new Table<Row>().value("place", Row::place).value("program", Row::name)
            .value("points", row -> points(row.points())).value("games", Row::games).value("won", Row::wins)
            .value("drawn", Row::draws).value("lost", Row::losses).value("failed", Row::failed)
            .value("tie", row -> points(row.tie()))
            .value("rating", row -> TextFormat.number(rated.get(row.version()).rating(), 1))
            .value("bar", row -> rated.get(row.version()).hasBar()
                ? TextFormat.number(rated.get(row.version()).bar(), 1) : ""), Row::version)
            .csv(rows, number -> TextFormat.number(number, 6), false);
    }

    /** Points as they are written: one digit behind the point, two where several play. */
    static String points(double points) {
        return TextFormat.number(points, Math.rint(2 * points) == 2 * points ? 1 : 2);
    }
}
