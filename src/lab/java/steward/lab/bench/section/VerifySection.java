package steward.lab.bench.section;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.stream.Stream;
import steward.files.Folders;
import steward.lab.bench.Comparison;
import steward.lab.bench.Contender;
import steward.lab.bench.Effort;
import steward.lab.bench.Row;
import steward.lab.bench.Section;
import steward.lab.timing.WorkClock;
import steward.replay.RecordedMatch;
import steward.replay.RecordedTurn;
import steward.replay.ReplayReader;
import steward.replay.ReplayWriter;
import steward.replay.verify.Resimulation;
import steward.replay.verify.Verification;
import tools.jackson.databind.json.JsonMapper;

/** Bench section on verification: recorded matches, played again and compared. */
public record VerifySection(MatchFixture fixture) implements Section {

    private static final int MATCHES = 50;
    private static final double NANOS_PER_MICRO = 1e3;

    @Override
    public String name() {
        return "verify";
    }

    @Override
    public String about() {
        return "Recorded matches of official length, by CPU time. The textbook way begins by reading them whole into"
            + " trees of JSON; its row does that and no more. The other rows verify them from their files, and play"
            + " them again when their turns are in memory.";
    }

    @Override
    public int steps(Effort effort) {
        return effort.timing().steps(3);
    }

    @Override
    public void run(Effort effort, Runnable step, Consumer<Row> rows) throws Exception {
        Path folder = Files.createTempDirectory("steward-bench");
        try {
            List<Path> files = new ArrayList<>();
            List<RecordedMatch> decoded = new ArrayList<>();
            long bytes = 0;
            for (int seed = 0; seed < MATCHES; seed++) {
                byte[] replay = record(seed);
                bytes += replay.length;
                files.add(Files.write(folder.resolve(seed + ".jsonl"), replay));
                decoded.add(RecordedMatch.read(new ReplayReader(new ByteArrayInputStream(replay), "replay")));
            }
            double mean = (double) bytes / MATCHES;
            int[] next = new int[3];
            new Comparison(name(), "matches", List.of(
                Contender.of("textbook: read into trees", WorkClock.THREAD,
                    () -> read(files.get(next[0]++ % MATCHES))),
                Contender.of("verified from files", WorkClock.THREAD, () -> verify(files.get(next[1]++ % MATCHES))),
                Contender.of("played again from memory", WorkClock.THREAD,
                    () -> again(decoded.get(next[2]++ % MATCHES)))),
                (samples, k) -> k == 2 ? "" : String.format(Locale.ROOT, "%.0f MB/s",
                    mean / samples.median(k) * NANOS_PER_MICRO))
                .run(effort.timing(), step, rows);
        } finally {
            Folders.delete(folder);
        }
    }

    private byte[] record(int seed) {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        MatchSection.match(fixture, MatchSection.direct(fixture), seed,
            new ReplayWriter(file, MatchSection.header(fixture, seed)));
        return file.toByteArray();
    }

    private static long read(Path file) throws Exception {
        try (Stream<String> lines = Files.lines(file, StandardCharsets.UTF_8)) {
            long objects = lines.map(JsonMapper.shared()::readTree).filter(tree -> tree.isObject()).count();
            return objects > 0 ? 1 : 0;
        }
    }

    private long verify(Path file) throws Exception {
        try (ReplayReader replay = ReplayReader.open(file)) {
            Verification verification = Verification.of(replay, fixture.types());
            if (!verification.verified()) {
                throw new IllegalStateException("a fresh recording differs: " + verification.difference());
            }
            return 1;
        }
    }

    private long again(RecordedMatch match) {
        Resimulation again = new Resimulation(match.header(), null, fixture.types(), match.source());
        for (RecordedTurn turn : match.turns()) {
            if (again.play(turn) != null) {
                throw new IllegalStateException("a fresh recording cannot be played again");
            }
        }
        if (!again.game().isOver()) {
            throw new IllegalStateException("a fresh recording ends otherwise");
        }
        return 1;
    }
}
