package steward.cli.shared;

import java.util.Collection;
import java.util.Set;
import picocli.CommandLine.IExecutionStrategy;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.RunLast;

/**
 * Refusal of calls in which an option or parameter for a file is an empty text, as when a shell variable was not set.
 */
public final class EmptyValues implements IExecutionStrategy {

    /** Placeholders of files and folders in the help. */
    private static final Set<String> FILES = Set.of("FILE", "FILE|NAME", "DIR", "REPLAY", "NEW", "HTML", "SCENE",
        "PUB", "KEY");

    @Override
    public int execute(ParseResult call) {
        for (ParseResult each = call; each != null; each = each.hasSubcommand() ? each.subcommand() : null) {
            for (ArgSpec argument : each.matchedArgs()) {
                if (FILES.contains(argument.paramLabel()) && isEmpty(argument.getValue())) {
                    String name = argument.isOption() ? ((OptionSpec) argument).longestName() : argument.paramLabel();
                    throw new ParameterException(each.commandSpec().commandLine(),
                        name + ": found an empty text, expected " + argument.paramLabel());
                }
            }
        }
        return new RunLast().execute(call);
    }

    /** True if a value is an empty text, or one of those of an option that can be repeated is. */
    private static boolean isEmpty(Object value) {
        return "".equals(value) || value instanceof Collection<?> values && values.contains("");
    }
}
