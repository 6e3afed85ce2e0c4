package steward.cli.setup;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Template of a source file in the notation of Mustache. {@code {{name}}} is a value. The text between {@code
 * {{#name}}} and {@code {{/name}}} is written for each map of a list, or once if the value is true or a text; {@code
 * {{^name}}} writes its text if there is no such value. A section's mark alone on its line leaves no line. In a list,
 * {@code last} marks the last element. Blanks at the end of lines are left out.
 */
final class SourceTemplate {

    private static final Pattern TAG = Pattern.compile("\\{\\{([#^/]?)(\\w+)\\}\\}");
    private static final Pattern ALONE = Pattern.compile("(?m)^[ ]*(\\{\\{[#^/]\\w+\\}\\})[ ]*\\n");

    private static final Pattern BLANKS = Pattern.compile("(?m) +$");

    private final String text;
    private final StringBuilder out = new StringBuilder();
    private final Deque<Map<String, Object>> scopes = new ArrayDeque<>();

    private SourceTemplate(String text) {
        this.text = ALONE.matcher(text).replaceAll("$1");
    }

    /** @throws IllegalStateException if a value or the end of a section is missing */
    static String render(String text, Map<String, Object> values) {
        SourceTemplate template = new SourceTemplate(text);
        template.scopes.push(values);
        template.render(0, template.text.length());
        return BLANKS.matcher(template.out).replaceAll("");
    }

    private void render(int from, int to) {
        Matcher tag = TAG.matcher(text).region(from, to);
        int at = from;
        while (tag.find()) {
            out.append(text, at, tag.start());
            at = tag.end();
            Object value = value(tag.group(2));
            if (tag.group(1).isEmpty()) {
                if (value == null) {
                    throw new IllegalStateException("found no value of {{" + tag.group(2) + "}}, expected one");
                }
                out.append(value);
                continue;
            }
            int end = end(tag.group(2), at, to);
            if (tag.group(1).equals("#")) {
                section(value, at, end);
            } else if (!isThere(value)) {
                render(at, end);
            }
            at = end + "{{/}}".length() + tag.group(2).length();
            tag.region(at, to);
        }
        out.append(text, at, to);
    }

    private void section(Object value, int from, int to) {
        if (value instanceof List<?> list) {
            for (int k = 0; k < list.size(); k++) {
                scopes.push(Map.of("last", k == list.size() - 1));
                scopes.push(map(list.get(k)));
                render(from, to);
                scopes.pop();
                scopes.pop();
            }
        } else if (isThere(value)) {
            render(from, to);
        }
    }

    @SuppressWarnings("unchecked")
    private static Map<String, Object> map(Object value) {
        return (Map<String, Object>) value;
    }

    /** The mark that ends the section which begins at a place; sections of one name may lie in each other. */
    private int end(String name, int from, int to) {
        Matcher tag = TAG.matcher(text).region(from, to);
        int depth = 1;
        while (tag.find()) {
            depth += !tag.group(2).equals(name) || tag.group(1).isEmpty() ? 0 : tag.group(1).equals("/") ? -1 : 1;
            if (depth == 0) {
                return tag.start();
            }
        }
        throw new IllegalStateException("found no end of {{#" + name + "}}, expected {{/" + name + "}}");
    }

    /** The value of the innermost scope that has one. */
    private Object value(String name) {
        for (Map<String, Object> scope : scopes) {
            if (scope.containsKey(name)) {
                return scope.get(name);
            }
        }
        return null;
    }

    private static boolean isThere(Object value) {
        return value instanceof Boolean flag ? flag : value instanceof List<?> list ? !list.isEmpty()
            : value != null && !value.equals("");
    }
}
