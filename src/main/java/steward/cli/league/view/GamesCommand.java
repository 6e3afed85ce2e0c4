package steward.cli.league.view;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.FailedException;
import steward.cli.shared.FailureReason;
import steward.cli.shared.Games;
import steward.cli.shared.MatchReport;
import steward.cli.shared.Pages;
import steward.cli.streams.Json;
import steward.contest.Failure;
import steward.contest.RecordedFailures;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.league.LeagueFolder;
import steward.league.StoredGame;
import steward.league.StoredGame.StoredSeat;
import steward.report.Fields;
import steward.text.TextFormat;

/** {@code steward league games}: lists games and opens their replays. */
@Command(name = "games", description = "Lists games of a league, the latest first, and opens the replay of one.",
    footer = {
        "", "With --failed or --game, each game is followed by its failures: turn and",
        "reason, the bot's stderr, and hints, if the replay was kept.",
        "", "Examples:",
        "  steward league games night --failed",
        "  steward league games night --bot mine --lost",
        "  steward league games night --bot mine --lost --open"})
public final class GamesCommand extends ProgramCommand {

    private static final int MOST = 1_000_000;

    @Mixin
    private final LeagueArgument league = new LeagueArgument();

    @Mixin
    private final GameFilter filter = new GameFilter();

    @Option(names = "--limit", paramLabel = "N", defaultValue = "20",
        description = "Lists at most N games (default: ${DEFAULT-VALUE}).")
    private int limit;

    @Option(names = "--game", paramLabel = "N", description = "Only this game.")
    private Long number;

    @Option(names = "--json", description = "Prints one JSON object and nothing else.")
    private boolean json;

    @Option(names = "--open", description = "Opens the latest of them that has a replay, in the browser.")
    private boolean open;

    @Option(names = "--view", paramLabel = "HTML", description = "Writes the page of that replay to this file.")
    private String view;

    @Override
    public Integer call() throws InterruptedException {
        filter.check();
        check.range("--limit", limit, 1, MOST);
        check.that(!json || !open && view == null, "--json: expected no --open and no --view with it");
        try (LeagueOpening.Opened opened = LeagueOpening.read(league.open())) {
            Map<Integer, String> names = opened.names();
            int version = filter.version(opened.entries());
            int opponent = filter.opponent(opened.entries());
            List<StoredGame> found = new ArrayList<>();
            int[] all = {0};
            GameFailures failures = new GameFailures(opened.folder().replays());
            read(opened, version, game -> {
                if ((number == null || game.id() == number) && filter.takes(game, version, opponent)) {
                    all[0]++;
                    failures.add(game);
                    if (found.size() < limit || (open || view != null) && game.replay() != null
                        && found.stream().noneMatch(each -> each.replay() != null)) {
                        found.add(game);
                    }
                }
            });
            if (number != null && found.isEmpty()) {
                throw new InputException("--game: found no game " + number
                    + " among them, expected one of the league's");
            }
            List<StoredGame> listed = found.subList(0, Math.min(limit, found.size()));
            if (json) {
                Json.print(streams, json(listed, all[0], opened.folder(), names));
                return ExitStatus.DONE;
            }
            for (StoredGame game : listed) {
                Path replay = GameFailures.replay(opened.folder().replays(), game);
                streams.out().println(TextFormat.plain(line(game, names) + (replay == null ? "" : ", replay "
                    + replay)));
                if (filter.failed() || number != null) {
                    GameFailures.print(streams.out(), game, replay, names);
                }
            }
            failures.lines(names).forEach(streams.out()::println);
            streams.out().println(all[0] == 0 ? "no such games" : TextFormat.count(all[0], "game")
                + (all[0] > limit ? ", the latest " + limit + " are listed" : ""));
            streams.out().flush();
            return open || view != null ? show(opened, found, names) : ExitStatus.DONE;
        }
    }

    private static void read(LeagueOpening.Opened opened, int version, Consumer<StoredGame> reader) {
        if (version >= 0) {
            opened.games().gamesOf(version, reader);
        } else {
            opened.games().last(MOST).forEach(reader);
        }
    }

    private static String line(StoredGame game, Map<Integer, String> names) {
        List<StoredSeat> seats = game.seats().stream().sorted(Comparator.comparingInt(StoredSeat::rank)).toList();
        StringBuilder line = new StringBuilder(TextFormat.right(Long.toString(game.id()), 7)).append("  ")
            .append(Instant.ofEpochMilli(game.played()).truncatedTo(ChronoUnit.SECONDS)).append("  ");
        for (int k = 0; k < seats.size(); k++) {
            StoredSeat seat = seats.get(k);
            line.append(k == 0 ? "" : seat.rank() == seats.get(k - 1).rank() ? " = " : " > ")
                .append(names.get(seat.version()))
                .append(seat.fault() == null ? "" : " (failed: " + seat.fault() + ")");
        }
        line.append(", ").append(TextFormat.count(game.turns(), "turn")).append(", seed ").append(game.seed());
        if (game.problem() != null) {
            boolean aside = game.problem().startsWith(StoredGame.FORGIVEN)
                || game.problem().startsWith(StoredGame.SUSPENDED);
            line.append(aside ? ", does not count: " : ", no result: ").append(game.problem());
        } else if (!game.counts()) {
            line.append(", played again since others used the processors");
        }
        return line + (game.counts() && game.allFailed() ? ", not rated since all failed in the same turn" : "");
    }

    private static Fields json(List<StoredGame> games, int all, LeagueFolder folder, Map<Integer, String> names) {
        return Fields.of("games", all, "list", Fields.each(games, game -> {
            Path replay = GameFailures.replay(folder.replays(), game);
            List<Failure> failures = RecordedFailures.of(Games.types(), replay);
            return Fields.of("game", game.id(), "seed", Long.toString(game.seed()),
                "played", Instant.ofEpochMilli(game.played()), "turns", game.turns(), "counts", game.counts(),
                "allFailed", game.allFailed(), "problem", game.problem(), "replay", replay,
                "seats", Fields.each(game.seats().size(), player -> {
                    StoredSeat seat = game.seats().get(player);
                    return Fields.of("bot", names.get(seat.version()), "rank", seat.rank(), "score", seat.score(),
                        "fault", seat.fault(), "failure", FailureReason.fields(MatchReport.of(failures, player)));
                }));
        }));
    }

    private int show(LeagueOpening.Opened opened, List<StoredGame> found, Map<Integer, String> names)
            throws InterruptedException {
        StoredGame game = found.stream().filter(each -> each.replay() != null).findFirst().orElseThrow(() ->
            new InputException("found no replay among these games, expected one that was kept; league.json keeps \""
                + opened.settings().keep().word() + "\""));
        Path replay = opened.folder().replays().resolve(game.replay());
        if (!Files.isRegularFile(replay)) {
            throw new InputException(replay + ": found no such file, expected the replay of game " + game.id()
                + (Files.isDirectory(opened.folder().replays()) ? "" : "; the folder of replays is gone"));
        }
        byte[] html = Pages.of(replay, Pages.title(game.seats().stream().map(seat -> names.get(seat.version()))
            .toList()));
        Path page = view == null ? Pages.unnamed() : OutputFiles.path(view);
        try {
            Files.write(page, html);
        } catch (IOException problem) {
            throw new FailedException(page + ": cannot be written: " + OutputFiles.reason(page, problem));
        }
        streams.out().println("Page of game " + game.id() + ": " + page);
        streams.out().flush();
        if (open) {
            Pages.open(streams, page.toAbsolutePath().toUri());
        }
        return ExitStatus.DONE;
    }
}
