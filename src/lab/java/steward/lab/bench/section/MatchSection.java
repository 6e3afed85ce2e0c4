package steward.lab.bench.section;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import steward.bot.Bot;
import steward.bot.InProcessPlayer;
import steward.lab.bench.Contender;
import steward.lab.bench.Effort;
import steward.lab.bench.Meter;
import steward.lab.bench.Row;
import steward.lab.bench.Section;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.match.Referee;
import steward.match.Seat;
import steward.match.TimeControl;
import steward.replay.ReplayHeader;
import steward.replay.ReplayWriter;
import steward.replay.WriteBehind;

/** Bench section on whole matches between bots inside this JVM, and on those matches on several threads. */
final class MatchSection implements Section {

    private static final MatchListener NO_LISTENER = new MatchListener() { };
    private static final double NANOS = 1e9;

    private final MatchFixture fixture;
    private final int threads;
    private final int games;

    MatchSection(MatchFixture fixture, int threads, int games) {
        this.fixture = fixture;
        this.threads = threads;
        this.games = games;
    }

    @Override
    public String name() {
        return "matches";
    }

    @Override
    public String about() {
        return "Whole matches on the official scene between two bots inside the JVM, by CPU time of the whole JVM;"
            + " replays go to a file, or are written and thrown away. Bots either read and write lines of JSON, or look"
            + " at the game itself; the bots alone read the lines of matches that were played before. Then " + games
            + " matches on several threads, by the wall clock.";
    }

    @Override
    public int steps(Effort effort) {
        return 6 * (1 + effort.rounds()) + 32 - Integer.numberOfLeadingZeros(threads);
    }

    @Override
    public void run(Effort effort, Consumer<String> about, Consumer<Row> rows) throws Exception {
        Path file = Files.createTempFile("steward-bench", ".jsonl");
        List<Told> told = told();
        try {
            List<Contender> contenders = List.of(
                new Contender("lines, with replay", true, () -> play(this::lines, file)),
                new Contender("lines", true, () -> play(this::lines, null)),
                new Contender("lines, the bots alone", true, () -> answer(told)),
                new Contender("direct, with replay", true, () -> play(this::direct, file)),
                new Contender("direct, with replay, no file", true, this::playIntoNothing),
                new Contender("direct", true, () -> play(this::direct, null)));
            new Meter().compare(name(), "matches", contenders, effort, about, row -> rows.accept(withTurns(row)));
        } finally {
            Files.deleteIfExists(file);
        }
        parallel(about, rows);
    }

    private Row withTurns(Row row) {
        return new Row(row.section(), row.name(), row.unit(), row.perSecond(), row.ratio(), row.bytes(),
            Math.round(row.nanos() / meanTurns()) + " ns and " + Math.round(row.bytes() / meanTurns())
                + " bytes a turn, " + Math.round(meanTurns()) + " turns a match"
                + (row.note().isEmpty() ? "" : ", " + row.note()));
    }

    private double meanTurns;

    private double meanTurns() {
        if (meanTurns == 0) {
            meanTurns = (double) IntStream.range(0, SEEDS).map(seed -> match(direct(), seed, NO_LISTENER).turns()).sum()
                / SEEDS;
        }
        return meanTurns;
    }

    /** How many different matches are played in rotation. */
    private static final int SEEDS = 50;

    private long next;

    private long play(Supplier<List<Seat>> seats, Path file) throws IOException {
        long seed = next++ % SEEDS;
        if (file == null) {
            match(seats.get(), seed, NO_LISTENER);
            return 1;
        }
        try (OutputStream out = new WriteBehind(Files.newOutputStream(file))) {
            match(seats.get(), seed, new ReplayWriter(out, header(fixture, seed)));
        }
        return 1;
    }

    private long playIntoNothing() {
        long seed = next++ % SEEDS;
        match(direct(), seed, new ReplayWriter(OutputStream.nullOutputStream(), header(fixture, seed)));
        return 1;
    }

    /** A bot that keeps the lines that it is told, and asks another for the answers. */
    private record Told(Bot bot, List<String> lines) implements Bot {

        @Override
        public void setup(String line) {
            lines.add(line);
            bot.setup(line);
        }

        @Override
        public String turn(String line) {
            lines.add(line);
            return bot.turn(line);
        }
    }

    /** Bots that were told the lines of every match, two after the other for each. */
    private List<Told> told() {
        List<Told> told = new ArrayList<>();
        for (int seed = 0; seed < SEEDS; seed++) {
            List<Seat> seats = names(fixture).stream().map(name -> {
                told.add(new Told(fixture.lines().get(), new ArrayList<>()));
                return new Seat(new InProcessPlayer(name, told.get(told.size() - 1)), Protocol.JSON);
            }).toList();
            match(seats, seed, NO_LISTENER);
        }
        return told;
    }

    /** Lets the bots of the next match alone answer what they were told in it. */
    private long answer(List<Told> told) {
        int players = fixture.setup().scene().players();
        int match = (int) (next++ % SEEDS);
        for (Told each : told.subList(players * match, players * (match + 1))) {
            Bot bot = fixture.lines().get();
            bot.setup(each.lines().get(0));
            for (String line : each.lines().subList(1, each.lines().size())) {
                bot.turn(line);
            }
        }
        return 1;
    }

    static ReplayHeader header(MatchFixture fixture, long seed) {
        List<String> names = names(fixture);
        return new ReplayHeader(fixture.setup().scene().gameId(), fixture.setup().scene().json(), seed, names, names,
            Double.POSITIVE_INFINITY).ofLaw(fixture.setup().plan().lawVersion());
    }

    private static List<String> names(MatchFixture fixture) {
        return IntStream.range(0, fixture.setup().scene().players()).mapToObj(player -> "bot-" + player).toList();
    }

    private List<Seat> direct() {
        return direct(fixture);
    }

    static List<Seat> direct(MatchFixture fixture) {
        return names(fixture).stream().map(name -> Seat.direct(name, fixture.direct().get())).toList();
    }

    private List<Seat> lines() {
        return names(fixture).stream()
            .map(name -> new Seat(new InProcessPlayer(name, fixture.lines().get()), Protocol.JSON)).toList();
    }

    private MatchResult match(List<Seat> seats, long seed, MatchListener listener) {
        return match(fixture, seats, seed, listener);
    }

    static MatchResult match(MatchFixture fixture, List<Seat> seats, long seed, MatchListener listener) {
        try {
            return Referee.of(fixture.setup(), seed, seats, TimeControl.UNLIMITED, listener).play();
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted", interrupted);
        }
    }

    private void parallel(Consumer<String> about, Consumer<Row> rows) throws InterruptedException {
        double one = 0;
        long results = 0;
        for (int count = 1; count <= threads; count *= 2) {
            about.accept(count + " threads");
            long start = System.nanoTime();
            long hash = ParallelMatches.play(fixture, games, count);
            double speed = games * NANOS / (System.nanoTime() - start);
            if (count == 1) {
                one = speed;
                results = hash;
            } else if (hash != results) {
                throw new IllegalStateException("the results of " + games + " matches depend on the number of threads");
            }
            rows.accept(new Row(name(), "direct, " + count + (count == 1 ? " thread" : " threads"), "matches", speed,
                speed / one, Double.NaN, "by the wall clock; results the same"));
        }
    }
}
