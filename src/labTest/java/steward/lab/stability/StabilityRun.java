package steward.lab.stability;

import java.io.IOException;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import steward.lab.trial.Finding;
import steward.lab.trial.RunLength;
import steward.report.Table;

/**
 * Run of the stability table: amount of work, date, version and machine, and its rows.
 *
 * @param length how much work each case had
 * @param date   when, as year-month-day
 */
public record StabilityRun(RunLength length, String date, String version, String machine, List<StabilityRow> rows) {

    /** Name of the table. */
    public static final String CSV = "stability.csv";
    /** Name of the page. */
    public static final String PAGE = "stability.md";

    private static final Pattern CELL = Pattern.compile("\\G(?:\"((?:[^\"]|\"\")*)\"|([^,]*))(?:,|$)");

    /** Reads a table. */
    static StabilityRun read(Path csv) throws IOException {
        List<List<String>> lines = Files.readAllLines(csv).stream().skip(1)
            .map(line -> CELL.matcher(line).results().map(StabilityRun::cell).toList()).toList();
        List<String> first = lines.get(0);
        return new StabilityRun(RunLength.of(first.get(6)), first.get(7), first.get(8),
            first.get(9), lines.stream().map(cells -> new StabilityRow(cells.get(0), cells.get(5), cells.get(1),
                new Finding(Finding.Verdict.valueOf(cells.get(2).toUpperCase(Locale.ROOT)), cells.get(4)),
                Double.parseDouble(cells.get(3)))).toList());
    }

    private static String cell(MatchResult found) {
        return found.group(1) == null ? found.group(2) : found.group(1).replace("\"\"", "\"");
    }

    /** The table as {@link #read} takes it. */
    String csv() {
        return new Table<StabilityRow>().value("case", StabilityRow::name).value("rung", StabilityRow::rung)
            .value("verdict", row -> row.seen().verdict())
            .value("seconds", row -> new BigDecimal(row.seconds()).setScale(3, RoundingMode.HALF_UP).doubleValue())
            .value("seen", row -> row.seen().text()).value("demand", StabilityRow::demand)
            .value("length", row -> length).value("date", row -> date).value("version", row -> version)
            .value("machine", row -> machine).csv(rows, String::valueOf, true);
    }

    /** Writes page and picture into a folder, replacing older ones. */
    void writePage(Path folder) throws IOException {
        Files.createDirectories(folder);
        Files.writeString(folder.resolve(PAGE), StabilityPage.text(this));
        TruePathPlot.write(rows, folder);
    }
}
