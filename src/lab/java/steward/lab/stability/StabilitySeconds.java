package steward.lab.stability;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import steward.lab.trial.RunLength;

/**
 * Approximate seconds of each row of the stability table: for announcements and for the time left. The resource {@code
 * stability-seconds.csv} has a line per case and rung, with the seconds of {@code steward stability --quick} and of
 * {@code steward stability} as their {@code --out} told them on a machine with two cores; the last column says how many
 * times as much work the long version does as the normal one, by the counts in the cases.
 */
public final class StabilitySeconds {

    private static final String RESOURCE = "/steward/stability-seconds.csv";
    private static final int COLUMNS = 5;
    /** For a row that is not in the table. */
    private static final double UNKNOWN = 1;
    /** Least seconds of a row: the table itself, and the start of the code. */
    private static final double LEAST = 0.005;
    /** How many impacts a crowd has in the normal version. */
    private static final double CROWD_IMPACTS = 1e6;
    private static final String CROWD = "crowd of ";
    private static final String STEPS = "step/";

    private final Map<String, double[]> rows = new HashMap<>();

    private StabilitySeconds() { }

    /** Reads the resource. */
    public static StabilitySeconds read() {
        StabilitySeconds table = new StabilitySeconds();
        try (BufferedReader lines = new BufferedReader(new InputStreamReader(
                StabilitySeconds.class.getResourceAsStream(RESOURCE), StandardCharsets.UTF_8))) {
            lines.readLine();
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                table.add(line.split(";"));
            }
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
        return table;
    }

    private void add(String[] cells) {
        double normal = Double.parseDouble(cells[COLUMNS - 2]);
        rows.put(key(cells[0], cells[1]), new double[] {Double.parseDouble(cells[2]), normal,
            normal * Double.parseDouble(cells[COLUMNS - 1])});
    }

    private static String key(String name, String rung) {
        return name + ";" + rung;
    }

    /** True if the row is in the table. */
    public boolean knows(String name, String rung) {
        return rows.containsKey(key(name, rung));
    }

    /**
     * Seconds of a row, approximately.
     *
     * @param name    of the case
     * @param impacts of each crowd on the event rungs, or 0 for the number of the run length
     */
    public double of(String name, String rung, RunLength size, long impacts) {
        double[] row = rows.get(key(name, rung));
        if (row == null) {
            return UNKNOWN;
        }
        boolean played = impacts > 0 && name.startsWith(CROWD) && !rung.startsWith(STEPS);
        return Math.max(LEAST, played ? row[RunLength.NORMAL.ordinal()] * impacts / CROWD_IMPACTS
            : row[size.ordinal()]);
    }
}
