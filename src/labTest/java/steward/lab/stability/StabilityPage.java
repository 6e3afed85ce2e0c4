package steward.lab.stability;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import steward.files.Resources;
import steward.lab.chart.PictureTag;
import steward.lab.stability.TruePathPlot.Figure;
import steward.lab.trial.Finding;
import steward.text.TextFormat;

/** The page with the results: all of its numbers are those of the rows. */
public final class StabilityPage {

    private static final String MEANINGS = "/steward/stability-meanings.csv";
    /** Rungs that the overview has columns for: those on which something is demanded. */
    private static final String STEPS = "step/";

    private static final String COMMANDS = """
        ## Commands

            ./gradlew campaigns --tests '*StabilityTableTest'    # approximately 10 minutes
            ./gradlew quickTest --tests '*StabilityTest'         # short versions: a few seconds

        The first one writes page, table and picture into `build/pages`. `-Psteward.length=long` plays long versions, in
        hours: 10^8 random pairs, 10^9 impacts of a crowd. `-Psteward.rows` is a regular expression of case and rung:

            ./gradlew campaigns --tests '*StabilityTableTest' -Psteward.length=long \\
                -Psteward.rows='crowd of 1000, 10%, double'
        """;

    private static final String NOTES = """
        ## Where `official` ends

        The expressions of `official` are the server's, and stay as they are. They multiply by a rounded inverse mass.
        So if two equal masses that are not 1 meet, the one that hits keeps a rounding of its speed. In some touching
        rows of [random cradles](#random-cradles) such residues cause impacts that nobody sees. On the other event
        rungs all rows are right.

        ## Rest

        The case `inelastic collapse` tests the bound on impacts, which has to end such a turn and be named. It is
        played under a law without rest (`"restSpeed": 0`), because [rest](scenes.md#rest-and-sliding) would end the
        collapse. The cases from `rest` to `fallen piles` test the law with rest: under it no turn may reach that bound.

        ## The same bits everywhere

        One hash over worlds, games and rungs is equal on every machine. The following prints and compares it:
        interpreted, under C1 and C2, and without fused multiply-add (FMA), an instruction of processors. It also
        compares other garbage collectors and another JDK:

            ./gradlew golden -PotherJdk=/path/to/another/jdk       # minutes, approximately

        Machines without FMA pay for that; a benchmark measures how much:

            ./gradlew jmh -Pbench=Fma
        """;

    private final StabilityRun run;
    private final List<StabilityRow> rows;
    private final Map<String, List<StabilityRow>> cases = new LinkedHashMap<>();

    private StabilityPage(StabilityRun run) {
        this.run = run;
        rows = run.rows();
        rows.forEach(row -> cases.computeIfAbsent(row.name(), name -> new ArrayList<>()).add(row));
    }

    /** In Markdown. */
    public static String text(StabilityRun run) {
        StabilityPage page = new StabilityPage(run);
        StringBuilder out = new StringBuilder();
        page.begin(out);
        page.truePath(out);
        page.overview(out);
        page.cite(out);
        out.append(COMMANDS).append('\n').append(NOTES).append("\n## All figures\n");
        page.cases.forEach((name, of) -> page.figures(name, of, out));
        return out.toString();
    }

    /** One sentence for each case. */
    static Map<String, String> meanings() {
        Map<String, String> meanings = new LinkedHashMap<>();
        Resources.text(MEANINGS).lines().skip(1).map(line -> line.split(";"))
            .forEach(cells -> meanings.put(cells[0], cells[1]));
        return meanings;
    }

    private long verdicts(Finding.Verdict verdict) {
        return rows.stream().filter(row -> row.seen().verdict() == verdict).count();
    }

    private void begin(StringBuilder out) {
        long failed = verdicts(Finding.Verdict.FAILS);
        out.append(String.format(Locale.ROOT, """
            # Stability at the numerical extremes

            A campaign plays extreme cases on every rung, that is, at every setting of [accuracy](accuracy.md). For each
            it says what is demanded, what was seen, and the verdict. If one demand fails, so does the campaign. Of %s
            %,d are met and %,d %s not, in a run of %s length.

            Written by `./gradlew campaigns --tests '*StabilityTableTest'` of Steward %s on %s: %s.
            Date and version of each row stand in [the table](stability.csv).
            """, TextFormat.count(verdicts(Finding.Verdict.HOLDS) + failed, "demand"),
            verdicts(Finding.Verdict.HOLDS), failed, failed == 1 ? "is" : "are", length(), run.version(), run.date(),
            run.machine()));
    }

