package steward.lab.stability;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import steward.files.Resources;
import steward.lab.trial.RunLength;

/**
 * Approximate seconds of each row of the stability table: for announcements and for the time left. The resource {@code
 * stability-seconds.csv} has a line per case and length of a run, with a column for each rung: the seconds of {@code
 * steward stability --quick} and of {@code steward stability} as their {@code --out} told them on a machine with two
 * cores, and those of the long version, from the normal ones by the counts in the cases.
 */
public final class StabilitySeconds {

    private static final String RESOURCE = "/steward/stability-seconds.csv";
    private static final String SEPARATOR = ";";
    /** Columns before those of the rungs. */
    private static final int NAMES = 2;
    /** For a row that is not in the table. */
    private static final double UNKNOWN = 1;
    /** Least seconds of a row: the table itself, and the start of the code. */
    private static final double LEAST = 0.005;
    /** How many impacts a crowd has in the normal version. */
    private static final double CROWD_IMPACTS = 1e6;
    private static final String CROWD = "crowd of ";
    private static final String STEPS = "step/";

    private final Map<String, Double> cells = new HashMap<>();

    private StabilitySeconds() { }

    public static StabilitySeconds read() {
        StabilitySeconds table = new StabilitySeconds();
        List<String> lines = Resources.text(RESOURCE).lines().toList();
        String[] rungs = lines.get(0).split(SEPARATOR);
        for (String line : lines.subList(1, lines.size())) {
            String[] words = line.split(SEPARATOR);
            for (int k = NAMES; k < words.length; k++) {
                table.cells.put(key(words[0], rungs[k], words[1]), Double.parseDouble(words[k]));
            }
        }
        return table;
    }

    private static String key(String name, String rung, String length) {
        return String.join(SEPARATOR, name, rung, length.toLowerCase(Locale.ROOT));
    }

    public boolean knows(String name, String rung) {
        return cells.containsKey(key(name, rung, RunLength.NORMAL.name()));
    }

    /**
     * Seconds of a row, approximately.
     *
     * @param impacts of each crowd on the event rungs, or 0 for the number of the run length
     */
    public double of(String name, String rung, RunLength size, long impacts) {
        boolean played = impacts > 0 && name.startsWith(CROWD) && !rung.startsWith(STEPS);
        double seconds = cells.getOrDefault(key(name, rung, (played ? RunLength.NORMAL : size).name()), UNKNOWN);
        return Math.max(LEAST, played ? seconds * impacts / CROWD_IMPACTS : seconds);
    }
}
