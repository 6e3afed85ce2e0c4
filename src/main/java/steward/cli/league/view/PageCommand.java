package steward.cli.league.view;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import steward.cli.options.CallCheck;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.FailedException;
import steward.cli.shared.Games;
import steward.cli.shared.Pages;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.league.StoredGame;
import steward.league.page.EmbeddedReplays;
import steward.league.page.LeaguePage;
import steward.league.page.LeagueView;
import steward.league.rating.LeagueTable;
import steward.league.rating.RatingPath;
import steward.replay.page.PageReplays;
import steward.text.TextFormat;

/** {@code steward league page}: writes the league as one HTML file. */
@Command(name = "page", description = "Writes a league as one self-contained page for a browser.",
    footer = {
        "", "The page has the table, the crosstable, the ratings over games, the last games,",
        "and why each bot lost (click on its name). Kept replays are one click away: 24",
        "MB of them in the page, the others as pages of their own beside it. A moment of",
        "a game has an address: night.html#game=276&t=20.",
        "", "Example:",
        "  steward league page night --out night.html --open"})
public final class PageCommand extends ProgramCommand {

    /** Games that the page lists. */
    public static final int LISTED = 2000;
    /** Kept replays that it has at most. */
    private static final int REPLAYS = 200;

    @Mixin
    private final LeagueArgument league = new LeagueArgument();

    @Option(names = "--out", paramLabel = "FILE", description = "The file of the page; an earlier page is "
        + "replaced (default: a temporary file, with --open).")
    private String out;

    @Option(names = "--open", description = "Opens it in the browser.")
    private boolean open;

    @Mixin
    private final ReferenceOptions reference = new ReferenceOptions();

    @Override
    public Integer call() throws InterruptedException {
        CallCheck.withHelp().that(out != null || open, "found no --out and no --open, expected one");
        try (LeagueOpening.Opened opened = LeagueOpening.read(league.open())) {
            Path path = out == null ? Pages.unnamed() : OutputFiles.path(out);
            OutputFiles.check(path, true);
            if (out != null && Files.exists(path) && !LeaguePage.isOne(path)) {
                throw new InputException(path + ": exists already, and 'league page' did not write it; expected "
                    + "another name");
            }
            EmbeddedReplays replays = write(opened, reference.table(opened.games().results(), opened.entries()), path);
            streams.out().println("Page: " + path + ", " + TextFormat.count(replays.count(), "replay") + " in it"
                + (replays.linked().isEmpty() ? "" : ", " + replays.linked().size() + " in "
                + PageReplays.folder(path)));
            streams.out().flush();
            if (open) {
                Pages.open(streams, path.toAbsolutePath().toUri());
            }
        }
        return ExitStatus.DONE;
    }

    /** Writes the page, and beside its file pages of games that it does not hold. */
    private static EmbeddedReplays write(LeagueOpening.Opened opened, LeagueTable table, Path file) {
        List<StoredGame> games = games(opened);
        Path folder = opened.folder().replays();
        Map<Integer, String> names = opened.names();
        try {
            EmbeddedReplays replays = EmbeddedReplays.of(games, folder, Games.types(), null, game ->
                Pages.title(game.seats().stream().map(seat -> names.getOrDefault(seat.version(), "?")).toList()))
                .beside(file, Games.types());
            RatingPath path = opened.games().path(opened.entries(), table.reference());
            OutputFiles.replace(file, LeaguePage.of(new LeagueView(opened.season(), table, path, games, Double.NaN,
                opened.workers(), WhyCommand.ofPage(opened, games)), folder, replays, title(opened.folder().path())));
            return replays;
        } catch (IOException problem) {
            throw new FailedException(file + ": cannot be written: " + OutputFiles.reason(file, problem));
        }
    }

    /** The last games, and behind them older ones whose replays are kept. */
    private static List<StoredGame> games(LeagueOpening.Opened opened) {
        List<StoredGame> games = new ArrayList<>(opened.games().last(LISTED));
        long oldest = games.isEmpty() ? 0 : games.get(games.size() - 1).id();
        opened.games().withReplay(REPLAYS).stream().filter(game -> game.id() < oldest).forEach(games::add);
        return games;
    }

    /** The page's heading. */
    public static String title(Path folder) {
        Path name = folder.toAbsolutePath().normalize().getFileName();
        return "League " + (name == null ? "" : name);
    }
}
