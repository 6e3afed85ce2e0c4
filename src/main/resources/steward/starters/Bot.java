{{#codingame}}
import java.util.Scanner;
{{/codingame}}
{{#json}}
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
{{/json}}

/**
 * A starter bot for {{game}}: copy it and make it better. It needs nothing but Java 17.
 *
{{#codingame}}
 * <p>It speaks CodinGame's lines: words and numbers. The referee sends some before the first turn and some every turn,
 * and every turn it waits for an answer. Use stderr for your own notes: System.err.println("hello")
{{/codingame}}
{{#json}}
 * <p>The referee sends one JSON object a line: a "setup", a "turn" for every turn, and an "end". Every "turn" is
 * answered by one line. Use stderr for your own notes: System.err.println("hello")
{{/json}}
 */
public class Bot {
{{#records}}

    record {{type}}({{#fields}}{{#wrap}}
        {{/wrap}}{{#int}}int{{/int}}{{#real}}double{{/real}}{{#word}}String{{/word}} {{name}}{{^last}}, {{/last}}{{/fields}}) { }
{{/records}}

    public static void main(String[] arguments){{#json}} throws IOException{{/json}} {
{{#json}}
        Map<String, Object> frame = readFrame();            // before the first turn
{{/json}}
{{#codingame}}
        // Before the first turn.
{{/codingame}}
{{#readings}}
{{#every}}
        for (;;) {
{{#json}}
            frame = readFrame();                            // every turn
{{/json}}
{{#codingame}}
            // Every turn. All of it has to be read, whether you use it or not.
{{/codingame}}
{{/every}}
{{#inputs}}
{{#variables}}
        {{step}}{{#int}}int{{/int}}{{#real}}double{{/real}}{{#word}}String{{/word}} {{name}} = {{kind}}({{#json}}frame, "{{key}}"{{/json}});
{{/variables}}
{{#record}}
        {{step}}{{type}} {{name}} = read{{type}}({{#json}}object(frame.get("{{key}}")){{/json}});
{{/record}}
{{#list}}
{{#json}}
        {{step}}{{type}}[] {{name}} = list(frame, "{{key}}").stream().map(Bot::read{{type}})
        {{step}}    .toArray({{type}}[]::new);
{{/json}}
{{#codingame}}
        {{step}}{{type}}[] {{name}} = new {{type}}[{{count}}];
        {{step}}for (int k = 0; k < {{name}}.length; k++) {
        {{step}}    {{name}}[k] = read{{type}}();
        {{step}}}
{{/codingame}}
{{/list}}
{{/inputs}}
{{/readings}}

            // Change this: it decides what you answer.
{{#notes}}
            // {{note}}
{{/notes}}
{{#json}}
            List<String> answers = new ArrayList<>();
{{/json}}
{{#commands}}
{{#list}}
{{#indexed}}
            for (int index = 0; index < {{list}}.length; index++) {
                var {{name}} = {{list}}[index];
{{/indexed}}
{{^indexed}}
            for (var {{name}} : {{list}}) {
{{/indexed}}
{{/list}}
{{^list}}
            {
{{/list}}
{{#where}}
                if (!({{where}})) {
                    continue;
                }
{{/where}}
{{#locals}}
                var {{name}} = {{value}};
{{/locals}}
{{#nearest}}
                {{type}} {{name}} = null;                   // the nearest one, if there is any
                for (var each : {{list}}) {
{{#where}}
                    if (!({{where}})) {
                        continue;
                    }
{{/where}}
                    if ({{name}} == null || distance({{from}}.x, {{from}}.y, each.x, each.y)
                        < distance({{from}}.x, {{from}}.y, {{name}}.x, {{name}}.y)) {
                        {{name}} = each;
                    }
                }
{{/nearest}}
{{#choices}}
{{#if}}
                if ({{when}}) {
{{/if}}
{{#elseif}}
                } else if ({{when}}) {
{{/elseif}}
{{#else}}
                } else {
{{/else}}
                {{#nested}}    {{/nested}}{{#codingame}}print({{#parts}}{{#wrap}}
                        {{/wrap}}{{value}}{{^last}}, {{/last}}{{/parts}}){{/codingame}}{{#json}}answers.add(command({{#parts}}{{#wrap}}
                        {{/wrap}}"{{key}}", {{value}}{{^last}}, {{/last}}{{/parts}})){{/json}};
{{#end}}
                }
{{/end}}
{{/choices}}
            }
{{/commands}}
{{#json}}
            System.out.println({{#answer}}"{\"{{answer}}\": [" + String.join(", ", answers) + "]}"{{/answer}}{{^answer}}answers.get(0){{/answer}});
{{/json}}
            System.out.flush();                             // without it the referee could wait in vain
        }
    }
{{#distance}}

    static double distance(double x, double y, double otherX, double otherY) {
        return Math.hypot(otherX - x, otherY - y);
    }
{{/distance}}
{{#degrees}}

    /** How many degrees, 0..180, a heading is off the direction from a place to another. */
    static double degreesOff(double x, double y, double heading, double otherX, double otherY) {
        double wanted = Math.toDegrees(Math.atan2(otherY - y, otherX - x));
        return Math.abs(Math.IEEEremainder(wanted - heading, 360));
    }
{{/degrees}}

    // Reading and writing. There is nothing to change from here on.
{{#records}}

    static {{type}} read{{type}}({{#json}}Map<String, Object> each{{/json}}) {
        return new {{type}}({{#fields}}{{#wrap}}
            {{/wrap}}{{kind}}({{#json}}each, "{{key}}"{{/json}}){{^last}}, {{/last}}{{/fields}});
    }
{{/records}}
{{#codingame}}

    static final Scanner IN = new Scanner(System.in);

    /** The next word; the program ends when the referee closes our input. */
    static String word() {
        if (!IN.hasNext()) {
            System.exit(0);
        }
        return IN.next();
    }

    static int integer() {
        return Integer.parseInt(word());
    }

    static double number() {
        return Double.parseDouble(word());
    }

    /** Prints a line of words. */
    static void print(Object... words) {
        String[] line = new String[words.length];
        for (int k = 0; k < line.length; k++) {
            line[k] = String.valueOf(words[k]);
        }
        System.out.println(String.join(" ", line));
    }
{{/codingame}}
{{#json}}

    static final BufferedReader IN = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));

    /** The next frame; the program ends with the last one. */
    static Map<String, Object> readFrame() throws IOException {
        String line = IN.readLine();
        Map<String, Object> frame = line == null ? Map.of("type", "end") : object(new Json(line).value());
        if (frame.get("type").equals("end")) {
            System.exit(0);
        }
        return frame;
    }

    /** A number of an object, -1 if there is none. */
    static double number(Map<String, Object> values, String key) {
        return values.get(key) instanceof Double value ? value : -1;
    }

    static int integer(Map<String, Object> values, String key) {
        return (int) number(values, key);
    }

    static String word(Map<String, Object> values, String key) {
        return values.get(key) instanceof String value ? value : "";
    }

    @SuppressWarnings("unchecked")
    static Map<String, Object> object(Object value) {
        return value instanceof Map ? (Map<String, Object>) value : Map.of();
    }

    static List<Map<String, Object>> list(Map<String, Object> values, String key) {
        List<Map<String, Object>> found = new ArrayList<>();
        if (values.get(key) instanceof List<?> list) {
            list.forEach(each -> found.add(object(each)));
        }
        return found;
    }

    /** A JSON object of keys and values, one after the other. */
    static String command(Object... pairs) {
        StringBuilder json = new StringBuilder("{");
        for (int k = 0; k < pairs.length; k += 2) {
            Object value = pairs[k + 1] instanceof String text ? "\"" + text + "\"" : pairs[k + 1];
            json.append(k == 0 ? "" : ", ").append("\"" + pairs[k] + "\": ").append(value);
        }
        return json.append("}").toString();
    }

    /** A small reader of JSON: objects as maps, arrays as lists, numbers as Double, also strings, Boolean and null. */
    static final class Json {

        final String text;
        int at;

        Json(String text) {
            this.text = text;
        }

        char next() {
            while (Character.isWhitespace(text.charAt(at))) {
                at++;
            }
            return text.charAt(at);
        }

        boolean skip(char wanted) {
            boolean there = next() == wanted;
            at += there ? 1 : 0;
            return there;
        }

        Object value() {
            if (skip('{')) {
                Map<String, Object> map = new LinkedHashMap<>();
                while (!skip('}')) {
                    skip(',');
                    next();
                    String key = string();
                    skip(':');
                    map.put(key, value());
                }
                return map;
            }
            if (skip('[')) {
                List<Object> list = new ArrayList<>();
                while (!skip(']')) {
                    skip(',');
                    list.add(value());
                }
                return list;
            }
            if (next() == '"') {
                return string();
            }
            int from = at;
            while (at < text.length() && ",]} \t".indexOf(text.charAt(at)) < 0) {
                at++;
            }
            String word = text.substring(from, at);
            return word.equals("null") ? null
                : word.equals("true") || word.equals("false") ? (Object) word.equals("true")
                : (Object) Double.valueOf(word);
        }

        String string() {
            StringBuilder string = new StringBuilder();
            for (at++; text.charAt(at) != '"'; at++) {
                char c = text.charAt(at);
                if (c == '\\') {
                    c = text.charAt(++at);
                    if (c == 'u') {
                        c = (char) Integer.parseInt(text.substring(at + 1, at + 5), 16);
                        at += 4;
                    } else {
                        c = c == 'n' ? '\n' : c == 't' ? '\t' : c == 'r' ? '\r' : c == 'b' ? '\b' : c == 'f' ? '\f' : c;
                    }
                }
                string.append(c);
            }
            at++;
            return string.toString();
        }
    }
{{/json}}
}
