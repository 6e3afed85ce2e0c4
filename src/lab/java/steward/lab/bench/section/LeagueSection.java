package steward.lab.bench.section;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import steward.contest.Contest;
import steward.contest.KeptReplays;
import steward.contest.Series;
import steward.contest.SeriesPlay;
import steward.files.Folders;
import steward.lab.bench.Effort;
import steward.lab.bench.Row;
import steward.lab.bench.Section;
import steward.league.LeagueBot;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Season;
import steward.league.play.LeagueRun;
import steward.league.play.RosterReader;
import steward.league.store.GameStore;
import steward.match.Protocol;

/** Leagues: whether a game in a league costs more than one in a series. */
record LeagueSection(MatchFixture fixture, int threads) implements Section {

    /** Games of a round: each starts two programs, so that more take minutes. */
    private static final int GAMES = 20;
    private static final int QUICK_GAMES = 8;
    private static final double NANOS = 1e9;
    private static final List<String> PAIR = List.of("builtin:racer", "builtin:regular");

    @Override
    public String name() {
        return "league";
    }

    @Override
    public String about() {
        return "Games between two bundled bots as a series and in a league, by the clock, in turns, the best round of "
            + "each.";
    }

    @Override
    public int steps(Effort effort) {
        return 2 * effort.rounds();
    }

    @Override
    public boolean isRough(Effort effort) {
        return effort == Effort.QUICK;
    }

    @Override
    public void run(Effort effort, Consumer<String> about, Consumer<Row> rows) throws Exception {
        Path folder = Files.createTempDirectory("steward-bench");
        try {
            compare(effort, folder, about, rows);
        } finally {
            Folders.delete(folder);
        }
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