    private String length() {
        return run.length().name().toLowerCase(Locale.ROOT);
    }

    private void truePath(StringBuilder out) {
        List<StabilityRow> paths = TruePathPlot.of(rows);
        if (paths.isEmpty()) {
            return;
        }
        out.append("\n## How long a path is true\n\n").append(PictureTag.of(TruePathPlot.PNG, TruePathPlot.DARK_PNG,
            "True impacts of each disc, by rung and number of discs")).append("\n\nDiscs move in a box until an impact "
            + "is another than in truth, or at another time.\nEach impact multiplies any rounding, also that of the "
            + "state between turns. So the number of\nimpacts of each disc counts, not that of turns.");
        int least = Integer.MAX_VALUE;
        int most = 0;
        int steps = 0;
        for (StabilityRow row : paths) {
            for (Figure figure : TruePathPlot.figures(row.seen())) {
                if (row.rung().startsWith(STEPS)) {
                    steps = Math.max(steps, figure.each());
                } else {
                    least = Math.min(least, figure.each());
                    most = Math.max(most, figure.each());
                }
            }
        }
        out.append(most == 0 ? "" : String.format(Locale.ROOT, " On event rungs, those with exact times, a disc's\n"
            + "path is true for %d to %d impacts, whatever the arithmetic; with steps %s. After a thousand turns "
            + "trust\nonly sums over all bodies, such as energy, and no single path.", least, most, steps == 0
            ? "not for one" : "for at most " + steps)).append('\n');
    }

    private void overview(StringBuilder out) {
        List<String> rungs = rows.stream().map(StabilityRow::rung).distinct().filter(rung -> !rung.startsWith(STEPS))
            .toList();
        out.append("\n## The cases\n\n| case | if it holds | ").append(String.join(" | ", rungs))
            .append(" |\n|---|---|").append("---|".repeat(rungs.size())).append('\n');
        Map<String, String> meanings = meanings();
        cases.forEach((name, of) -> {
            out.append("| [").append(name).append("](#").append(anchor(name)).append(") | ")
                .append(meanings.getOrDefault(name, "")).append(" |");
            for (String rung : rungs) {
                out.append(' ').append(of.stream().filter(row -> row.rung().equals(rung)).map(StabilityPage::word)
                    .findFirst().orElse("")).append(" |");
            }
            out.append('\n');
        });
        out.append("\nReported: nothing is demanded of this rung. Its figures stand for comparison, as those of steps "
            + "do.\n");
    }

    /** The name of a heading, as code hosts make it. */
    static String anchor(String name) {
        return name.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9 -]", "").replace(' ', '-');
    }

    private static String word(StabilityRow row) {
        return row.failed() ? "**fails**" : row.seen().verdict().name().toLowerCase(Locale.ROOT);
    }

    private void cite(StringBuilder out) {
        StabilityRow row = rows.get(rows.size() - 1);
        out.append("\n## How to cite\n\nName version, date and machine, the case, the rung and the length. The figures "
            + "of a seed are equal on every machine;\nseconds are not. Each row of [stability.csv](stability.csv) has "
            + "all of it, the whole bound too:\n\n> Steward ").append(run.version())
            .append(", table of extremes, ").append(length()).append(" version, ").append(run.date()).append(", ")
            .append(run.machine()).append(": case \"").append(row.name()).append("\", rung ").append(row.rung())
            .append(", ").append(word(row)).append(" (").append(row.seen().text()).append(").\n\n");
    }

    /** Rungs that saw the same share a line. */
    private void figures(String name, List<StabilityRow> of, StringBuilder out) {
        out.append("\n### ").append(name).append("\n\nBound: ").append(of.get(0).demand())
            .append(".\n\n| rung | verdict | seen |\n|---|---|---|\n");
        Map<String, List<String>> rungs = new LinkedHashMap<>();
        of.forEach(row -> rungs.computeIfAbsent(word(row) + " | " + row.seen().text().replace("|", "\\|"),
            seen -> new ArrayList<>()).add(row.rung()));
        rungs.forEach((seen, names) -> out.append("| ").append(String.join(", ", names)).append(" | ").append(seen)
            .append(" |\n"));
    }
}
