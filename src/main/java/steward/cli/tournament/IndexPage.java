package steward.cli.tournament;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import steward.text.TextFormat;

/**
 * First page of a tournament: the programs by place, each with a link to its author's page. Below them are programs
 * that did not play.
 *
 * @param entries the programs
 * @param scores  the table, or {@code null} before the games are over
 * @param notes   below the table, or why there is none
 */
record IndexPage(List<TournamentCommand.Entry> entries, Scores scores, List<String> notes) {

    /** Characters of what the check found; all of it is on the author's page. */
    private static final int STANDING = 160;

    /** Numbers that a phone does not show. */
    private static final Set<Integer> WIDE = Set.of(1, 5, 6);

    void write(Path file) throws IOException {
        StringBuilder page = new StringBuilder(Html.head("Tournament"));
        if (scores != null) {
            page.append("<p><a href=\"league.html\">Ratings, who beats whom, all games</a>"
                + " · <a href=\"table.csv\">as CSV</a></p>");
        }
        page.append("<div class=scroll tabindex=0 role=group aria-label=Table><table class=places><tr>")
            .append("<th class=num>#<th>Program")
            .append("<th class=num>Points<th class=\"num wide\">Games<th class=num>Won<th class=num>Drawn")
            .append("<th class=num>Lost<th class=\"num wide\">Failed")
            .append(scores != null && scores.isSwiss() ? "<th class=\"num wide\">Buchholz" : "")
            .append("<th class=why>Check</tr>");
        Set<String> played = new HashSet<>();
        for (Scores.Row row : scores == null ? List.<Scores.Row>of() : scores.rows()) {
            for (TournamentCommand.Entry entry : entries) {
                if (entry.name().equals(row.name()) && played.add(row.name())) {
                    List<String> numbers = new ArrayList<>(List.of(Scores.points(row.points()), "" + row.games(),
                        "" + row.wins(), "" + row.draws(), "" + row.losses(), "" + row.failed()));
                    if (scores.isSwiss()) {
                        numbers.add(Scores.points(row.tie()));
                    }
                    line(page, entry, Integer.toString(row.place()), numbers);
                }
            }
        }
        for (TournamentCommand.Entry entry : entries) {
            if (!played.contains(entry.name())) {
                line(page, entry, "–", Collections.nCopies(scores != null && scores.isSwiss() ? 7 : 6, "–"));
            }
        }
        page.append("</table></div>");
        notes.forEach(note -> page.append("<p>").append(Html.escape(note)).append("</p>"));
        Files.writeString(file, page.append(Html.END));
    }

    private static void line(StringBuilder page, TournamentCommand.Entry entry, String place, List<String> numbers) {
        String name = Html.escape(entry.name());
        page.append("<tr><td class=num>").append(place).append("<td class=name><a href=\"")
            .append(TournamentCommand.PAGES).append('/').append(name).append(".html\">").append(name).append("</a>");
        for (int k = 0; k < numbers.size(); k++) {
            page.append(WIDE.contains(k) ? "<td class=\"num wide\">" : "<td class=num>").append(numbers.get(k));
        }
        page.append("<td class=\"why bad\">").append(entry.isReady() ? ""
            : Html.escape(TextFormat.shorten(entry.standingForAll(), STANDING))).append("</tr>");
    }
}
