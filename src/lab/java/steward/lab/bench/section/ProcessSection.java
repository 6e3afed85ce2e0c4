package steward.lab.bench.section;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import steward.bot.process.BotProcess;
import steward.bot.process.PipeRoundTrip;
import steward.game.GameSetup;
import steward.lab.bench.Effort;
import steward.lab.bench.Meter;
import steward.lab.bench.Row;
import steward.lab.bench.Section;
import steward.match.MatchListener;
import steward.match.Protocol;
import steward.match.Referee;
import steward.match.Seat;
import steward.match.TimeControl;
import steward.match.Turn;

/**
 * Turns between bot processes, compared with bare pipes to the same programs; and the cost of a match before its turns.
 *
 * @param longGame  a scene in which bots that never reach a checkpoint play many turns
 * @param longTurns how many turns
 * @param oneTurn   a scene that is over after one turn
 * @param shell     a program that starts at once and answers every line with a valid one
 */
record ProcessSection(MatchFixture fixture, GameSetup longGame, int longTurns, GameSetup oneTurn, List<String> shell)
        implements Section {

    private static final String[] CLOCKS =
        {"wall clock", "CPU time of all processes", "CPU time of the asking thread"};
    private static final int WARM_TURNS = 200;
    private static final double NANOS = 1e9;
    private static final double NANOS_PER_MS = 1e6;
    /** The length of a turn frame of the official scene. */
    private static final int FRAME_BYTES = 480;

    @Override
    public String name() {
        return "processes";
    }

    @Override
    public String about() {
        return "Turns of a match between two bot processes that answer at once, against two bare pipes to the same"
            + " program, asked in sequence with as many bytes: by the wall clock, by the CPU time of all processes"
            + " together, and by that of the asking thread alone. Then whole matches of a single turn between two"
            + " shells, against starting and asking the same shells without a referee, the second when the first has"
            + " answered, as in a match, and ending them: the rest is our own. Last, a bot's start up to its first"
            + " answer at each level of isolation, and a turn after that; and a turn with limits of time by the clock"
            + " and of CPU time; and a turn of two bots where waiting bots are never held, burners are, and all are,"
            + " also of bots that compute and beside 16 busy processes.";
    }

    @Override
    public int steps(Effort effort) {
        return warmUps(effort) + 2 * effort.rounds() + 3 * (starts(effort) * 3 / 2) + starts(effort)
            + starts(effort) / 2 + Math.max(2, starts(effort) / 10);
    }

    private static int warmUps(Effort effort) {
        return effort == Effort.QUICK ? 1 : 15;
    }

    private static int starts(Effort effort) {
        return effort == Effort.QUICK ? 10 : 100;
    }

    @Override
    public boolean isRough(Effort effort) {
        return effort == Effort.QUICK;
    }

    @Override
    public void run(Effort effort, Consumer<String> about, Consumer<Row> rows) throws Exception {
        int rounds = effort.rounds();
        double[][] bare = new double[CLOCKS.length][rounds];
        double[][] match = new double[CLOCKS.length][rounds];
        for (int warm = warmUps(effort); warm > 0; warm--) {
            about.accept("warming up");
            match(new double[CLOCKS.length][1], 0);
        }
        int done = 0;
        try {
            for (; done < rounds; done++) {
                about.accept("bare pipes");
                bare(bare, done);
                about.accept("match");
                match(match, done);
            }
        } finally {
            tellTurns(bare, match, done, done == rounds ? "" : ", " + done + " of " + rounds + " rounds", rows);
        }
        starts(effort, about, rows);
        new SandboxStarts(name(), shell).run(starts(effort) * 3 / 2, about, rows);
        new TimeBasisTurns(name(), fixture.responder(), frame()).run(starts(effort) * 3 / 2, about, rows);
        new HoldTurns(name(), fixture.responder(), frame()).run(starts(effort), about, rows);
    }

    private void tellTurns(double[][] bare, double[][] match, int rounds, String note, Consumer<Row> rows) {
        for (int k = 0; k < CLOCKS.length && rounds > 0; k++) {
            double one = Meter.median(Arrays.copyOf(bare[k], rounds));
            double other = Meter.median(Arrays.copyOf(match[k], rounds));
            if (Double.isNaN(one) || Double.isNaN(other)) {
                continue;
            }
            rows.accept(new Row(name(), "bare pipes, " + CLOCKS[k], "turns", NANOS / one, 1, Double.NaN, ""));
            rows.accept(new Row(name(), "match, " + CLOCKS[k], "turns", NANOS / other, one / other, Double.NaN,
                String.format(Locale.ROOT, "%.2f times the bare pipes%s", other / one, note)));
        }
    }

    private void bare(double[][] into, int round) throws IOException {
        byte[] frame = frame();
        try (PipeRoundTrip one = new PipeRoundTrip(fixture.responder());
                PipeRoundTrip other = new PipeRoundTrip(fixture.responder())) {
            exchange(one, other, frame, WARM_TURNS);
            Clocks clocks = new Clocks();
            clocks.start();
            exchange(one, other, frame, longTurns - WARM_TURNS);
            clocks.stop();
            clocks.write(into, round, longTurns - WARM_TURNS);
        }
    }

    private static byte[] frame() {
        byte[] frame = new byte[FRAME_BYTES];
        Arrays.fill(frame, (byte) 'x');
        frame[FRAME_BYTES - 1] = '\n';
        return frame;
    }

    private static void exchange(PipeRoundTrip one, PipeRoundTrip other, byte[] frame, int turns) throws IOException {
        for (int turn = 0; turn < turns; turn++) {
            one.exchange(frame, frame.length);
            other.exchange(frame, frame.length);
        }
    }

    private void match(double[][] into, int round) throws InterruptedException {
        Clocks clocks = new Clocks();
        play(longGame, fixture.responder(), new MatchListener() {
            @Override
            public void played(Turn turn) {
                if (turn.number() == WARM_TURNS) {
                    clocks.start();
                } else if (turn.number() == longTurns) {
                    clocks.stop();
                }
            }
        });
        clocks.write(into, round, longTurns - WARM_TURNS);
    }

    /** Read by the asking thread while the bots are running. */
    private static final class Clocks {

        private final Meter meter = new Meter();
        private double tree;
        private long thread;
        private long wall;

        void start() {
            tree = ProcessTreeClock.nanos();
            thread = meter.cpu(false);
            wall = System.nanoTime();
        }

        void stop() {
            wall = System.nanoTime() - wall;
            thread = meter.cpu(false) - thread;
            tree = ProcessTreeClock.nanos() - tree;
        }

        /** In the order of {@link #CLOCKS}. */
        void write(double[][] into, int round, int turns) {
            into[0][round] = (double) wall / turns;
            into[1][round] = tree / turns;
            into[2][round] = (double) thread / turns;
        }
    }

    private static void play(GameSetup setup, List<String> command, MatchListener listener)
            throws InterruptedException {
        List<Seat> seats = IntStream.range(0, setup.scene().players()).mapToObj(player ->
            new Seat(new BotProcess("bot-" + player, command), Protocol.JSON)).toList();
        if (Referee.of(setup, 1, seats, TimeControl.UNLIMITED, listener).play().anyFault()) {
            throw new IllegalStateException("a bot failed that only answers");
        }
    }

    private void starts(Effort effort, Consumer<String> about, Consumer<Row> rows) throws Exception {
        int rounds = starts(effort);
        double[] bare = new double[rounds];
        double[] match = new double[rounds];
        byte[] line = {'\n'};
        MatchListener noListener = new MatchListener() { };
        for (int round = -rounds / 2; round < rounds; round++) {
            about.accept("starts");
            long start = System.nanoTime();
            try (PipeRoundTrip one = new PipeRoundTrip(shell)) {
                one.exchange(line, 1);
                try (PipeRoundTrip other = new PipeRoundTrip(shell)) {
                    other.exchange(line, 1);
                }
            }
            long between = System.nanoTime();
            play(oneTurn, shell, noListener);
            if (round >= 0) {
                bare[round] = between - start;
                match[round] = System.nanoTime() - between;
            }
        }
        double one = Meter.median(bare);
        double other = Meter.median(match);
        rows.accept(new Row(name(), "two shells, started and ended", "matches", NANOS / one, 1, Double.NaN,
            String.format(Locale.ROOT, "%.2f ms", one / NANOS_PER_MS)));
        rows.accept(new Row(name(), "a match of one turn between them", "matches", NANOS / other, one / other,
            Double.NaN, String.format(Locale.ROOT, "%.2f ms, %.2f of them our own", other / NANOS_PER_MS,
            (other - one) / NANOS_PER_MS)));
    }
}
