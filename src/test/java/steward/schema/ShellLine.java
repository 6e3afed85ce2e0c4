package steward.schema;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Commands of a line of shell, as far as the manual uses the shell: quotes, comments, pipes, redirections, variables
 * set before a command, and command lines that are an argument of another program.
 */
final class ShellLine {

    private static final Pattern OURS =
        Pattern.compile("(?s).*(?:^|[\\s\"'(])(?:steward|\\./gradlew)(?:\\s.*|[\"')]*$)");
    private static final Pattern BEFORE_COMMAND = Pattern.compile("(?s)env|-i|[A-Za-z_]\\w*=.*");
    /** A part of a word, in single quotes, in double ones, after a backslash or bare; or what ends a word. */
    private static final Pattern PART = Pattern.compile("(?s)'(?<single>[^']*)'|\"(?<twice>(?:\\\\.|[^\"\\\\])*)\""
        + "|\\\\(?<escaped>.)|(?<end>(?<![^ \\t|;&()])#.*|[|;&()])|(?<redirection>[<>])|[ \\t]+|(?<bare>.)");

    private ShellLine() {
    }

    /** The calls of {@code steward} and of {@code ./gradlew} in a line, in its order; each begins with that word. */
    static List<List<String>> calls(String line) {
        List<List<String>> calls = new ArrayList<>();
        if (!OURS.matcher(line).matches()) {
            return calls;
        }
        for (List<String> command : commands(line)) {
            int start = 0;
            while (start < command.size() && BEFORE_COMMAND.matcher(command.get(start)).matches()) {
                start++;
            }
            List<String> rest = command.subList(start, command.size());
            if (!rest.isEmpty() && (rest.get(0).equals("steward") || rest.get(0).equals("./gradlew"))) {
                calls.add(List.copyOf(rest));
            } else {
                rest.stream().filter(argument -> argument.startsWith("steward ")).forEach(
                    argument -> calls.addAll(calls(argument)));
            }
        }
        return calls;
    }

    private static List<List<String>> commands(String line) {
        List<List<String>> commands = new ArrayList<>(List.of(new ArrayList<>()));
        String word = null;
        boolean redirected = false;
        Matcher part = PART.matcher(line + ";");
        while (part.find()) {
            String twice = part.group("twice");
            String text = part.group("single") != null ? part.group("single")
                : twice != null ? twice.replaceAll("\\\\([\"\\\\$`])", "$1")
                : part.group("escaped") != null ? part.group("escaped") : part.group("bare");
            if (text != null) {
                word = word == null ? text : word + text;
                continue;
            }
            if (word != null && !redirected) {
                commands.get(commands.size() - 1).add(word);
            }
            redirected = part.group("redirection") != null || redirected && word == null && part.group("end") == null;
            word = null;
            if (part.group("end") != null) {
                commands.add(new ArrayList<>());
            }
        }
        return commands;
    }
}
