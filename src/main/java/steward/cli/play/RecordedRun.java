package steward.cli.play;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import steward.bot.TimeSpent;
import steward.cli.options.TimeLimitOptions;
import steward.cli.replay.RecordedResult;
import steward.cli.replay.ReplayCommand;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Games;
import steward.cli.shared.PlayerChoice;
import steward.cli.shared.Verbosity;
import steward.cli.streams.Json;
import steward.cli.streams.ProgressLine;
import steward.cli.streams.Streams;
import steward.contest.Contest;
import steward.contest.Contest.Entrant;
import steward.contest.WorkerThreads;
import steward.files.InputException;
import steward.files.Remedied;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.guest.GuestType;
import steward.match.GuestSetup;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.match.Seat;
import steward.replay.RecordedMatch;
import steward.replay.ReplayException;
import steward.replay.ReplayReader;
import steward.replay.feed.Rematch;
import steward.report.Fields;
import steward.scene.json.SceneException;
import steward.text.TextFormat;

/**
 * Recorded games played again with a bot in the place of a player, and the table of what became of each.
 *
 * @param bot     as it is written in the call, and its folder
 * @param usual   what a bot without a prefix speaks, but to referees of their own
 * @param as      the player in whose place it plays, as it was typed
 * @param types   for playing: whether the referees that replays name are run
 * @param contest how a bot is seated in a scene
 * @param strict  whether a failure of the bot makes the exit status 1
 */
