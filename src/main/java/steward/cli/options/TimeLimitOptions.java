package steward.cli.options;

import picocli.CommandLine.Option;

/** The options that change a scene's time limits. */
public final class TimeLimitOptions {

    private final CallCheck check = CallCheck.withHelp();

    @Option(names = "--time-factor", paramLabel = "X", description = "Multiplies the scene's time limits.")
    private Double timeFactor;

    @Option(names = "--no-deadline", description = "Waits for answers without end.")
    private boolean noDeadline;

    /** By what the limits are multiplied; {@code POSITIVE_INFINITY} for none. */
    public double factor() {
        check.exclusive("--no-deadline", noDeadline, "--time-factor", timeFactor != null);
        check.that(timeFactor == null || timeFactor > 0 && timeFactor < Double.POSITIVE_INFINITY,
            "--time-factor: found " + timeFactor + ", expected a finite number above 0");
        return noDeadline ? Double.POSITIVE_INFINITY : timeFactor == null ? 1 : timeFactor;
    }
}
