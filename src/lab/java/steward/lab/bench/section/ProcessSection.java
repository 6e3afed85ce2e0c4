package steward.lab.bench.section;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import steward.bot.hold.HoldPolicy;
import steward.bot.isolation.HoldMeans;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.SandboxLevel;
import steward.bot.isolation.SandboxSupport;
import steward.bot.process.BotProcess;
import steward.game.GameSetup;
import steward.lab.bench.Comparison;
import steward.lab.bench.Contender;
import steward.lab.bench.Effort;
import steward.lab.bench.Row;
import steward.lab.bench.Section;
import steward.lab.timing.Stretch;
import steward.lab.timing.TimedPlace;
import steward.lab.timing.TimingEffort;
import steward.lab.timing.WorkClock;
import steward.match.MatchListener;
import steward.match.Protocol;
import steward.match.Referee;
import steward.match.Seat;
import steward.match.TimeControl;
import steward.match.Turn;

/**
 * Bench section on bot processes: turns, compared with bare pipes to the same programs, and the cost of a match before
 * its turns. It also has the price of each isolation level, and of each policy of holding at this machine's usual
 * level.
 *
 * @param longGame  a scene in which bots that never reach a checkpoint play many turns
 * @param longTurns how many turns
 * @param oneTurn   a scene that is over after one turn
 * @param shell     a program that starts at once and answers every line with a valid one
 */
public record ProcessSection(MatchFixture fixture, GameSetup longGame, int longTurns, GameSetup oneTurn,
                             List<String> shell) implements Section {

    /** Rounds in which programs are started. */
    private static final int STARTS = 100;
    /** Rounds in which JVMs are started. */
    private static final int JVM_STARTS = 50;
    /** Turns of a round in which bots only answer. */
    private static final int TURNS = 500;
    /** Turns before a long game is timed. */
    private static final int WARM_TURNS = 200;
    /** The length of a turn frame of the official scene. */
    private static final int FRAME_BYTES = 480;
    private static final byte[] LINE = {'\n'};

    @Override
    public String name() {
        return "processes";
    }

    @Override
    public String about() {
        return "First, by the wall clock, turns of a match between two bot processes that answer at once. Against them"
            + " stand two bare pipes to the same program, asked in sequence with as many bytes. The same follows by"
            + " the CPU time of the asking thread alone. Then come whole matches of a single turn between two shells."
            + " Against them the same shells are started, asked one after the other and ended without a referee. Then"
            + " comes a bot's start up to its first answer at each level of the sandbox, and a turn after that. Last"
            + " is a turn of two bots by `--hold`: waiting bots are never stopped, those that compute (burners) are,"
            + " or all are.";
    }

    @Override
    public int steps(Effort effort) {
        return 2 * effort.timing().steps(2) + 3 * effort.rounds(STARTS).steps(3) + effort.rounds(JVM_STARTS).steps(3);
    }

    @Override
    public void run(Effort effort, Runnable step, Consumer<Row> rows) throws Exception {
        byte[] frame = new byte[FRAME_BYTES];
        Arrays.fill(frame, (byte) 'x');
        frame[FRAME_BYTES - 1] = '\n';
        for (WorkClock clock : List.of(WorkClock.WALL, WorkClock.THREAD)) {
            String by = clock == WorkClock.WALL ? ", wall clock" : ", CPU time of the asking thread";
            compare("turns", effort.timing(), step, rows, List.of(
                new Contender("bare pipes" + by, least -> bare(clock, frame)),
                new Contender("match" + by, least -> match(clock))));
        }
        TimingEffort starts = effort.rounds(STARTS);
        compare("matches", starts, step, rows, List.of(
            new Contender("two shells, started and ended", least -> twoShells()),
            new Contender("a match of one turn between them", least -> matchOfOneTurn())));
        List<SandboxLevel> levels = Stream.of(SandboxLevel.values())
            .filter(level -> SandboxSupport.problem(level) == null).toList();
        compare("starts", starts, step, rows, contenders(levels, level -> "start of a bot, sandbox " + level.word(),
            level -> new BotTurns(shell, Isolation.at(level), 1, LINE, 0)));
        compare("turns", starts, step, rows, contenders(levels, level -> "turn of a bot, sandbox " + level.word(),
            level -> new BotTurns(shell, Isolation.at(level), 1, LINE, TURNS)));
        if (HoldMeans.of(Isolation.usual()) == HoldMeans.INIT) {
            compare("turns", effort.rounds(JVM_STARTS), step, rows, contenders(List.of(HoldPolicy.NEVER,
                HoldPolicy.BURNERS, HoldPolicy.ALWAYS), policy -> "a turn, --hold " + policy.word(), policy ->
                new BotTurns(fixture.responder(), Isolation.usual().holding(policy), 2, frame, TURNS)));
        }
    }

    private static <T> List<Contender> contenders(List<T> values, Function<T, String> name,
                                                  Function<T, TimedPlace> place) {
        return values.stream().map(value -> new Contender(name.apply(value), place.apply(value))).toList();
    }

    private void compare(String unit, TimingEffort effort, Runnable step, Consumer<Row> rows,
                         List<Contender> contenders) throws Exception {
        new Comparison(name(), unit, contenders, Comparison::paired).run(effort, step, rows);
    }

    private Stretch bare(WorkClock clock, byte... frame) throws IOException {
        try (PipeRoundTrip one = new PipeRoundTrip(fixture.responder());
                PipeRoundTrip other = new PipeRoundTrip(fixture.responder())) {
            long start = 0;
            for (int turn = 0; turn < longTurns; turn++) {
                start = turn == WARM_TURNS ? clock.nanos() : start;
                one.exchange(frame);
                other.exchange(frame);
            }
            return turns(start, clock.nanos());
        }
    }

    private Stretch turns(long start, long end) {
        return new Stretch((end - start) / (double) (longTurns - WARM_TURNS), Double.NaN);
    }

    private Stretch match(WorkClock clock) throws InterruptedException {
        long[] ends = new long[2];
        play(longGame, fixture.responder(), new MatchListener() {
            @Override
            public void played(Turn turn) {
                if (turn.number() == WARM_TURNS || turn.number() == longTurns) {
                    ends[turn.number() / longTurns] = clock.nanos();
                }
            }
        });
        return turns(ends[0], ends[1]);
    }

    private static void play(GameSetup setup, List<String> command, MatchListener listener)
            throws InterruptedException {
        List<Seat> seats = IntStream.range(0, setup.scene().players()).mapToObj(player ->
            new Seat(new BotProcess("bot-" + player, command), Protocol.JSON)).toList();
        if (Referee.of(setup, 1, seats, TimeControl.UNLIMITED, listener).play().anyFault()) {
            throw new IllegalStateException("a bot failed that only answers");
        }
    }

    private Stretch twoShells() throws IOException {
        long start = System.nanoTime();
        try (PipeRoundTrip one = new PipeRoundTrip(shell)) {
            one.exchange(LINE);
            try (PipeRoundTrip other = new PipeRoundTrip(shell)) {
                other.exchange(LINE);
            }
        }
        return new Stretch(System.nanoTime() - start, Double.NaN);
    }

    private Stretch matchOfOneTurn() throws InterruptedException {
        long start = System.nanoTime();
        play(oneTurn, shell, new MatchListener() { });
        return new Stretch(System.nanoTime() - start, Double.NaN);
    }
}
