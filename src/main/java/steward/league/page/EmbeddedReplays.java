package steward.league.page;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.BiPredicate;
import java.util.function.Function;
import steward.game.GameTypes;
import steward.league.StoredGame;
import steward.replay.page.PageReplays;
import steward.replay.page.ReplayPage;
import steward.report.Fields;

/**
 * Kept replays of a league's page, by game: those that it contains, and those that have a page beside it.
 *
 * @param kept   those in the page, and those that are too many for it
 * @param linked addresses of pages beside it, by game
 * @param errors lines of stderr that the page shows
 */
public record EmbeddedReplays(PageReplays kept, Map<Long, String> linked, ErrorLines errors) {

    /**
     * The kept replays that can be read, up to a size.
     *
     * @param games  the most important first
     * @param folder of the replays
     * @param types  games with which they are played again, so that the pages have what bots were sent; or {@code null}
     * @param stderr whether what the bot of a seat wrote there may be seen; {@code null} for all
     * @param titles of the pages of games
     */
    public static EmbeddedReplays of(List<StoredGame> games, Path folder, GameTypes types,
                                     BiPredicate<StoredGame, Integer> stderr, Function<StoredGame, String> titles) {
        List<PageReplays.Kept> kept = games.stream()
            .filter(game -> game.replay() != null && Files.isRegularFile(folder.resolve(game.replay())))
            .map(game -> new PageReplays.Kept(game.id(), folder.resolve(game.replay()), titles.apply(game),
                stderr == null ? null : seat -> stderr.test(game, seat))).toList();
        return new EmbeddedReplays(PageReplays.of(kept, types), Map.of(), new ErrorLines(folder, types, stderr));
    }

    /** Writes pages for those that are too many for a page, beside it. */
    public EmbeddedReplays beside(Path page, GameTypes types) throws IOException {
        return new EmbeddedReplays(kept, kept.writeBeside(page, types), errors);
    }

    /** Returns how many replays a page holds. */
    public int count() {
        return kept.embedded().size();
    }

    /** True if a game can be watched from the page. */
    public boolean has(long game) {
        return kept.embedded().containsKey(game) || linked.containsKey(game);
    }

    /** The fields {@code replays}, {@code linked} and {@code shell}. */
    public Fields fields(ReplayPage.Shell shell) {
        return kept.fields(shell, linked);
    }
}
