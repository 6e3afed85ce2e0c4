package steward.cli.tournament;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import steward.cli.check.BotCheck;
import steward.cli.check.CheckCommand;
import steward.cli.check.Dialog;
import steward.text.TextFormat;

/**
 * The page of one author: what the check of the program found, the compiler's error, what the program was sent and
 * answered, and how it failed in the tournament.
 *
 * @param entry   the program
 * @param games   lines about its games; none before they are played
 */
record AuthorPage(TournamentCommand.Entry entry, List<String> games) {

    void write(Path file) throws IOException {
        StringBuilder page = new StringBuilder(Html.head(entry.name())).append("<p>")
            .append(Html.escape(entry.ready().program().source().getFileName().toString()))
            .append(" · <a href=\"../index.html\">all programs</a></p>");
        if (entry.ready().problem() != null) {
            page.append("<p class=bad>It cannot run:</p>");
            pre(page, entry.ready().problem());
        }
        if (entry.check() != null) {
            ByteArrayOutputStream said = new ByteArrayOutputStream();
            CheckCommand.print(new PrintStream(said, true, StandardCharsets.UTF_8), entry.check());
            page.append("<h2>The check</h2>");
            pre(page, said.toString(StandardCharsets.UTF_8));
        }
        if (!games.isEmpty()) {
            page.append("<h2>The tournament</h2>");
            pre(page, String.join("\n", games));
        }
        if (entry.check() != null) {
            entry.check().games().forEach(game -> dialog(page, game));
        }
        Files.writeString(file, page.append(Html.END));
    }

    private static void pre(StringBuilder page, String text) {
        page.append("<pre tabindex=0>").append(Html.escape(text)).append("</pre>");
    }

    private static void dialog(StringBuilder page, BotCheck.Tried game) {
        page.append("<h2>What it was sent and answered, against ").append(Html.escape(game.against())).append("</h2>");
        for (Dialog.Turn turn : game.turns()) {
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
