package steward.cli.shared;

import picocli.CommandLine.IExecutionStrategy;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.RunLast;

/**
 * Runs a command unless one of its options or parameters is an empty text, as when a shell variable was not set. Those
 * that can be repeated check their values themselves.
 */
public final class EmptyValues implements IExecutionStrategy {

    @Override
    public int execute(ParseResult call) {
        for (ParseResult each = call; each != null; each = each.hasSubcommand() ? each.subcommand() : null) {
            for (ArgSpec argument : each.matchedArgs()) {
                if (argument.type() == String.class && "".equals(argument.getValue())) {
                    String name = argument.isOption() ? ((OptionSpec) argument).longestName() : argument.paramLabel();
                    throw new ParameterException(each.commandSpec().commandLine(),
                        name + ": found an empty text, expected " + argument.paramLabel());
                }
            }
        }
        return new RunLast().execute(call);
    }
}
