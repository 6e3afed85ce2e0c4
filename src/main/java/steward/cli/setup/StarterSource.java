package steward.cli.setup;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import steward.files.Resources;
import steward.game.BotStub;
import steward.game.BotStub.Choice;
import steward.game.BotStub.Command;
import steward.game.BotStub.Field;
import steward.game.BotStub.Input;
import steward.game.BotStub.Kind;
import steward.match.Protocol;

/** Source of a starter bot: a game's {@link BotStub} in the template of a language. */
record StarterSource(StarterLanguage language, BotStub stub) {

    /** Number of fields in a line of source. */
    private static final int FIELDS_A_LINE = 4;
    /** Characters of a command that stands in one line. */
    private static final int ONE_LINE = 80;

    static String of(StarterLanguage language, Protocol protocol, String game, BotStub stub) {
        Map<String, Object> values = new StarterSource(language, stub).values();
        values.put("game", game);
        values.put("json", protocol == Protocol.JSON);
        values.put("codingame", protocol == Protocol.CODINGAME);
        return SourceTemplate.render(Resources.text("/steward/starters/" + language.source()), values);
    }

    /** Stands for what a game does not declare. */
    static BotStub undeclared(Protocol protocol, String game) {
        String note = "The game " + game + " does not declare its "
            + (protocol == Protocol.JSON ? "frames: read what you need from each," : "lines: read all of them,");
        return protocol == Protocol.JSON
            ? new BotStub(List.of(), List.of(Input.values("turn:int")), "", List.of(Command.single().otherwise("")),
                List.of(note, "and put the fields of your answer here."))
            : new BotStub(List.of(), List.of(Input.values("first:word")), "",
                List.of(Command.single().otherwise("'?'")),
                List.of(note, "first those before the first turn, and print the lines of your answer here."));
    }

    private Map<String, Object> values() {
        Map<String, Object> values = new HashMap<>();
        Map<String, Object> records = new LinkedHashMap<>();
        Stream.concat(stub.setup().stream(), stub.turn().stream()).filter(input -> !input.type().isEmpty())
            .forEach(input -> records.putIfAbsent(input.type(),
                Map.of("type", input.type(), "fields", fields(input.fields()))));
        boolean nearest = stub.commands().stream().anyMatch(command -> !command.nearest().isEmpty());
        String all = stub.commands().toString();
        values.put("records", List.copyOf(records.values()));
        String step = language == StarterLanguage.JS ? "  " : "    ";
        values.put("readings", List.of(
            Map.of("every", false, "step", "", "inputs", stub.setup().stream().map(this::input).toList()),
            Map.of("every", true, "step", step, "inputs", stub.turn().stream().map(this::input).toList())));
        values.put("answer", stub.answer());
        values.put("commands", stub.commands().stream().map(this::command).toList());
        values.put("notes", stub.notes().stream().map(note -> Map.of("note", note)).toList());
        values.put("nearest", nearest);
        values.put("distance", nearest || all.contains("distance("));
        values.put("degrees", all.contains("degreesOff("));
        values.put("math", nearest || all.contains("distance(") || all.contains("degreesOff("));
        return values;
    }

    private Map<String, Object> input(Input input) {
        boolean variables = input.type().isEmpty();
        return Map.of("variables", variables ? fields(input.fields()) : List.of(), "record",
            !variables && !input.isList(), "list", input.isList(), "name", input.name(), "key", input.key(), "type",
            input.type(), "count", input.count(), "fields", fields(input.fields()));
    }

    private static List<Map<String, Object>> fields(List<Field> fields) {
        List<Map<String, Object>> found = new ArrayList<>();
        for (Field field : fields) {
            found.add(Map.of("name", field.name(), "key", field.key(), "kind",
                field.kind() == Kind.INT ? "integer" : field.kind() == Kind.REAL ? "number" : "word",
                "int", field.kind() == Kind.INT, "real", field.kind() == Kind.REAL, "word", field.kind() == Kind.WORD,
                "wrap", !found.isEmpty() && found.size() % FIELDS_A_LINE == 0));
        }
        return found;
    }

    private Map<String, Object> command(Command command) {
        List<String> names = command.nearest().stream().map(BotStub.Nearest::name).toList();
        List<Map<String, Object>> choices = new ArrayList<>();
        String indent = command.list().isEmpty() ? "" : "    ";
        boolean nested = command.choices().size() > 1;
        for (Choice choice : command.choices()) {
            boolean first = choices.isEmpty();
            boolean always = choice.when().isEmpty();
            choices.add(Map.of("if", first && !always, "elseif", !first && !always, "else", !first && always, "nested",
                nested, "end", nested && choices.size() == command.choices().size() - 1, "when",
                language.condition(choice.when(), names), "indent", indent, "inner", nested ? indent + "    " : indent,
                "parts", parts(choice.command(), names)));
        }
        return Map.of("name", command.name(), "list", command.list(), "where",
            language.condition(command.where(), names), "indent", indent, "indexed",
            command.toString().matches("(?s).*\\bindex\\b.*"), "locals",
            command.locals().stream().map(local -> Map.of("name", local.name(), "value",
                language.expression(local.value(), names))).toList(), "nearest",
            command.nearest().stream().map(this::nearest).toList(), "choices", choices);
    }

    private Map<String, Object> nearest(BotStub.Nearest nearest) {
        String type = Stream.concat(stub.setup().stream(), stub.turn().stream())
            .filter(input -> input.isList() && input.name().equals(nearest.list())).map(Input::type).findFirst()
            .orElseThrow(() -> new IllegalArgumentException("found no list \"" + nearest.list() + "\" of "
                + nearest.name() + ", expected one that is read"));
        return Map.of("name", nearest.name(), "list", nearest.list(), "where",
            language.condition(nearest.where(), List.of()), "from", nearest.from(), "type", type);
    }

    /** Words of a command, or pairs of key and value; commas within brackets do not divide. */
    private List<Map<String, Object>> parts(String command, List<String> nearest) {
        List<Map<String, Object>> parts = new ArrayList<>();
        int depth = 0;
        int from = 0;
        for (int k = 0; k <= command.length() && !command.isEmpty(); k++) {
            char c = k == command.length() ? ',' : command.charAt(k);
            depth += c == '(' ? 1 : c == ')' ? -1 : 0;
            if (c == ',' && (depth == 0 || k == command.length())) {
                String part = command.substring(from, k).strip();
                int colon = part.matches("\\w+: .*") ? part.indexOf(':') : -1;
                parts.add(Map.of("wrap", command.length() > ONE_LINE, "key",
                    part.substring(0, Math.max(0, colon)), "value",
                    language.expression(part.substring(colon + 1).strip(), nearest)));
                from = k + 1;
            }
        }
        return parts;
    }
}
