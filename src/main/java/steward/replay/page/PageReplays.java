package steward.replay.page;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.IntPredicate;
import steward.files.OutputFiles;
import steward.game.GameTypes;
import steward.replay.ReplayException;
import steward.replay.ReplayReader;
import steward.report.Fields;

/**
 * Kept replays of a page of many games: those in the page, and, beyond a size, others in pages of their own beside it.
 *
 * @param embedded as they stand in the page, by game
 * @param beyond   the others that can be read, the most important first
 */
public record PageReplays(Map<Long, ReplayPage.Embedded> embedded, List<Kept> beyond) {

    /** Replays that a page holds at most, together, in bytes of the page: it is still opened in a moment. */
    private static final long MOST_BYTES = 24 << 20;
    /** Pages beside a page: with a third of a megabyte each, some hundred megabytes. */
    private static final int MOST_PAGES = 400;

    /**
     * A kept replay.
     *
     * @param game   its number
     * @param title  of its page
     * @param stderr whether what a player wrote there, and its command, may be seen; {@code null} for all
     */
    public record Kept(long game, Path file, String title, IntPredicate stderr) { }

    /**
     * Reads replays up to a size; one that cannot be read is left out, the page is about more.
     *
     * @param kept  the most important first
     * @param types games with which they are played again, so that the pages have what bots were sent; or {@code null}
     */
    public static PageReplays of(List<Kept> kept, GameTypes types) {
        return of(kept, types, MOST_BYTES);
    }

    static PageReplays of(List<Kept> kept, GameTypes types, long most) {
        Map<Long, ReplayPage.Embedded> embedded = new LinkedHashMap<>();
        long bytes = 0;
        for (int k = 0; k < kept.size(); k++) {
            Kept one = kept.get(k);
            try {
                ReplayPage.Embedded replay = ReplayPage.embedded(one.file, types, one.stderr);
                bytes += replay.replay().length() + replay.details().length();
                if (bytes > most) {
                    return new PageReplays(embedded, List.copyOf(kept.subList(k, kept.size())));
                }
                embedded.put(one.game, replay);
            } catch (IOException | ReplayException damaged) {
                continue;                              // the page says where the file is
            }
        }
        return new PageReplays(embedded, List.of());
    }

    /** The folder of pages beside a page: {@code series-games} for {@code series.html}. */
    public static Path folder(Path page) {
        String name = page.getFileName().toString();
        return page.resolveSibling(name.replaceFirst("(?i)\\.html?$", "") + "-games");
    }

    /**
     * Writes the pages of the games that are not in the page, beside it, and replaces those that are there.
     *
     * @return by game, the address relative to the page
     * @throws IOException if they cannot be written
     */
    public Map<Long, String> writeBeside(Path page, GameTypes types) throws IOException {
        Map<Long, String> linked = new TreeMap<>();
        Path folder = folder(page);
        List<Kept> written = new ArrayList<>(beyond.subList(0, Math.min(MOST_PAGES, beyond.size())));
        if (!written.isEmpty()) {
            OutputFiles.prepareFolder(folder);
        }
        for (Kept one : written) {
            Path file = folder.resolve(one.game + ".html");
            try {
                byte[] replay = ReplayReader.asWritten(Files.readAllBytes(one.file));
                byte[] seen = one.stderr == null ? replay : OwnStderr.of(replay, one.stderr);
                Files.write(file, ReplayPage.of(seen, one.file.toString(), one.title, PageExtras.of(types)));
                linked.put(one.game, folder.getFileName() + "/" + file.getFileName());
            } catch (ReplayException damaged) {
                Files.deleteIfExists(file);
            }
        }
        return linked;
    }

    /** The fields {@code replays}, {@code linked} and, if there are replays, {@code shell}. */
    public Fields fields(ReplayPage.Shell shell, Map<Long, String> linked) {
        Fields replays = Fields.of();
        embedded.forEach((game, replay) -> replays.with(Long.toString(game), List.of(replay.replay(),
            replay.details())));
        Fields fields = Fields.of("replays", replays, "linked", linked);
        return embedded.isEmpty() ? fields
            : fields.with("shell", Fields.of("before", shell.before(), "after", shell.after()));
    }
}