record RecordedRun(Streams streams, String bot, Path folder, Protocol usual, String as, GameTypes types,
                   Seating contest, TimeLimitOptions pace, Verbosity report, boolean strict) {

    private static final List<String> REPLAYS = List.of(".jsonl", ".jsonl.gz");
    private static final String OPTION = "--as";
    /** As in series: a game that the bot lost because others used the processors is played again. */
    private static final int MOST_ATTEMPTS = 3;

    /** Makes a contest of a scene in which the bot alone is started. */
    @FunctionalInterface
    interface Seating {
        Contest of(GameSetup setup);
    }

    /**
     * Game of the table, with what became of it.
     *
     * @param name     of its file
     * @param then     result of the recording, or {@code null}
     * @param seat     of the player in whose place the bot plays
     * @param outcome  {@code null} where it could not be played
     * @param problem  then, why not
     */
    private record Row(String name, MatchResult then, int seat, Rematch.Outcome outcome, String problem) {

        private MatchResult now() {
            return outcome == null ? null : outcome.result();
        }

        /** Points of the player in the recording; {@code null} without a result or others. */
        Double recorded() {
            return points(then, seat);
        }

        /** Points of the bot; {@code null} without a result or others. */
        Double points() {
            return points(now(), seat);
        }

        /** Score of a player without others, of the bot or in the recording; {@code null} without a result. */
        Double score(boolean inRecording) {
            MatchResult result = inRecording ? then : now();
            return result == null || result.players().size() > 1 ? null : (Double) result.players().get(0).score();
        }

        /** 1 for a win, 1/2 for a draw. */
        private static Double points(MatchResult result, int seat) {
            if (result == null || result.players().size() < 2) {
                return null;
            }
            int rank = result.players().get(seat).rank();
            boolean shared = result.players().stream().filter(player -> player.rank() == rank).count() > 1;
            return rank > 0 ? 0 : shared ? 0.5 : 1;
        }

        Fields fields() {
            Fields fields = Fields.of("replay", name);
            return (outcome == null ? fields.with("outcome", "notPlayed", "reason", problem)
                : fields.with("outcome", outcome.ending(), "turn", outcome.turn(), "reason", outcome.reason()))
                .with("points", Fields.decimal(points()), "recorded", Fields.decimal(recorded()),
                    "score", Fields.decimal(score(false)), "recordedScore", Fields.decimal(score(true)));
        }

        boolean is(Rematch.Ending ending) {
            return outcome != null && outcome.ending() == ending;
        }

        String text() {
            return outcome == null ? "not played: " + problem : switch (outcome.ending()) {
                case UNCHANGED -> "unchanged to the end" + (points() != null ? ": " + word(points())
                    + (recorded() == null || recorded().equals(points()) ? "" : ", recorded " + word(recorded()))
                    : score(false) == null ? "" : ": score " + TextFormat.number(score(false), 2)
                    + (score(true) == null ? "" : ", recorded " + TextFormat.number(score(true), 2)));
                case DEPARTED -> "departed at turn " + outcome.turn() + ": " + outcome.reason();
                case FAILED -> "failed in turn " + outcome.turn() + ": " + outcome.reason();
            };
        }

        private static String word(double points) {
            return points == 1 ? "won" : points == 0 ? "lost" : "drawn";
        }
    }

    /** Plays all games of a folder, or the one of a file. */
    int play(Path games, int threads) throws InterruptedException {
        List<Path> files = files(games);
        boolean isOne = !Files.isDirectory(games);
        String name = entrant(usual).name();
        Row[] rows = new Row[files.size()];
        AtomicInteger next = new AtomicInteger();
        try (ProgressLine progress = report == Verbosity.FULL
                ? ProgressLine.watched(streams, "games", files.size()) : null) {
            WorkerThreads.run("games", Math.min(threads, files.size()), thread -> () -> {
                for (int k = next.getAndIncrement(); k < rows.length; k = next.getAndIncrement()) {
                    rows[k] = row(files.get(k), isOne);
                    if (progress != null) {
                        progress.step();
                    }
                }
                return null;
            });
        } finally {
            GuestType.endIdle();
        }
        tell(name, List.of(rows));
        boolean all = Arrays.stream(rows).allMatch(row -> row.outcome != null);
        boolean failed = Arrays.stream(rows).anyMatch(row -> row.is(Rematch.Ending.FAILED));
        return all && !(strict && failed) ? ExitStatus.DONE : ExitStatus.FAILED;
    }

    private Entrant entrant(Protocol protocol) {
        Entrant entrant = Contest.entrant(bot, folder, null, protocol);
        if (entrant.problem() != null) {
            throw new InputException(entrant.problem());
        }
        return entrant;
    }

    private static List<Path> files(Path games) {
        if (!Files.isDirectory(games)) {
            return List.of(games);
        }
        try (Stream<Path> found = Files.list(games)) {
            List<Path> files = found.filter(file -> REPLAYS.stream().anyMatch(file.toString()::endsWith)).sorted()
                .toList();
            if (files.isEmpty()) {
                throw new InputException("--recorded: found no file " + games.resolve("*" + REPLAYS.get(0))
                    + ", expected replays");
            }
            return files;
        } catch (IOException problem) {
            throw new InputException("--recorded: " + games + " cannot be read: " + problem.getMessage());
        }
    }

    /** @param isOne whether the call names the file, not a folder */
    private Row row(Path file, boolean isOne) throws InterruptedException {
        String name = file.getFileName().toString();
        RecordedMatch match;
        MatchResult then;
        try (ReplayReader replay = ReplayCommand.open(file)) {
            match = RecordedMatch.read(replay);
            then = RecordedResult.of(replay, match.header().names());
        } catch (ReplayException | InputException | UncheckedIOException problem) {
            if (isOne && problem instanceof InputException) {
                throw problem;                       // the call names it
            }
            return new Row(name, null, 0, null, problem.getMessage());
        }
        try {
            int seat = PlayerChoice.of(OPTION, as, match.header().names(), name);
            Rematch.Outcome outcome = outcome(match, seat);
            for (int attempt = 1; isStarved(outcome) && attempt < MOST_ATTEMPTS; attempt++) {
                outcome = outcome(match, seat);
            }
            return isStarved(outcome) ? new Row(name, then, seat, null, outcome.reason())
                : new Row(name, then, seat, outcome, null);
        } catch (ReplayException | SceneException | InputException | UncheckedIOException problem) {
            if (problem instanceof Remedied remedied && !remedied.remedies().isEmpty()) {
                throw problem;                       // an option of the call is missing, for all games of its kind
            }
            return new Row(name, then, seat(match), null, problem.getMessage());
        }
    }

    /** True if the bot was late because others used the processors. */
    private static boolean isStarved(Rematch.Outcome outcome) {
        return outcome.ending() == Rematch.Ending.FAILED && outcome.reason().contains(TimeSpent.NOT_ITS_FAULT);
    }

    private Rematch.Outcome outcome(RecordedMatch match, int seat) throws InterruptedException {
        Rematch rematch = new Rematch(match, types, Games.types(false), seat);
        Contest seated = contest.of(rematch.setup()).between(List.of(entrant(rematch.setup().isGuest()
            ? Protocol.CODINGAME : usual)));
        Contest.checkPlayable(seated.setup(), seated.entrants());
        seated = pace.limit(seated);
        Entrant entrant = seated.entrants().get(0);
        GameSetup isolated = seated.setup();
        return rematch.play(new Seat(seated.player(entrant), entrant.protocol(),
            seated.limits(List.of(entrant)).get(0)), seated.time(),
            setup -> setup instanceof GuestSetup ? isolated : setup);
    }

    private int seat(RecordedMatch match) {
        return Math.max(0, match.header().names().indexOf(as));
    }

    private void tell(String name, List<Row> rows) {
        if (report == Verbosity.JSON) {
            Fields fields = Fields.of("bot", name, "as", as);
            for (Rematch.Ending ending : Rematch.Ending.values()) {
                fields.with(ending.name().toLowerCase(Locale.ROOT), of(rows, ending).size());
            }
            Json.print(streams, fields.with("notPlayed", rows.stream().filter(row -> row.outcome == null).count(),
                "games", Fields.each(rows, Row::fields)));
            return;
        }
        streams.out().println(TextFormat.plain(TextFormat.count(rows.size(), "recorded game") + ", " + name
            + " in the place of " + as));
        if (report == Verbosity.FULL) {
            int width = rows.stream().mapToInt(row -> row.name.length()).max().orElse(0);
            streams.out().println();
            rows.forEach(row -> streams.out().println(TextFormat.plain(row.name + " ".repeat(width - row.name.length())
                + "  " + row.text())));
            streams.out().println();
        }
        List<Row> unchanged = of(rows, Rematch.Ending.UNCHANGED);
        streams.out().println("unchanged  " + unchanged.size() + standing(unchanged, false)
            + (standing(unchanged, true).isEmpty() ? "" : "; recorded" + standing(unchanged, true).substring(1)));
        streams.out().println("departed   " + turns(of(rows, Rematch.Ending.DEPARTED)));
        streams.out().println("failed     " + turns(of(rows, Rematch.Ending.FAILED)));
        long without = rows.stream().filter(row -> row.outcome == null).count();
        if (without > 0) {
            streams.out().println("not played " + without);
        }
    }

    private static List<Row> of(List<Row> rows, Rematch.Ending ending) {
        return rows.stream().filter(row -> row.is(ending)).toList();
    }

    private static String standing(List<Row> rows, boolean recorded) {
        List<Double> points = rows.stream().map(row -> recorded ? row.recorded() : row.points())
            .filter(each -> each != null).toList();
        List<String> counts = new ArrayList<>();
        for (double each : new double[] {1, 0.5, 0}) {
            counts.add(points.stream().filter(found -> found == each).count() + " " + Row.word(each));
        }
        return points.isEmpty() ? "" : ": " + String.join(", ", counts);
    }

    private static String turns(List<Row> rows) {
        int[] turns = rows.stream().mapToInt(row -> row.outcome.turn()).sorted().toArray();
        return turns.length == 0 ? "0" : turns.length + ", in turn " + turns[0]
            + (turns[0] == turns[turns.length - 1] ? ""
            : " to " + turns[turns.length - 1] + ", half of them up to " + turns[(turns.length - 1) / 2]);
    }
}
