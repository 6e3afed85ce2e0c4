package steward.lab.bench.section;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import steward.contest.Contest;
import steward.contest.KeptReplays;
import steward.contest.Series;
import steward.contest.SeriesPlay;
import steward.files.Folders;
import steward.lab.bench.Effort;
import steward.lab.bench.Row;
import steward.lab.bench.Section;
import steward.league.EarlierGames;
import steward.league.LeagueBot;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Pairing;
import steward.league.Schedule;
import steward.league.Season;
import steward.league.pairing.AdaptivePairing;
import steward.league.pairing.KnownResults;
import steward.league.pairing.Looks;
import steward.league.pairing.StopRule;
import steward.league.play.LeagueRun;
import steward.league.play.RosterReader;
import steward.league.rating.LeagueTable;
import steward.league.rating.Ratings;
import steward.league.rating.Results;
import steward.league.store.GameQueries;
import steward.league.store.GameStore;
import steward.league.store.MadeUpGames;
import steward.match.Protocol;

/** Leagues: how they grow, and whether a game in a league costs more than one in a series. */
record LeagueSection(MatchFixture fixture, int threads) implements Section {

    private static final int BOTS = 10;
    /** Sizes of fields, each with so many games a bot. */
    private static final List<Integer> FIELDS = List.of(10, 30, 100, 300, 1000);
    private static final int GAMES_A_BOT = 200;
    private static final int TABLES = 5;
    private static final int LEAST_GAMES = 1000;
    private static final int MOST_GAMES = 1_000_000;
    private static final int MOST_QUICK = 100_000;
    /** Games of a round: each starts two programs, so that more take minutes. */
    private static final int GAMES = 20;
    private static final int QUICK_GAMES = 8;
    private static final double NANOS = 1e9;
    private static final double NANOS_PER_MS = 1e6;
    private static final List<String> PAIR = List.of("builtin:racer", "builtin:regular");

    @Override
    public String name() {
        return "league";
    }

    @Override
    public String about() {
        return "Leagues, by the clock: storing made-up games, then opening the league and rating its " + BOTS
            + " bots, and finding out what is to be played next; and games between two bundled bots as a series and "
            + "in a league, in turns, the best round of each. The table of a field is the median of " + TABLES
            + ", from the sums of its games to the last rank; the first is that of a JVM that has made none.";
    }

    @Override
    public int steps(Effort effort) {
        return fields(effort).size() + 3 * sizes(effort).size() + 2 * effort.rounds();
    }

    private static List<Integer> sizes(Effort effort) {
        int most = effort == Effort.QUICK ? MOST_QUICK : MOST_GAMES;
        return IntStream.iterate(LEAST_GAMES, games -> games <= most, games -> 10 * games).boxed().toList();
    }

    @Override
    public boolean isRough(Effort effort) {
        return effort == Effort.QUICK;
    }

    @Override
    public void run(Effort effort, Consumer<String> about, Consumer<Row> rows) throws Exception {
        Path folder = Files.createTempDirectory("steward-bench");
        try {
            for (int bots : fields(effort)) {
                rate(bots, about, rows);
            }
            for (int games : sizes(effort)) {
                grow(new LeagueFolder(Files.createDirectory(folder.resolve("made-" + games))), games, about, rows);
            }
            compare(effort, folder, about, rows);
        } finally {
            Folders.delete(folder);
        }
    }

    private static List<Integer> fields(Effort effort) {
        return effort == Effort.QUICK ? FIELDS.subList(0, FIELDS.size() - 2) : FIELDS;
    }

    private void rate(int bots, Consumer<String> about, Consumer<Row> rows) throws IOException {
        int games = GAMES_A_BOT * bots;
        String field = String.format(Locale.ROOT, "table of %,d bots, %,d games", bots, games);
        about.accept(field);
        Path folder = Files.createTempDirectory("steward-bench");
        try (GameStore store = GameStore.write(new LeagueFolder(folder))) {
            Season season = Season.of(fixture.setup(), LeagueSettings.usual(fixture.setup().scene().name(), 1));
            int number = store.open(season);
            List<GameStore.Version> versions = MadeUpGames.bots(store, bots);
            new MadeUpGames(store, number, season, versions, new SplittableRandom(1)).add(games);
            List<LeagueTable.Entry> entries = versions.stream().map(version ->
                new LeagueTable.Entry(version.id(), version.display(), false, true)).toList();
            Results results = new GameQueries(store, number, season).results();
            double[] nanos = new double[TABLES];
            for (int k = 0; k < TABLES; k++) {
                long began = System.nanoTime();
                if (LeagueTable.of(results, entries).rows().size() != bots) {
                    throw new IllegalStateException("expected a row for each of " + bots + " bots");
                }
                nanos[k] = System.nanoTime() - began;
            }
            double first = nanos[0];
            Arrays.sort(nanos);
            rows.accept(new Row(name(), field, "bots", bots * NANOS / nanos[TABLES / 2], Double.NaN, Double.NaN,
                String.format(Locale.ROOT, "%.0f ms; the first %.0f ms", nanos[TABLES / 2] / NANOS_PER_MS,
                    first / NANOS_PER_MS)));
        } finally {
            Folders.delete(folder);
        }
    }

