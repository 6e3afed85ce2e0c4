package steward.schema;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/**
 * Takes a line of shell apart into its commands, as far as the manual uses the shell: quotes, comments, pipes,
 * redirections, variables set before a command, and command lines that are an argument of another program.
 */
final class ShellLine {

    private static final Pattern OURS =
        Pattern.compile("(?s).*(?:^|[\\s\"'(])(?:steward|\\./gradlew)(?:\\s.*|[\"')]*$)");
    private static final Pattern ASSIGNMENT = Pattern.compile("[A-Za-z_]\\w*=.*");

    private final String text;
    private final List<List<String>> commands = new ArrayList<>();
    private List<String> words = new ArrayList<>();
    private StringBuilder word;
    private boolean redirected;
    private int at;

    private ShellLine(String text) {
        this.text = text;
    }

    /** The calls of {@code steward} and of {@code ./gradlew} in a line, in its order; each begins with that word. */
    static List<List<String>> calls(String line) {
        List<List<String>> calls = new ArrayList<>();
        if (!OURS.matcher(line).matches()) {
            return calls;
        }
        for (List<String> command : new ShellLine(line).split()) {
            int start = 0;
            while (start < command.size() && isBeforeCommand(command.get(start))) {
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

    private static boolean isBeforeCommand(String word) {
        return word.equals("env") || word.equals("-i") || ASSIGNMENT.matcher(word).matches();
    }

    private List<List<String>> split() {
        while (at < text.length()) {
            char c = text.charAt(at++);
            switch (c) {
                case ' ', '\t' -> endWord();
                case '|', ';', '&', '(', ')' -> endCommand();
                case '<', '>' -> {
                    endWord();
                    redirected = true;
                }
                case '\'', '"' -> quoted(c);
                case '\\' -> add(text.charAt(at++));
                case '#' -> {
                    if (word == null) {
                        at = text.length();
                    } else {
                        add(c);
                    }
                }
                default -> add(c);
            }
        }
        endCommand();
        return commands;
    }

    private void add(char c) {
        word = word == null ? new StringBuilder() : word;
        word.append(c);
    }

    private void quoted(char quote) {
        word = word == null ? new StringBuilder() : word;
        while (text.charAt(at) != quote) {
            boolean protects = quote == '"' && text.charAt(at) == '\\' && "\"\\$`".indexOf(text.charAt(at + 1)) >= 0;
            at += protects ? 1 : 0;
            add(text.charAt(at++));
        }
        at++;
    }

    private void endWord() {
        if (word != null && !redirected) {
            words.add(word.toString());
        }
        redirected = redirected && word == null;
        word = null;
    }

    private void endCommand() {
        endWord();
        redirected = false;
        if (!words.isEmpty()) {
            commands.add(words);
        }
        words = new ArrayList<>();
    }
}
