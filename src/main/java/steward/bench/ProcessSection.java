package steward.bench;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import steward.bot.BotProcess;
import steward.bot.PipeRoundTrip;
import steward.game.GameSetup;
import steward.match.MatchListener;
import steward.match.Protocol;
import steward.match.Referee;
import steward.match.Seat;
import steward.match.TimeControl;
import steward.match.Turn;

/** Turns between bot processes, against bare pipes to the same programs; and what a match costs before its turns. */
final class ProcessSection implements Section {

    private static final int WARM_TURNS = 20;
    private static final double NANOS = 1e9;
    private static final double NANOS_PER_MS = 1e6;
    /** As long as a turn frame of the official scene. */
    private static final int FRAME_BYTES = 480;

    private final MatchKit kit;
    private final GameSetup longGame;
    private final GameSetup oneTurn;
    private final List<String> shell;

    /**
     * @param longGame a scene in which bots that never arrive play many turns
     * @param oneTurn  a scene that is over after one turn
     * @param shell    a program that starts at once and answers every line with a good one
     */
    ProcessSection(MatchKit kit, GameSetup longGame, GameSetup oneTurn, List<String> shell) {
        this.kit = kit;
        this.longGame = longGame;
        this.oneTurn = oneTurn;
        this.shell = shell;
    }

    @Override
    public String name() {
        return "processes";
    }

    @Override
    public String about() {
        return "Turns of a match between two bot processes that answer at once, against two bare pipes to the same"
            + " program, asked in sequence with as many bytes: by the wall clock, and by the CPU time of the asking"
            + " thread alone. Then whole matches of a single turn between two shells, against starting, asking and"
            + " ending the same shells without a referee: the rest is our own.";
    }

    @Override
    public int steps(Effort effort) {
        return (effort == Effort.QUICK ? 1 : 15) + 2 * effort.rounds() + (effort == Effort.QUICK ? 15 : 150);
    }

    @Override
    public void run(Effort effort, Consumer<String> about, Consumer<Row> rows) throws Exception {
        int rounds = effort.rounds();
        double[][] bare = new double[2][rounds];
        double[][] match = new double[2][rounds];
        int turns = longGame.create(0).players() > 0 ? turns() : 0;
        for (int warm = effort == Effort.QUICK ? 1 : 15; warm > 0; warm--) {
            about.accept("warming up");
            match(new double[2][1], 0);
        }
        for (int round = 0; round < rounds; round++) {
            about.accept("bare pipes");
            bare(bare, round, turns);
            about.accept("match");
            match(match, round);
        }
        for (int k = 0; k < 2; k++) {
            String clock = k == 0 ? "wall clock" : "CPU time of the asking thread";
            double one = Meter.median(bare[k]);
            double other = Meter.median(match[k]);
            rows.accept(new Row(name(), "bare pipes, " + clock, "turns", NANOS / one, 1, Double.NaN, ""));
            rows.accept(new Row(name(), "match, " + clock, "turns", NANOS / other, one / other, Double.NaN,
                String.format(Locale.ROOT, "%.2f times the bare pipes", other / one)));
        }
        starts(effort, about, rows);
    }

    private int turns() throws InterruptedException {
        int[] turns = new int[1];
        play(longGame, kit.responder(), new MatchListener() {
            @Override
            public void played(Turn turn) {
                turns[0] = turn.number();
            }
        });
        return turns[0] - WARM_TURNS;
    }

    private void bare(double[][] into, int round, int turns) throws IOException {
        byte[] frame = new byte[FRAME_BYTES];
        Arrays.fill(frame, (byte) 'x');
        frame[FRAME_BYTES - 1] = '\n';
        Meter meter = new Meter();
        try (PipeRoundTrip one = new PipeRoundTrip(kit.responder());
                PipeRoundTrip other = new PipeRoundTrip(kit.responder())) {
            exchange(one, other, frame, WARM_TURNS);
            long wall = System.nanoTime();
            long cpu = meter.cpu(false);
            exchange(one, other, frame, turns);
            into[1][round] = (double) (meter.cpu(false) - cpu) / turns;
            into[0][round] = (double) (System.nanoTime() - wall) / turns;
        }
    }

    private static void exchange(PipeRoundTrip one, PipeRoundTrip other, byte[] frame, int turns) throws IOException {
        for (int turn = 0; turn < turns; turn++) {
            one.exchange(frame, frame.length);
            other.exchange(frame, frame.length);
        }
    }

    private void match(double[][] into, int round) throws InterruptedException {
        Clock clock = new Clock();
        play(longGame, kit.responder(), clock);
        into[0][round] = (double) (clock.wall - clock.firstWall) / (clock.turn - WARM_TURNS);
        into[1][round] = (double) (clock.cpu - clock.firstCpu) / (clock.turn - WARM_TURNS);
    }

    /** Looks at the clocks after every turn, on the thread that plays. */
    private static final class Clock implements MatchListener {

        private final Meter meter = new Meter();
        private long firstWall;
        private long firstCpu;
        private long wall;
        private long cpu;
        private int turn;

        @Override
        public void played(Turn played) {
            turn = played.number();
            if (turn == WARM_TURNS) {
                firstCpu = meter.cpu(false);
                firstWall = System.nanoTime();
            }
        }

        @Override
        public void end(steward.match.MatchResult result) {
            wall = System.nanoTime();
            cpu = meter.cpu(false);
        }
    }

    private static void play(GameSetup setup, List<String> command, MatchListener listener)
            throws InterruptedException {
        List<Seat> seats = new ArrayList<>();
        for (int player = 0; player < setup.scene().players(); player++) {
            seats.add(new Seat(new BotProcess("bot-" + player, command), Protocol.JSON));
        }
        if (Referee.of(setup, 1, seats, TimeControl.UNLIMITED, listener).play().anyFault()) {
            throw new IllegalStateException("a bot failed that only answers");
        }
    }

    private void starts(Effort effort, Consumer<String> about, Consumer<Row> rows) throws Exception {
        int rounds = effort == Effort.QUICK ? 10 : 100;
        double[] bare = new double[rounds];
        double[] match = new double[rounds];
        byte[] line = {'\n'};
        MatchListener nobody = new MatchListener() { };
        for (int round = -rounds / 2; round < rounds; round++) {
            about.accept("starts");
            long start = System.nanoTime();
            try (PipeRoundTrip one = new PipeRoundTrip(shell); PipeRoundTrip other = new PipeRoundTrip(shell)) {
                one.exchange(line, 1);
                other.exchange(line, 1);
            }
            long between = System.nanoTime();
            play(oneTurn, shell, nobody);
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
