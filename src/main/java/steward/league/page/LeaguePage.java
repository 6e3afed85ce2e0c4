package steward.league.page;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Function;
import steward.json.JsonObject;
import steward.league.StoredGame;
import steward.replay.page.PageTemplate;
import steward.replay.page.ReplayPage;

/**
 * HTML page of a league, in one file that opens from disk without a network and contains the latest kept replays. While
 * the league is played, the page follows server-sent events.
 */
public final class LeaguePage {

    private static final String FOLDER = "/steward/league/";
    private static final String LIVE = "live";
    private static final String IN_PAGE = "page";

    /** Stands in the head of each page. */
    private static final String GENERATOR = "<meta name=\"generator\" content=\"steward league\">";
    private static final int HEAD = 2000;

    private LeaguePage() { }

    /** True if a file is a page that was written here, or is empty. */
    public static boolean isOne(Path file) {
        try (InputStream in = Files.newInputStream(file)) {
            String head = new String(in.readNBytes(HEAD), StandardCharsets.UTF_8);
            return head.isEmpty() || head.contains(GENERATOR);
        } catch (IOException unreadable) {
            return false;
        }
    }

    /**
     * Returns the page of a league as it is.
     *
     * @param folder  of the kept replays
     * @param replays those that are in the page
     * @param title   plain text
     */
    public static byte[] of(LeagueView view, Path folder, EmbeddedReplays replays, String title) {
        ReplayPage.Shell shell = ReplayPage.shell();
        Function<StoredGame, String> where = game -> game.replay() == null ? null
            : replays.has(game.id()) ? IN_PAGE : folder.resolve(game.replay()).toString();
        return PageTemplate.of(FOLDER, title, shell, LeagueJson.view(view, where, replays.errors())
            .and(replays.fields(shell)));
    }

    /**
     * The page of a league that is being played.
     *
     * @param title plain text
     * @param feed  address of the events, relative to the page; each is an object of
     *              {@link #live(LeagueView, ErrorLines)}
     */
    public static byte[] live(String title, String feed) {
        PageTemplate page = new PageTemplate(FOLDER, title);
        page.put("policy", page.policy("'self'"));
        page.put("source", "data-feed=\"" + PageTemplate.escape(feed) + "\"");
        return page.with("");
    }

    /** Returns the message to an open page: all that it shows, on one line. */
    public static String live(LeagueView view, ErrorLines errors) {
        return JsonObject.text(LeagueJson.view(view, game -> game.replay() == null ? null : LIVE, errors)::write);
    }
}
