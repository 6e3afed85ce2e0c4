package steward.cli;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import steward.cli.options.ProgramCommand;
import steward.cli.options.SandboxOptions;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.UnknownWord;

/** {@code steward help}: prints the help of the program or of one command. */
@Command(name = HelpCommand.NAME, description = "Prints the help of the program, or of a command.",
    footer = {"", "'steward help sandbox' describes the options for isolating bots.",
        "", "Examples:", "  steward help match", "  steward help league run"})
final class HelpCommand extends ProgramCommand {

    static final String NAME = "help";

    /** The word for options that several commands take. */
    private static final String SANDBOX = "sandbox";

    @Spec
    private CommandSpec spec;

    @Parameters(arity = "0..*", paramLabel = "COMMAND", completionCandidates = Commands.class,
        description = "One of the commands, and one of its own commands if it has any.")
    private List<String> words = List.of();

    /** The names of all commands. */
    static final class Commands implements Iterable<String> {

        @Override
        public Iterator<String> iterator() {
            return Main.commands().iterator();
        }
    }

    @Override
    public Integer call() {
        if (words.equals(List.of(SANDBOX))) {
            streams.out().print(sandbox());
            return ExitStatus.DONE;
        }
        CommandLine found = spec.root().commandLine();
        for (String word : words) {
            Map<String, CommandLine> commands = found.getSubcommands();
            if (commands.isEmpty()) {
                throw new ParameterException(found, "'" + word + "': found more than "
                    + found.getCommandSpec().qualifiedName() + " takes");
            }
            if (!commands.containsKey(word)) {
                Collection<String> known = new ArrayList<>(commands.keySet());
                known.add(SANDBOX);
                throw new ParameterException(found, UnknownWord.command(word,
                    found == spec.root().commandLine() ? known : commands.keySet()));
            }
            found = commands.get(word);
        }
        found.usage(streams.out());
        return ExitStatus.DONE;
    }

    private static String sandbox() {
        CommandSpec options = CommandSpec.forAnnotatedObject(new SandboxOptions());
        options.usageMessage().sortOptions(false).width(Main.WIDTH);
        return "How bots are isolated from this machine and from each other: options of 'match',\n"
            + "'play', 'referee', 'check', 'sprt', 'tune' and 'worker'. docs/security.md says\n"
            + "what each level holds, 'steward doctor' what works here.\n"
            + new CommandLine.Help(options, CommandLine.Help.Ansi.OFF).optionList();
    }
}
