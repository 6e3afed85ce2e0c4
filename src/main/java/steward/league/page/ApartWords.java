package steward.league.page;

import java.util.ArrayList;
import java.util.List;
import steward.league.rating.Difference;
import steward.league.rating.LeagueTable;
import steward.league.rating.LeagueTable.Row;
import steward.text.TextFormat;

/** Sentences on bots whose ratings cannot be compared: who took every point from whom, and the bound that follows. */
public final class ApartWords {

    private static final int NAMED = 3;

    private ApartWords() { }

    /** Returns the sentences; none if all ratings can be compared. */
    public static List<String> of(LeagueTable table) {
        List<Row> played = table.rows().stream().filter(row -> row.sums().games() > 0).toList();
        long groups = played.stream().mapToInt(Row::component).distinct().count();
        List<String> words = new ArrayList<>();
        if (groups < 2) {
            return words;
        }
        words.add("A rating compares bots that took points from each other. There are " + groups + " such groups, each "
            + "with its own 0.");
        List<LeagueTable.Apart> apart = table.apart();
        apart.forEach(each -> words.add(sentence(each)));
        List<Integer> told = new ArrayList<>(apart.stream().map(each -> each.lower().get(0).component()).toList());
        told.add(played.get(0).component());
        played.stream().map(Row::component).distinct().filter(number -> !told.contains(number)).forEach(number ->
            words.add("No game compares " + names(played.stream().filter(row -> row.component() == number).toList(),
                false) + " with the bots above."));
        return words;
    }

    private static String sentence(LeagueTable.Apart apart) {
        Row last = apart.upper().get(apart.upper().size() - 1);
        Row first = apart.lower().get(0);
        Difference difference = apart.difference();
        return names(apart.upper(), true) + " took every point from " + names(apart.lower(), false) + ", in "
            + TextFormat.count(apart.seeds(), "seed") + ": " + (difference.isOneSided() && difference.boundElo() > 0
            ? name(last) + " is more than " + (long) difference.boundElo() + " Elo ahead of " + name(first)
            : "too few to say who is better") + ".";
    }

    private static String names(List<Row> rows, boolean fromBelow) {
        int from = fromBelow ? Math.max(0, rows.size() - NAMED) : 0;
        List<String> names = rows.subList(from, Math.min(rows.size(), from + NAMED)).stream().map(ApartWords::name)
            .toList();
        return String.join(", ", names) + (rows.size() > NAMED ? " and " + (rows.size() - NAMED) + " more" : "");
    }

    private static String name(Row row) {
        return row.entry().name();
    }
}
