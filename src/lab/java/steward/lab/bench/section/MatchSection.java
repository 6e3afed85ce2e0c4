package steward.lab.bench.section;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import steward.bot.Bot;
import steward.bot.InProcessPlayer;
import steward.lab.bench.Comparison;
import steward.lab.bench.Contender;
import steward.lab.bench.Effort;
import steward.lab.bench.Row;
import steward.lab.bench.Section;
import steward.lab.timing.WorkClock;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.match.Referee;
import steward.match.Seat;
import steward.match.TimeControl;
import steward.replay.ReplayHeader;
import steward.replay.ReplayWriter;
import steward.replay.WriteBehind;

/** Bench section on whole matches between bots inside this JVM. */
public final class MatchSection implements Section {

    private static final MatchListener NO_LISTENER = new MatchListener() { };
    /** Number of different matches that are played in rotation. */
    private static final int SEEDS = 50;

    private final MatchFixture fixture;
    private long next;

    public MatchSection(MatchFixture fixture) {
        this.fixture = fixture;
    }

    @Override
    public String name() {
        return "matches";
    }

    @Override
    public String about() {
        return "Whole matches on the official scene between two bots inside the JVM, by CPU time of the whole JVM."
            + " Replays go to a file, or are written and thrown away. \"Lines\": bots read and write lines of JSON."
            + " \"Direct\": bots look at the game itself. \"The bots alone\" read the lines of matches that were"
            + " played before.";
    }

    @Override
    public int steps(Effort effort) {
        return effort.timing().steps(6);
    }

    @Override
    public void run(Effort effort, Runnable step, Consumer<Row> rows) throws Exception {
        Path file = Files.createTempFile("steward-bench", ".jsonl");
        List<Told> told = told();
        double turns = LongStream.range(0, SEEDS).mapToInt(seed ->
                match(fixture, direct(fixture), seed, NO_LISTENER).turns())
            .average().orElseThrow();
        try {
            new Comparison(name(), "matches", List.of(
                Contender.of("lines, with replay", WorkClock.JVM, () -> playIntoFile(this::lines, file)),
                Contender.of("lines", WorkClock.JVM, () -> play(lines(), NO_LISTENER)),
                Contender.of("lines, the bots alone", WorkClock.JVM, () -> answer(told)),
                Contender.of("direct, with replay", WorkClock.JVM, () -> playIntoFile(() -> direct(fixture), file)),
                Contender.of("direct, with replay, no file", WorkClock.JVM, () -> play(direct(fixture),
                    new ReplayWriter(OutputStream.nullOutputStream(), header(fixture, next % SEEDS)))),
                Contender.of("direct", WorkClock.JVM, () -> play(direct(fixture), NO_LISTENER))),
                (samples, k) -> String.format(Locale.ROOT, "%.0f ns and %.0f bytes a turn, %.0f turns a match",
                    samples.median(k) / turns, samples.bytes(k) / turns, turns))
                .run(effort.timing(), step, rows);
        } finally {
            Files.deleteIfExists(file);
        }
    }

    private long play(List<Seat> seats, MatchListener listener) {
        match(fixture, seats, next++ % SEEDS, listener);
        return 1;
    }

    private long playIntoFile(Supplier<List<Seat>> seats, Path file) throws IOException {
        try (OutputStream out = new WriteBehind(Files.newOutputStream(file))) {
            return play(seats.get(), new ReplayWriter(out, header(fixture, next % SEEDS)));
        }
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
            match(fixture, seats, seed, NO_LISTENER);
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

    private List<Seat> lines() {
        return names(fixture).stream()
            .map(name -> new Seat(new InProcessPlayer(name, fixture.lines().get()), Protocol.JSON)).toList();
    }

    private static List<String> names(MatchFixture fixture) {
        return IntStream.range(0, fixture.setup().scene().players()).mapToObj(player -> "bot-" + player).toList();
    }

    static ReplayHeader header(MatchFixture fixture, long seed) {
        List<String> names = names(fixture);
        return new ReplayHeader(fixture.setup().scene().gameId(), fixture.setup().scene().json(), seed, names, names,
            Double.POSITIVE_INFINITY).ofLaw(fixture.setup().plan().lawVersion());
    }

    static List<Seat> direct(MatchFixture fixture) {
        return names(fixture).stream().map(name -> Seat.direct(name, fixture.direct().get())).toList();
    }

    static MatchResult match(MatchFixture fixture, List<Seat> seats, long seed, MatchListener listener) {
        try {
            return Referee.of(fixture.setup(), seed, seats, TimeControl.UNLIMITED, listener).play();
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted", interrupted);
        }
    }
}
