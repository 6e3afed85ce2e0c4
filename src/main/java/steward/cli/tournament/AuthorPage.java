package steward.cli.tournament;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import steward.cli.check.BotCheck;
import steward.cli.check.CheckCommand;
import steward.cli.check.CheckDialogue;
import steward.cli.league.view.GameFailures;
import steward.cli.shared.Games;
import steward.contest.Failure;
import steward.league.StoredGame;
import steward.league.StoredGame.StoredSeat;
import steward.league.page.EmbeddedReplays;
import steward.replay.page.PageTemplate;
import steward.replay.page.ReplayPage;
import steward.text.TextFormat;

/**
 * Page of one author after a tournament. It has the result of the program's check, with the lines sent and answered,
 * the compiler's error, and the program's games with replays of those that it lost or failed in. Of other programs it
 * has names, results and moves, never stderr or source.
 *
 * @param entry   the program
 * @param version that plays, or -1 before that is known
 * @param games   its games that count, the latest first
 * @param names   of all versions
 * @param replays the folder of kept replays
 */
record AuthorPage(TournamentCommand.Entry entry, int version, List<StoredGame> games, Map<Integer, String> names,
                  Path replays) {

    /** The page before games are played. */
    static AuthorPage before(TournamentCommand.Entry entry) {
        return new AuthorPage(entry, -1, List.of(), Map.of(), null);
    }

    /** The page with the games of the tournament. */
    static AuthorPage of(TournamentCommand.Entry entry, PlayedGames played, Path replays) {
        int version = played.versionOf(entry.name());
        List<StoredGame> games = played.counted().stream().filter(game -> game.seats().stream()
            .anyMatch(seat -> seat.version() == version))
            .sorted(Comparator.comparingLong(StoredGame::id).reversed()).toList();
        return new AuthorPage(entry, version, games, played.names(), replays);
    }

    private StoredSeat own(StoredGame game) {
        return game.seats().stream().filter(seat -> seat.version() == version).findFirst().orElseThrow();
    }

    private Stream<StoredSeat> others(StoredGame game) {
        return game.seats().stream().filter(seat -> seat.version() != version);
    }

    void write(Path file) throws IOException {
        List<StoredGame> bad = games.stream().filter(game -> own(game).fault() != null || own(game).rank() > 0)
            .sorted(Comparator.comparing(game -> own(game).fault() == null)).toList();
        EmbeddedReplays kept = EmbeddedReplays.of(bad, replays, Games.types(), (game, seat) ->
            game.seats().get(seat).version() == version, game -> entry.name()).beside(file, Games.types());
        ReplayPage.Shell shell = ReplayPage.shell();
        boolean any = kept.count() > 0;
        StringBuilder page = new StringBuilder(any ? Html.headWithReplays(entry.name(), shell)
            : Html.head(entry.name())).append("<p>")
            .append(Html.escape(entry.ready().program().source().getFileName().toString()))
            .append(" · <a href=\"../index.html\">all programs</a></p>");
        if (entry.ready().source() != null && entry.ready().source().left() != null) {
            page.append("<p class=bad>").append(Html.escape(entry.ready().source().left())).append(".</p>");
        }
        if (entry.ready().problem() != null) {
            page.append("<p class=bad>It cannot run:</p>");
            pre(page, entry.ready().problem());
        }
        String call = Workshop.call(entry.ready());
        if (call != null) {
            page.append("<p>Compiled by <code>").append(Html.escape(call)).append("</code></p>");
        }
        if (entry.check() != null) {
            ByteArrayOutputStream said = new ByteArrayOutputStream();
            CheckCommand.print(new PrintStream(said, true, StandardCharsets.UTF_8), entry.check());
            page.append("<h2>The check</h2>");
            pre(page, said.toString(StandardCharsets.UTF_8));
        }
        if (version >= 0) {
            games(page, kept);
        }
        if (entry.check() != null) {
            entry.check().games().forEach(game -> dialogue(page, game));
        }
        Files.writeString(file, page.append(any ? Html.endWithReplays(PageTemplate.inScript(kept.fields(shell)))
            : Html.END));
    }

    private void games(StringBuilder page, EmbeddedReplays kept) {
        page.append("<h2>Its games</h2><p>").append(TextFormat.count(games.size(), "game")).append("</p>");
        GameFailures failures = new GameFailures(replays);
        games.forEach(game -> failures.add(game, version));
        List<String> lines = failures.lines(names);
        if (!lines.isEmpty()) {
            pre(page, String.join("\n", lines));
        }
        if (games.isEmpty()) {
            return;
        }
        page.append("<div class=scroll tabindex=0 role=group aria-label=Games><table class=games><tr>"
            + "<th>Against<th>Result<th>Replay</tr>");
        for (StoredGame game : games) {
            String against = others(game).map(seat -> names.get(seat.version())).collect(Collectors.joining(", "));
            page.append("<tr><td class=name>").append(Html.escape(against.isEmpty() ? "alone" : against)).append("<td>")
                .append(result(game));
            reasons(page, game);
            page.append("<td>");
            if (kept.has(game.id())) {
                boolean failed = own(game).fault() != null;
                page.append("<a href=\"#game=").append(game.id())
                    .append(failed ? "&amp;fault=" + game.seats().indexOf(own(game))
                        : "&amp;turn=" + game.turns())
                    .append("\" data-game=").append(game.id()).append(" data-title=\"")
                    .append(Html.escape(entry.name() + (against.isEmpty() ? "" : " against " + against))).append("\">")
                    .append(failed ? "the failure" : "the end").append("</a>");
            }
            page.append("</tr>");
        }
        page.append("</table></div>");
    }

    private String result(StoredGame game) {
        StoredSeat own = own(game);
        long first = game.seats().stream().filter(seat -> seat.rank() == 0).count();
        return game.seats().size() == 1 ? "score " + TextFormat.number(own.score(), 2)
            : own.rank() == 0 ? first == 1 ? "won" : "drawn"
            : game.seats().size() == 2 ? "lost" : "place " + (own.rank() + 1) + " of " + game.seats().size();
    }

    /** Its own failure in full; of the others no more than the kind. */
    private void reasons(StringBuilder page, StoredGame game) {
        if (own(game).fault() != null) {
            page.append("<div class=bad>failed in turn ").append(own(game).answers()).append(": ")
                .append(Html.escape(TextFormat.plain(own(game).fault()))).append("</div>");
        }
        others(game).filter(seat -> seat.fault() != null).forEach(seat -> page.append("<div>")
            .append(Html.escape(names.get(seat.version()) + " failed: " + TextFormat.plain(Failure.kind(seat.fault()))))
            .append("</div>"));
    }

    private static void pre(StringBuilder page, String text) {
        page.append("<pre tabindex=0>").append(Html.escape(text)).append("</pre>");
    }

    private static void dialogue(StringBuilder page, BotCheck.Tried game) {
        page.append("<h2>What it was sent and answered, against ").append(Html.escape(game.against())).append("</h2>");
        for (CheckDialogue.Turn turn : game.turns()) {
            page.append("<h3>Turn ").append(turn.number()).append(", ").append(TextFormat.ms(turn.nanos()))
                .append(" ms</h3>");
            part(page, "It was sent", turn.received());
            part(page, "It answered", turn.answer().isEmpty() && turn.fault() != null ? "(nothing)" : turn.answer());
            part(page, "It wrote to stderr", turn.stderr());
            part(page, "It failed", turn.fault());
        }
    }

    private static void part(StringBuilder page, String head, String text) {
        if (text != null) {
            page.append("<p").append(head.equals("It failed") ? " class=bad>" : ">").append(head).append(":</p>");
            pre(page, text);
        }
    }
}
