package steward.cli.shared;

import java.util.Set;
import picocli.CommandLine.IExecutionStrategy;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.RunLast;

/**
 * Runs a command unless an option or parameter that names a file is an empty text, as when a shell variable was not
 * set. Those that can be repeated check their values themselves.
 */
public final class EmptyValues implements IExecutionStrategy {

    /** What stands for files and folders in the help. */
    private static final Set<String> FILES = Set.of("FILE", "FILE|NAME", "DIR", "REPLAY", "NEW", "HTML", "SCENE",
        "PUB");

    @Override
    public int execute(ParseResult call) {
        for (ParseResult each = call; each != null; each = each.hasSubcommand() ? each.subcommand() : null) {
            for (ArgSpec argument : each.matchedArgs()) {
                if (FILES.contains(argument.paramLabel()) && "".equals(argument.getValue())) {
                    String name = argument.isOption() ? ((OptionSpec) argument).longestName() : argument.paramLabel();
                    throw new ParameterException(each.commandSpec().commandLine(),
                        name + ": found an empty text, expected " + argument.paramLabel());
                }
            }
        }
        return new RunLast().execute(call);
    }
}
