package steward.cli.shared;

import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** The options that change a scene's time limits. */
public final class TimeLimitOptions {

    @Option(names = "--time-factor", paramLabel = "X", description = "Multiply the scene's time limits.")
    private Double timeFactor;

    @Option(names = "--no-deadline", description = "Wait for answers without end.")
    private boolean noDeadline;

    /** By what the limits are multiplied; {@code POSITIVE_INFINITY} for none. */
    public double factor(CommandSpec spec) {
        if (noDeadline && timeFactor != null) {
            throw new ParameterException(spec.commandLine(), "--no-deadline and --time-factor exclude each other");
        }
        if (timeFactor != null && !(timeFactor > 0 && timeFactor < Double.POSITIVE_INFINITY)) {
            throw new ParameterException(spec.commandLine(),
                "--time-factor: found " + timeFactor + ", expected a number above 0");
        }
        return noDeadline ? Double.POSITIVE_INFINITY : timeFactor == null ? 1 : timeFactor;
    }
}
