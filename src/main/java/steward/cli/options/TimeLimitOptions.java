package steward.cli.options;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Option;
import steward.bot.TimeBasis;
import steward.bot.accounting.TreeSampler;
import steward.contest.Contest;
import steward.contest.Contest.Entrant;
import steward.files.InputException;
import steward.match.OwnLimits;
import steward.text.NearestName;

/** Options that change a scene's time limits. */
@OptionSection("Time limits")
public final class TimeLimitOptions {

    private static final String WALL = "wall";
    private static final String TIME_LIMIT = "--time-limit";
    private static final String FORM = "NAME=" + OwnLimits.FORM;

    private final CallCheck check = CallCheck.withHelp();

    @Option(names = "--time-factor", paramLabel = "X", description = "Multiplies the scene's time limits.")
    private Double timeFactor;

    @Option(names = "--no-deadline", description = "Waits for answers without a limit.")
    private boolean noDeadline;

    @Option(names = "--time", paramLabel = "wall|cpu", defaultValue = WALL,
        description = "The clock of the limits. wall (default): real time, as on the site. cpu: CPU time of the "
            + "bot's processes, all threads summed, and at most ten times as much real time; needs Linux.")
    private TimeBasis time;

    @Option(names = TIME_LIMIT, paramLabel = FORM, description = "Gives one bot its own limits in milliseconds: "
        + "MS for each answer, FIRST for the first one (default: the scene's, but at least MS). Can be repeated.")
    private List<String> limits = new ArrayList<>();

    /** By what the limits are multiplied; {@code POSITIVE_INFINITY} for none. */
    public double factor() {
        check.exclusive("--no-deadline", noDeadline, "--time-factor", timeFactor != null);
        check.that(timeFactor == null || timeFactor > 0 && timeFactor < Double.POSITIVE_INFINITY,
            "--time-factor: found " + timeFactor + ", expected a finite number above 0");
        return noDeadline ? Double.POSITIVE_INFINITY : timeFactor == null ? 1 : timeFactor;
    }

    /** Returns the clock of the limits. */
    public TimeBasis basis() {
        check.exclusive("--no-deadline", noDeadline, "--time cpu", time == TimeBasis.CPU);
        check.that(time == TimeBasis.WALL || TreeSampler.showsCpuTime(),
            "--time cpu: this system does not show the CPU time of processes (no /proc/self/stat), expected wall");
        return time;
    }

    /** Returns a contest with this clock, and with bots that have limits of their own. */
    public Contest limit(Contest contest) {
        return contest.limitedBy(basis()).limitedBy(own(contest.entrants().stream().map(Entrant::name).toList()));
    }

    /**
     * Returns the limits of bots that have their own, by their names.
     *
     * @param bots names of all bots
     */
    public Map<String, OwnLimits> own(Collection<String> bots) {
        Map<String, OwnLimits> own = new HashMap<>();
        for (String typed : limits) {
            int sign = typed.lastIndexOf('=');
            check.that(sign > 0, TIME_LIMIT + ": found '" + typed + "', expected " + FORM + ", such as "
                + bots.stream().findFirst().orElse("mine") + "=60");
            String name = typed.substring(0, sign);
            check.that(bots.contains(name), TIME_LIMIT + ": found no bot '" + name + "', expected one of "
                + String.join(", ", new LinkedHashSet<>(bots)) + NearestName.question(name, List.copyOf(bots), "'"));
            OwnLimits limits = InputException.of(TIME_LIMIT + " " + name + ": ",
                () -> OwnLimits.parse(typed.substring(sign + 1)));
            check.that(own.put(name, limits) == null, TIME_LIMIT + ": found '" + name
                + "' a second time, expected each bot once");
        }
        return own;
    }
}
