package steward.cli;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Patterns that a line of the standard error must not have: words that only those who program in Java understand. */
final class BadMessage {

    private static final Map<Pattern, String> BAD = new LinkedHashMap<>();

    private static final Pattern CLASS = Pattern.compile("\\b[A-Z][A-Za-z]*(?:Exception|Error|Node|Token|Path)\\b");
    private static final Pattern TYPE = Pattern.compile("\\bint\\b|\\blong value\\b|\\bdouble value\\b");

    static {
        BAD.put(Pattern.compile("^\\s*at .*\\.java:"), "a line of a stack trace");
        BAD.put(Pattern.compile("this should not have happened"), "an error of the program");
        BAD.put(Pattern.compile("\\b(?:java|javax|jdk|sun|steward|tools|picocli)\\.[a-z]+[.A-Z]"), "a Java package");
        BAD.put(CLASS, "a Java class");
        BAD.put(Pattern.compile("\\b(?:VALUE|START|END|NOT|PROPERTY)_[A-Z_]+"), "a token of the parser");
        BAD.put(TYPE, "a Java type");
        BAD.put(Pattern.compile(": null$|'null'|\\(null\\)"), "null");
        BAD.put(Pattern.compile("[\\x00-\\x08\\x0b-\\x1f\\x7f]"), "a control character");
    }

    /** Only behind a file's name: elsewhere a message repeats what a person wrote, which may hold anything. */
    private static final Pattern NO_PLACE =
        Pattern.compile("^steward: (?:standard input|TMP/[\\w./-]+)(?::\\d+)?:(?:0|-\\d+)\\b");

    /** A message is for one look. */
    private static final int LONGEST = 1500;

    private BadMessage() {
    }

    /** Returns the fault of a line, or {@code null}. */
    static String problem(String line) {
        return problem(line, "");
    }

    /** Returns the fault of a message that may repeat words of an input. */
    static String problem(String line, String input) {
        for (Map.Entry<Pattern, String> bad : BAD.entrySet()) {
            Matcher found = bad.getKey().matcher(line);
            boolean ofInput = bad.getKey() == TYPE || bad.getKey() == CLASS;
            if (found.find() && !(ofInput && input.contains(found.group()))) {
                return bad.getValue();
            }
        }
        if (NO_PLACE.matcher(line).find()) {
            return "a place that there is not";
        }
        return line.length() > LONGEST ? "more than " + LONGEST + " characters" : null;
    }
}
