package steward.lab.bench;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import steward.text.TextFormat;

/** Page of the documentation with the measured table. */
public final class PerformancePage {

    private static final int WIDTH = 118;

    private PerformancePage() { }

    static String of(List<Section> sections, List<Row> rows, String machine, String date, String load) {
        StringBuilder page = new StringBuilder();
        page.append("# Performance\n\n")
            .append("Written by `steward bench` on ").append(date).append(": ").append(machine).append(".\n")
            .append("Load of the machine, this run included: ").append(load).append(". Sections that wait for other"
                + " programs are measured by the wall clock.\n\n")
            .append("Machines differ, and one machine differs from hour to hour. So compare the ratios: they are"
                + " between figures of one run, measured in turns.\nEach ratio is to the first line of its group; a"
                + " ratio above 1 is faster. Unless a section says otherwise, time is CPU time of"
                + " the\nthread that works. Each figure is the median of several rounds after a warm-up.\n");
        for (Section section : sections) {
            List<Row> own = rows.stream().filter(row -> row.section().equals(section.name())).toList();
            if (!own.isEmpty()) {
                page.append("\n## ").append(section.name()).append("\n\n")
                    .append(TextFormat.wrap(section.about(), " ", WIDTH, "")).append("\n\n");
                table(page, own);
            }
        }
        memory(page, rows);
        return page.toString();
    }

    private static void table(StringBuilder page, List<Row> rows) {
        page.append("| | a second | | each | ratio | bytes | |\n|---|---:|---|---:|---:|---:|---|\n");
        for (Row row : rows) {
            page.append("| ").append(String.join(" | ", row.name(), count(row.perSecond()), row.unit(),
                time(row.nanos()), Double.isNaN(row.ratio()) ? "" : String.format(Locale.ROOT, "%.2f", row.ratio()),
                Double.isNaN(row.bytes()) ? "" : count(row.bytes()), row.note())).append(" |\n");
        }
    }

    /** Sentence on the limit that memory sets: what crowds take beyond a small one, in lines read from memory. */
    private static void memory(StringBuilder page, List<Row> rows) {
        Map<String, Double> nanos = new HashMap<>();
        rows.stream().filter(row -> row.section().equals("crowds")).forEach(row -> nanos.put(row.name(), row.nanos()));
        double small = nanos.getOrDefault("queue, 1000 bodies", Double.NaN);
        List<String> parts = new ArrayList<>();
        for (String bodies : List.of("100000 bodies", "1000000 bodies")) {
            double lines = (nanos.getOrDefault("queue, " + bodies, Double.NaN) - small)
                / nanos.getOrDefault("memory, " + bodies, Double.NaN);
            if (!Double.isNaN(lines)) {
                parts.add(String.format(Locale.ROOT, "%.0f lines (%s)", lines, bodies));
            }
        }
        if (!parts.isEmpty()) {
            page.append("\n## How cost grows\n\n- With memory: an impact takes longer than among 1000 bodies by as"
                + " much as reading ").append(String.join(", ", parts))
                .append(" of 64 bytes one after the other.\n");
        }
    }

    /** Three significant digits, with separators between thousands. */
    static String count(double value) {
        double unit = value < 1 ? 1 : Math.pow(10, Math.max(0, Math.floor(Math.log10(value)) - 2));
        return value < 100 && value != Math.rint(value) ? String.format(Locale.ROOT, "%.1f", value)
            : String.format(Locale.ROOT, "%,.0f", Math.rint(value / unit) * unit);
    }

    /** In the unit that leaves one to three digits before the decimal point. */
    static String time(double nanos) {
        return nanos < 1e3 ? String.format(Locale.ROOT, "%.0f ns", nanos)
            : nanos < 1e6 ? String.format(Locale.ROOT, "%.2f us", nanos / 1e3)
            : String.format(Locale.ROOT, "%.2f ms", nanos / 1e6);
    }
}
