package steward.cli;

import picocli.AutoComplete;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.files.Resources;

/** {@code steward completion}: prints a script with which a shell completes commands and options. */
@Command(name = CompletionCommand.NAME, description = "Prints a script for bash and zsh that completes commands.",
    footer = {"", "Example, for the running shell:", "  source <(steward completion)"})
final class CompletionCommand extends ProgramCommand {

    static final String NAME = "completion";

    /** With this line, picocli has no files completed where a command has options with fixed words. */
    private static final String NO_FILES = "  type compopt &>/dev/null && compopt +o default\n";
    private static final String COMPLETE = "complete -F _complete_steward -o default steward steward.sh steward.bash\n";
    /** Name of the resource that stands in its place. */
    private static final String WORDS = "/steward/completion.bash";

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        String script = AutoComplete.bash("steward", spec.root().commandLine());
        streams.out().print(replaced(replaced(script, NO_FILES, ""), COMPLETE, Resources.text(WORDS)));
        return ExitStatus.DONE;
    }

    private static String replaced(String script, String text, String by) {
        if (!script.contains(text)) {
            throw new IllegalStateException("the script for completion has no '" + text.strip() + "'");
        }
        return script.replace(text, by);
    }
}
