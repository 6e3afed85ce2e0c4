package steward.cli.league;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.BiPredicate;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.Cli;
import steward.cli.ShellBots;
import steward.cli.league.view.LeagueOpening;
import steward.cli.shared.Games;
import steward.league.LeagueFolder;
import steward.league.StoredGame;
import steward.league.page.ErrorLines;
import steward.league.page.LeaguePage;
import steward.league.page.LeagueView;
import steward.league.rating.LeagueTable;

/** Pages of a league, from disk and live, name the line of a bot's stderr that says why it failed. */
@Tag("process")
class ErrorLinesTest {

    private static final String LINE = "\"error\":\"ValueError: found a \\u003cdog>\"";

    @TempDir
    private Path folder;

    private static int count(String page, String text) {
        return page.split(Pattern.quote(text), -1).length - 1;
    }

    @Test
    void aPageShowsTheLineOfEachGameWhoseReplayIsKept() throws IOException {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
        Path bot = Files.writeString(folder.resolve("sad.sh"), "read -r line\nprintf '%s\\n' 'Traceback (most recent "
            + "call last):' '  File \"bot.py\", line 3, in f' 'ValueError: found a <dog>' noise >&2\nexit 1\n");
        Cli.league(folder, "init", "TMP/a", "--scene", "duel", "--keep", "failed", "--time-factor", "100").done();
        Cli.league(folder, "add", "TMP/a", "sad=sh " + bot, "builtin:racer").done();
        Cli.league(folder, "run", "TMP/a", "--games", "2").done();
        Cli.league(folder, "page", "TMP/a", "--out", "TMP/page.html").done();
        String page = Files.readString(folder.resolve("page.html"));
        assertEquals(2, count(page, LINE), page);
        assertEquals(2, count(page, "\"error\":null"), "the other bot's");
        try (LeagueOpening.Opened league = LeagueOpening.read(new LeagueFolder(folder.resolve("a")))) {
            List<StoredGame> games = league.games().last(10);
            LeagueView view = new LeagueView(league.season(), LeagueTable.of(league.games().results(),
                league.entries()), league.games().path(league.entries(), LeagueTable.Reference.NONE),
                games, Double.NaN, List.of());
            Path replays = league.folder().replays();
            BiPredicate<StoredGame, Integer> nobody = (game, seat) -> false;
            assertEquals(2, count(LeaguePage.live(view, new ErrorLines(replays, Games.types(), null)),
                LINE.replace("\\u003c", "<")));
            assertEquals(0, count(LeaguePage.live(view, new ErrorLines(replays, Games.types(), nobody)), "ValueError"));
            ErrorLines lines = new ErrorLines(replays, Games.types(), null);
            for (StoredGame game : games) {
                Files.delete(replays.resolve(game.replay()));
            }
            assertEquals(0, count(LeaguePage.live(view, lines), LINE));
            assertTrue(page.contains("exited with status 1"), page);
        }
    }
}
