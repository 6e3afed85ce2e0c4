package steward.contest;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.bot.TimeSpent;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.SandboxLevel;
import steward.game.GameTypes;
import steward.match.Turn;
import steward.replay.JsonLine;
import steward.replay.RecordedTurn;
import steward.replay.ReplayException;
import steward.replay.ReplayReader;
import steward.scene.SceneReader;
import steward.scene.json.SceneException;

/** Failures of bots read from the replay of their match, with the same stderr lines and hints as when it was played. */
public final class RecordedFailures {

    private static final Pattern LATE = Pattern.compile("within ([0-9]{1,9}) ms .*waited ([0-9]{1,9}) for a processor");

    private final GameLog log;

    /** @param replay with a header; its turns are added one by one */
    public RecordedFailures(GameTypes types, ReplayReader replay) {
        BooleanSupplier both = () -> {
            try {
                return Contest.hasText(types.open(SceneReader.read(replay.header().scene(), replay.source())));
            } catch (SceneException unknown) {
                return false;
            }
        };
        log = new GameLog(replay.header().protocols(), List.of(), both, () -> isolation(replay.headerLine()));
    }

    /** Returns those of a file; none if it is {@code null}, or cannot be read as a replay. */
    public static List<Failure> of(GameTypes types, Path replay) {
        if (replay == null || !Files.isRegularFile(replay)) {
            return List.of();
        }
        try (ReplayReader reader = ReplayReader.open(replay)) {
            return reader.header() == null ? List.of() : of(types, reader);
        } catch (IOException | ReplayException damaged) {
            return List.of();
        }
    }

    /** The rest of a replay. */
    public static List<Failure> of(GameTypes types, ReplayReader replay) {
        RecordedFailures failures = new RecordedFailures(types, replay);
        for (RecordedTurn turn = replay.next(); turn != null; turn = replay.next()) {
            failures.add(turn);
        }
        if (replay.result() != null) {
            String[] faults = replay.result().textsOf("players", "fault");
            for (int player = 0; player < Math.min(faults.length, replay.header().protocols().size()); player++) {
                failures.log.thrownOut(player, faults[player]);
            }
        }
        return failures.failures();
    }

    public void add(RecordedTurn recorded) {
        Turn turn = Turn.of(recorded.number(), recorded.faults().length);
        for (int player = 0; player < turn.players(); player++) {
            recorded.tell(turn, player);
            if (turn.fault(player) != null) {
                turn.late(player, starved(recorded.faults()[player]));
            }
        }
        log.note(turn);
    }

    /** In the order in which they happened. */
    public List<Failure> failures() {
        return log.failures();
    }

    /** As much of it as says whether the machine was starved, or {@code null}. */
    private static TimeSpent starved(String fault) {
        Matcher late = LATE.matcher(fault);
        return !late.find() ? null : new TimeSpent(nanos(late.group(1)), nanos(late.group(1)), 0, 0,
            nanos(late.group(2)), 0, 0, TimeSpent.Shows.ALL, false);
    }

    private static long nanos(String ms) {
        return TimeUnit.MILLISECONDS.toNanos(Long.parseLong(ms));
    }

    /** The usual one at the level that is recorded, or {@code null}. */
    private static Isolation isolation(JsonLine header) {
        JsonLine times = header.has("times") ? new JsonLine(header.where() + ": times", header.object("times")) : null;
        String word = times == null || !times.has("sandbox") ? "" : times.text("sandbox");
        return Arrays.stream(SandboxLevel.values()).filter(level -> level.word().equals(word)).findFirst()
            .map(Isolation::at).orElse(null);
    }
}
