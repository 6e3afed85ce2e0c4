package steward.cli.tournament;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import steward.league.rating.LeagueTable;
import steward.text.TextFormat;

/**
 * First page of a tournament: the programs by rank, each with a link to the page of its author; below them those that
 * did not play.
 *
 * @param entries the programs
 * @param table   the table, or {@code null} before the games are over
 * @param why     there is no table, if there is none
 */
record IndexPage(List<TournamentCommand.Entry> entries, LeagueTable table, String why) {

    /** Characters of what the check found; all of it is on the author's page. */
    private static final int STANDING = 160;

    void write(Path file) throws IOException {
        StringBuilder page = new StringBuilder(Html.head("Tournament")).append(table == null
            ? "<p>" + why + "</p>"
            : "<p><a href=\"league.html\">Ratings, who beats whom, all games</a>"
                + " · <a href=\"table.csv\">as CSV</a></p>")
            .append("<div class=scroll tabindex=0 role=group aria-label=Table><table><tr><th class=num>#<th>Program")
            .append("<th class=num>Rating<th class=num>±<th class=num>Points<th class=num>Games<th>Check</tr>");
        Set<String> played = new HashSet<>();
        for (LeagueTable.Row row : table == null ? List.<LeagueTable.Row>of() : table.rows()) {
            String name = row.entry().name().replaceFirst("#.*", "");
            for (TournamentCommand.Entry entry : entries) {
                if (entry.name().equals(name) && row.entry().active() && played.add(name)) {
                    line(page, entry, Integer.toString(row.rank()), TextFormat.fixed(row.rating(), 0),
                        row.hasBar() ? TextFormat.fixed(row.bar(), 0) : "–", row.sums().games() == 0 ? "–"
                            : TextFormat.fixed(100 * row.points(), 1) + "%", Long.toString(row.sums().games()));
                }
            }
        }
        for (TournamentCommand.Entry entry : entries) {
            if (!played.contains(entry.name())) {
                line(page, entry, "–", "–", "–", "–", "–");
            }
        }
        Files.writeString(file, page.append("</table></div>").append(Html.END));
    }

    private static void line(StringBuilder page, TournamentCommand.Entry entry, String rank, String... numbers) {
        String name = Html.escape(entry.name());
        page.append("<tr><td class=num>").append(rank).append("<td class=name><a href=\"")
            .append(TournamentCommand.PAGES).append('/').append(name).append(".html\">").append(name).append("</a>");
        for (String number : numbers) {
            page.append("<td class=num>").append(number);
        }
        page.append(entry.ready().problem() == null && entry.check().passes() ? "<td>" : "<td class=bad>")
            .append(Html.escape(TextFormat.shorten(entry.standing(), STANDING))).append("</tr>");
    }
}
