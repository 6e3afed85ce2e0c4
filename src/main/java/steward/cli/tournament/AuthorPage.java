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

    static final String HEAD = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        + "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">"
        + "<meta name=\"viewport\" content=\"width=device-width\"><style>body{font:16px/1.5 system-ui,sans-serif;"
        + "max-width:70rem;margin:2rem auto;padding:0 1rem;color-scheme:light dark}pre{overflow:auto;padding:.5rem;"
        + "border:1px solid #8886}td,th{text-align:left;vertical-align:top;padding:.2rem .8rem .2rem 0}"
        + ".bad{color:#c33}</style>";

    /** A text that can stand in the page. */
    static String escape(String text) {
        StringBuilder safe = new StringBuilder();
        text.codePoints().forEach(c -> {
            switch (c) {
                case '&' -> safe.append("&amp;");
                case '<' -> safe.append("&lt;");
                case '>' -> safe.append("&gt;");
                case '"' -> safe.append("&quot;");
                default -> safe.appendCodePoint(c < ' ' && c != '\n' && c != '\t' ? 0xFFFD : c);
            }
        });
        return safe.toString();
    }

    void write(Path file) throws IOException {
        StringBuilder page = new StringBuilder(HEAD).append("<title>").append(escape(entry.name()))
            .append("</title></head><body><h1>").append(escape(entry.name())).append("</h1><p>")
            .append(escape(entry.ready().program().source().getFileName().toString())).append("</p>");
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
        Files.writeString(file, page.append("</body></html>\n"));
    }

    private static void pre(StringBuilder page, String text) {
        page.append("<pre>").append(escape(text)).append("</pre>");
    }

    private static void dialog(StringBuilder page, BotCheck.Tried game) {
        page.append("<h2>What it was sent and answered, against ").append(escape(game.against())).append("</h2>");
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
