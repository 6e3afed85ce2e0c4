package steward.cli.options;

import java.util.Arrays;
import java.util.Iterator;
import picocli.CommandLine.Option;
import steward.bot.TimeBasis;
import steward.bot.accounting.TreeSampler;

/** The options that change a scene's time limits. */
@OptionSection("Time limits")
public final class TimeLimitOptions {

    private static final String WALL = "wall";

    /** Values of {@code --time}. */
    static final class Bases implements Iterable<String> {

        @Override
        public Iterator<String> iterator() {
            return Arrays.stream(TimeBasis.values()).map(TimeBasis::word).iterator();
        }
    }

    private final CallCheck check = CallCheck.withHelp();

    @Option(names = "--time-factor", paramLabel = "X", description = "Multiplies the scene's time limits.")
    private Double timeFactor;

    @Option(names = "--no-deadline", description = "Waits for answers without end.")
    private boolean noDeadline;

    @Option(names = "--time", paramLabel = "wall|cpu", defaultValue = WALL, completionCandidates = Bases.class,
        description = "What the limits are limits of: time by the clock, as on the site (wall, the default), or the "
            + "CPU time of the bot's processes, all threads summed (cpu), by the clock ten times as much at most. "
            + "Needs Linux.")
    private String time;

    /** By what the limits are multiplied; {@code POSITIVE_INFINITY} for none. */
    public double factor() {
        check.exclusive("--no-deadline", noDeadline, "--time-factor", timeFactor != null);
        check.that(timeFactor == null || timeFactor > 0 && timeFactor < Double.POSITIVE_INFINITY,
            "--time-factor: found " + timeFactor + ", expected a finite number above 0");
        return noDeadline ? Double.POSITIVE_INFINITY : timeFactor == null ? 1 : timeFactor;
    }

    /** Returns the clock of the limits. */
    public TimeBasis basis() {
        check.that(TimeBasis.of(time).isPresent(), "--time: found '" + time + "', expected wall or cpu");
        TimeBasis basis = TimeBasis.of(time).get();
        check.exclusive("--no-deadline", noDeadline, "--time cpu", basis == TimeBasis.CPU);
        check.that(basis == TimeBasis.WALL || TreeSampler.showsCpuTime(),
            "--time cpu: this system does not show the CPU time of processes (no /proc/self/stat), expected wall");
        return basis;
    }
}