    private void grow(LeagueFolder folder, int games, Consumer<String> about, Consumer<Row> rows) throws IOException {
        String many = String.format(Locale.ROOT, "%,d games", games);
        about.accept(many + " stored");
        LeagueSettings settings = LeagueSettings.usual(fixture.setup().scene().name(), 1);
        Season season = Season.of(fixture.setup(), settings);
        long began = System.nanoTime();
        int number;
        try (GameStore store = GameStore.write(folder)) {
            number = store.open(season);
            new MadeUpGames(store, number, season, MadeUpGames.bots(store, BOTS), new SplittableRandom(1)).add(games);
        }
        double seconds = (System.nanoTime() - began) / NANOS;
        rows.accept(new Row(name(), many + " stored", "games", games / seconds, Double.NaN, Double.NaN,
            String.format(Locale.ROOT, "%.0f bytes a game", (double) Files.size(folder.database()) / games)));
        about.accept(many + " opened and rated");
        began = System.nanoTime();
        try (GameStore store = GameStore.read(folder)) {
            List<LeagueTable.Entry> entries = store.versions().stream().map(version ->
                new LeagueTable.Entry(version.id(), version.display(), false, true)).toList();
            LeagueTable table = LeagueTable.of(new GameQueries(store, number, season).results(), entries);
            if (table.results().games() != games) {
                throw new IllegalStateException("found " + table.results().games() + " games, expected " + games);
            }
        }
        rows.accept(opening(many + " opened and rated", games, began));
        for (boolean adaptive : new boolean[] {false, true}) {
            String what = many + (adaptive ? " resumed, adaptive" : " resumed");
            about.accept(what);
            began = System.nanoTime();
            try (GameStore store = GameStore.read(folder)) {
                resume(store, new GameQueries(store, number, season), season, settings.lag(), adaptive, games);
            }
            rows.accept(opening(what, games, began));
        }
    }

    /** As a run does that goes on: up to the first game. */
    private static void resume(GameStore store, GameQueries queries, Season season, int lag, boolean adaptive,
                               int games) {
        EarlierGames earlier = queries.earlier();
        int settled = Looks.settled(earlier.firstOpen(), lag);
        Schedule schedule = new Schedule(1, 2, lag, earlier);
        List<Integer> playing = store.versions().stream().map(GameStore.Version::id).toList();
        if (adaptive) {
            KnownResults known = new KnownResults(season, queries.resultsBefore(settled));
            queries.known(settled, known::add);
            schedule.play(playing, versions -> new AdaptivePairing(versions, 2, lag, StopRule.NONE,
                before -> Ratings.of(known.before(before), versions)));
        } else {
            schedule.play(playing, versions -> Pairing.roundRobin(versions, 2));
        }
        Schedule.Task next = schedule.next(Long.MAX_VALUE);
        if (next.decision() != games / 2) {
            throw new IllegalStateException("found decision " + next.decision() + ", expected " + games / 2);
        }
    }

    private Row opening(String what, int games, long began) {
        double nanos = System.nanoTime() - began;
        return new Row(name(), what, "games", games * NANOS / nanos, Double.NaN, Double.NaN,
            String.format(Locale.ROOT, "%.0f ms in all", nanos / NANOS_PER_MS));
    }

    private void compare(Effort effort, Path folder, Consumer<String> about, Consumer<Row> rows)
            throws InterruptedException, IOException {
        int games = effort == Effort.QUICK ? QUICK_GAMES : GAMES;
        double[] series = new double[effort.rounds()];
        double[] league = new double[effort.rounds()];
        for (int step = 0; step < 2 * effort.rounds(); step++) {
            int round = step / 2;
            if (step % 4 == 0 || step % 4 == 3) {      // neither is always the first of a round
                about.accept("games of a series");
                series[round] = series(games);
            } else {
                about.accept("games of a league");
                league[round] = league(new LeagueFolder(Files.createDirectory(folder.resolve("played-" + round))),
                    games);
            }
        }
        double best = Arrays.stream(series).max().orElseThrow();
        double other = Arrays.stream(league).max().orElseThrow();
        rows.accept(new Row(name(), "games of a series", "games", best, Double.NaN, Double.NaN, threads + " threads"));
        rows.accept(new Row(name(), "games of a league", "games", other, other / best, Double.NaN,
            threads + " threads"));
    }

    private double series(int games) throws InterruptedException {
        Contest contest = Contest.of(fixture.setup(), PAIR, Protocol.JSON, Double.POSITIVE_INFINITY);
        SeriesPlay play = new SeriesPlay(new Series(contest, 1, games / 2, true, null, KeptReplays.NONE), false);
        long began = System.nanoTime();
        play.play(threads, () -> { });
        return games * NANOS / (System.nanoTime() - began);
    }

    private double league(LeagueFolder folder, int games) throws InterruptedException {
        LeagueSettings settings = LeagueSettings.usual(fixture.setup().scene().name(), 1)
            .with(null, Double.POSITIVE_INFINITY, KeptReplays.NONE)
            .withBots(PAIR.stream().map(bot -> new LeagueBot(bot.substring(bot.indexOf(':') + 1), bot, null, false,
                false)).toList());
        folder.write(settings);
        Season season = Season.of(fixture.setup(), settings);
        Contest contest = Contest.withoutBots(fixture.setup(), Double.POSITIVE_INFINITY);
        try (GameStore store = GameStore.write(folder)) {
            int number = store.open(season);
            RosterReader reader = new RosterReader(store, contest, Map.of(), false, what -> { },
                System::currentTimeMillis);
            long began = System.nanoTime();
            LeagueRun run = new LeagueRun(folder, store, number, season, contest, reader, reader.read(settings),
                new LeagueRun.Limits(threads, games, Long.MAX_VALUE), "bench", what -> { }, game -> { });
            run.play();
            double nanos = System.nanoTime() - began;
            if (store.games(number) != games) {
                throw new IllegalStateException("found " + store.games(number) + " games, expected " + games);
            }
            return games * NANOS / nanos;
        }
    }
}
