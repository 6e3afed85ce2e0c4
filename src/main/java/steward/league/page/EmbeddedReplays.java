package steward.league.page;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiPredicate;
import steward.game.GameTypes;
import steward.json.JsonObject;
import steward.league.StoredGame;
import steward.replay.ReplayException;
import steward.replay.page.ReplayPage;
import tools.jackson.core.JsonGenerator;

/**
 * Kept replays that a league's page contains, by game; the page builds the page of a match from them.
 *
 * @param replays as they stand in a page
 * @param errors  lines of stderr that the page shows
 */
public record EmbeddedReplays(Map<Long, ReplayPage.Embedded> replays, ErrorLines errors) {

    /** Replays that a page holds at most, together, in bytes of the page: it is still opened in a moment. */
    private static final long MOST_BYTES = 24 << 20;

    /**
     * The kept replays that can be read, up to a size.
     *
     * @param games  the most important first
     * @param folder of the replays
     * @param types  games with which they are played again, so that the pages have what bots were sent; or {@code null}
     * @param stderr whether what the bot of a seat wrote there may be seen; {@code null} for all
     */
    public static EmbeddedReplays of(List<StoredGame> games, Path folder, GameTypes types,
                                     BiPredicate<StoredGame, Integer> stderr) {
        Map<Long, ReplayPage.Embedded> embedded = new LinkedHashMap<>();
        long bytes = 0;
        for (StoredGame game : games) {
            if (game.replay() == null || !Files.isRegularFile(folder.resolve(game.replay()))) {
                continue;
            }
            try {
                ReplayPage.Embedded replay = ReplayPage.embedded(folder.resolve(game.replay()), types,
                    stderr == null ? null : seat -> stderr.test(game, seat));
                bytes += replay.replay().length() + replay.details().length();
                if (bytes > MOST_BYTES) {
                    break;
                }
                embedded.put(game.id(), replay);
            } catch (IOException | ReplayException damaged) {
                continue;                              // the page is about more; it says where the file is
            }
        }
        return new EmbeddedReplays(embedded, new ErrorLines(folder, types, stderr));
    }

    /** The fields {@code replays} and {@code shell}. */
    public void write(JsonGenerator out, ReplayPage.Shell shell) {
        out.writeObjectPropertyStart("replays");
        replays.forEach((game, replay) ->
            JsonObject.writeTexts(out, Long.toString(game), List.of(replay.replay(), replay.details())));
        out.writeEndObject();
        if (!replays.isEmpty()) {
            out.writeObjectPropertyStart("shell");
            out.writeStringProperty("before", shell.before());
            out.writeStringProperty("after", shell.after());
            out.writeEndObject();
        }
    }
}
