package steward.cli.play;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import steward.cli.shared.FailedException;
import steward.cli.shared.Games;
import steward.cli.shared.Pages;
import steward.cli.streams.Streams;
import steward.contest.Contest;
import steward.contest.Series;
import steward.contest.SeriesPlay;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.replay.page.PageReplays;
import steward.replay.page.PageTemplate;
import steward.replay.page.ReplayPage;
import steward.text.TextFormat;

/**
 * Page of a series: results, answer times, failures and kept replays in one file. Replays that are too many for it
 * become pages beside it.
 *
 * @param file      where it goes; {@code null} for none
 * @param open      whether a browser is to open it
 * @param overwrite whether it replaces a file
 */
record SeriesPage(Path file, boolean open, boolean overwrite) {

    private static final String FOLDER = "/steward/series/";

    /** No page. */
    static final SeriesPage NONE = new SeriesPage(null, false, false);

    /** The page that options ask for. @param view the name of its file, or {@code null} */
    static SeriesPage of(String view, boolean open, boolean overwrite) {
        if (view == null && !open) {
            return NONE;
        }
        SeriesPage page = new SeriesPage(view == null ? Pages.unnamed() : OutputFiles.path(view), open,
            overwrite || view == null);
        OutputFiles.check(page.file, page.overwrite);
        Path above = page.file.toAbsolutePath().getParent();
        if (!Files.isDirectory(above)) {
            throw new InputException(page.file + ": cannot be written: there is no folder " + above);
        }
        return page;
    }

    /** Writes it, says where it is, and opens it. */
    void write(Streams streams, Series series, SeriesPlay play, List<String> choosers, boolean isSaid)
            throws InterruptedException {
        if (file == null) {
            return;
        }
        Contest contest = series.contest();
        List<PageReplays.Kept> kept = play.standings().games().stream()
            .filter(game -> game.replay() != null && Files.isRegularFile(game.replay()))
            .map(game -> new PageReplays.Kept(game.number(), game.replay(), Pages.title(IntStream.range(0,
                contest.players()).mapToObj(player -> contest.entrants().get(game.entrantOf(contest, player)).name())
                .toList()), null)).toList();
        PageReplays replays = PageReplays.of(kept, Games.types());
        try {
            Map<Long, String> linked = replays.writeBeside(file, Games.types());
            ReplayPage.Shell shell = ReplayPage.shell();
            byte[] html = PageTemplate.of(FOLDER, Pages.title(contest.entrants().stream().map(Contest.Entrant::name)
                .toList()), shell, SeriesJson.of(series, play, choosers, null).with("folder", series.folder())
                .and(replays.fields(shell, linked)));
            Pages.write(file, html, overwrite);
            if (isSaid) {
                streams.out().println("Page: " + file + ", " + TextFormat.count(replays.embedded().size(), "replay")
                    + " in it" + (linked.isEmpty() ? "" : ", " + linked.size() + " in " + PageReplays.folder(file)));
                streams.out().flush();
            }
        } catch (IOException problem) {
            throw new FailedException(file + ": cannot be written: " + OutputFiles.reason(file, problem));
        }
        if (open) {
            Pages.open(streams, file.toAbsolutePath().toUri());
        }
    }
}
