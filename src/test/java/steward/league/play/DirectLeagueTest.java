package steward.league.play;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.isolation.Isolation;
import steward.cli.shared.Games;
import steward.contest.Contest;
import steward.contest.KeptReplays;
import steward.contest.Series;
import steward.contest.SeriesPlay;
import steward.game.Game;
import steward.game.GameSetup;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodSeat;
import steward.league.LeagueBot;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Season;
import steward.league.store.GameStore;
import steward.match.DirectBot;
import steward.match.Protocol;
import steward.match.Seat;
import steward.match.TestSize;
import steward.numerics.Median;

/**
 * A league between bots in this JVM, whose games take so little that its own work shows. How much that is beside a
 * series of the same games is reported, by turns:
 * {@code ./gradlew campaigns --tests '*DirectLeagueTest' -Psteward.games=20000}.
 */
@Tag("slow")
@Tag("sized")
class DirectLeagueTest {

    private static final int GAMES = Integer.getInteger("steward.games", TestSize.of(100, 3_000));
    private static final int ROUNDS = TestSize.of(1, 7);
    private static final int THREADS = 2;
    private static final double NANOS_PER_MICRO = 1e3;
    private static final List<String> PAIR = List.of("builtin:racer", "builtin:regular");

    private final GameSetup setup = Games.open("mad-pod-racing");

    @TempDir
    private Path folder;

    /** A bot that looks at the race: at next to no cost, its pods steer slowly at their next checkpoints. */
    private static final class Driver implements DirectBot {

        private PodRace race;
        private PodSeat seat;

        @Override
        public void start(Game game, int player) {
            race = (PodRace) game;
            seat = new PodSeat(race, player);
        }

        @Override
        public void turn() {
            for (int pod = seat.first(); pod < seat.end(); pod++) {
                double[] next = race.checkpoints()[seat.nextCheckpoint(pod)];
                seat.thrust(pod, next[0] - race.bodies().vx[pod], next[1] - race.bodies().vy[pod], 60);
            }
        }
    }

    @Test
    void allGamesAreStoredAtFullSpeed(TestReporter report) throws IOException, InterruptedException {
        double[] series = new double[ROUNDS];
        double[] league = new double[ROUNDS];
        double[] ratios = new double[ROUNDS];
        for (int round = -1; round < ROUNDS; round++) {            // the first warms up
            int k = Math.max(0, round);
            for (boolean first : new boolean[] {true, false}) {
                if (first == (round % 2 == 0)) {
                    series[k] = series();
                } else {
                    league[k] = league(new LeagueFolder(Files.createDirectory(folder.resolve("round" + round))));
                }
            }
            ratios[k] = league[k] / series[k];
        }
        report.publishEntry(String.format(Locale.ROOT, "%,d games on %d threads: in a series %.1f us each, in a league "
            + "%.1f us, %.3f times (median of %d pairs)", GAMES, THREADS, Median.of(series) / NANOS_PER_MICRO,
            Median.of(league) / NANOS_PER_MICRO, Median.of(ratios), ROUNDS));
    }

    private static Contest direct(Contest contest) {
        return contest.isolatedBy(() -> Isolation.OFF)
            .startedBy((entrant, isolation, others) -> Seat.direct(entrant.name(), new Driver()).player());
    }

    /** Nanoseconds of a game. */
    private double series() throws InterruptedException {
        Contest contest = direct(Contest.of(setup, PAIR, Protocol.JSON, Double.POSITIVE_INFINITY));
        SeriesPlay play = new SeriesPlay(new Series(contest, 1, GAMES / 2, true, null, KeptReplays.NONE), false);
        long start = System.nanoTime();
        play.play(THREADS, () -> { });
        return (System.nanoTime() - start) / (double) GAMES;
    }

    private double league(LeagueFolder into) throws InterruptedException {
        LeagueSettings kept = LeagueSettings.usual(setup.scene().name(), 1)
            .with(null, Double.POSITIVE_INFINITY, KeptReplays.NONE)
            .withBots(PAIR.stream().map(bot -> new LeagueBot(bot.substring(bot.indexOf(':') + 1), bot, null, false,
                false)).toList());
        into.write(kept);
        Contest contest = direct(Contest.withoutBots(setup, Double.POSITIVE_INFINITY));
        try (GameStore store = GameStore.write(into)) {
            Season own = Season.of(setup, kept);
            int number = store.open(own);
            RosterReader reader = new RosterReader(store, contest, Map.of(), false, what -> { },
                System::currentTimeMillis);
            long start = System.nanoTime();
            new LeagueRun(new OpenSeason(into, store, number, own), contest, reader, reader.read(kept),
                new LeagueRun.Limits(THREADS, GAMES, Long.MAX_VALUE), LeagueRun.Rules.NONE, null, "bench",
                what -> { }, game -> { }).play();
            double nanos = System.nanoTime() - start;
            assertEquals(GAMES, store.games(number));
            return nanos / GAMES;
        }
    }
}
