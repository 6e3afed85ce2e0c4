package steward.game;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Input and answers of a game's bots in one protocol, declared once for starter bots in all languages.
 *
 * <p>Expressions are written in the syntax that Python, Java, C++ and JavaScript share: {@code +}, {@code -}, {@code
 * *}, {@code /}, brackets, {@code a.x}, {@code list[index]}. Conditions are {@code ==}, {@code !=}, {@code <}, {@code
 * <=}, {@code >}, {@code >=}, joined by {@code &&}, with words in single quotes. Two functions exist: {@code
 * distance(x, y, otherX, otherY)} and {@code degreesOff(x, y, heading, otherX, otherY)}, 0..180. A number that a frame
 * does not have is -1.
 *
 * @param setup    inputs before the first turn, in the order of their lines
 * @param turn     inputs of a turn
 * @param answer   field of the answer that has the list of commands; empty if the answer is the command, or lines
 * @param commands commands of an answer, in their order
 * @param notes    lines of advice for whoever changes the starter
 */
public record BotStub(List<Input> setup, List<Input> turn, String answer, List<Command> commands, List<String> notes) {

    private static final Pattern FIELD = Pattern.compile("(\\w+)(?:=(\\w+))?:(int|real|word)");
    private static final Pattern NAME = Pattern.compile("[A-Za-z][A-Za-z0-9]*");

    /** Words that some language, or a starter itself, has for something else. */
    private static final Set<String> RESERVED = Set.of(("abstract alignas and answer answers args arguments as "
        + "assert async auto await bool boolean Bot break buffer byte case catch char class command const continue "
        + "decltype def default degreesOff del delete distance do double each elif else enum eval except explicit "
        + "export extends extern false final finally float for frame friend from function global goto if implements "
        + "import in index inline input instanceof int integer interface is items Json k lambda let List list long "
        + "main Map Math math mutable namespace native nearest new nonlocal not null number Object object operator "
        + "or package pass print private protected public raise read record register require return short signed "
        + "sizeof static std String struct super switch synchronized System template this throw throws transient "
        + "true try typedef typeof union unsigned using var virtual void volatile while with word xor yield")
        .split(" "));

    /** Copies the lists. @throws IllegalArgumentException if a type has two forms */
    public BotStub {
        setup = List.copyOf(setup);
        turn = List.copyOf(turn);
        commands = List.copyOf(commands);
        notes = List.copyOf(notes);
        List<Input> records = new ArrayList<>(setup);
        records.addAll(turn);
        records.removeIf(input -> input.type().isEmpty());
        for (Input one : records) {
            for (Input other : records) {
                if (one.type().equals(other.type()) && !one.fields().equals(other.fields())) {
                    throw new IllegalArgumentException("found two forms of the type " + one.type() + ", expected one");
                }
            }
        }
    }

    /** Lines of advice, one list behind the other. */
    public static List<String> notes(List<String> first, String... more) {
        return Stream.concat(first.stream(), Stream.of(more)).toList();
    }

    /** A kind of value. */
    public enum Kind {
        /** A whole number. */
        INT,
        /** Any number. */
        REAL,
        /** A word without blanks. */
        WORD
    }

    /**
     * A value with a name.
     *
     * @param name in the starter
     * @param key  in the frame
     */
    public record Field(String name, String key, Kind kind) {

        /** @throws IllegalArgumentException if the name is none in all languages */
        public Field {
            requireName(name);
        }

        /** Reads fields such as {@code id:int owner=player:int x:real kind:word}. */
        static List<Field> list(String text) {
            List<Field> fields = new ArrayList<>();
            for (String word : text.isBlank() ? new String[0] : text.strip().split("\\s+")) {
                Matcher field = FIELD.matcher(word);
                if (!field.matches()) {
                    throw new IllegalArgumentException("found the field \"" + word
                        + "\", expected NAME:KIND or NAME=KEY:KIND with int, real or word as KIND");
                }
                fields.add(new Field(field.group(1), field.group(2) == null ? field.group(1) : field.group(2),
                    Kind.valueOf(field.group(3).toUpperCase(Locale.ROOT))));
            }
            return List.copyOf(fields);
        }
    }

    /**
     * Values that stand together: variables, a record, or a list of records.
     *
     * @param name  of the record or list; empty for variables
     * @param key   in the frame
     * @param type  of the record; empty for variables
     * @param count of records, an expression; empty for a single record, and in frames
     */
    public record Input(String name, String key, String type, String count, boolean isList, List<Field> fields) {

        /** Variables, such as {@code "laps:int"}. */
        public static Input values(String fields) {
            return new Input("", "", "", "", false, Field.list(fields));
        }

        /** A record, in frames an object. */
        public static Input record(String name, String type, String fields) {
            return of(name, type, "", false, fields);
        }

        /** Lines, as many as an expression says. */
        public static Input lines(String name, String type, String count, String fields) {
            return of(name, type, count, true, fields);
        }

        /** A list of objects. @param name such as {@code pods}, or {@code discs=bodies} with a key of its own */
        public static Input objects(String name, String type, String fields) {
            return of(name, type, "", true, fields);
        }

        private static Input of(String name, String type, String count, boolean isList, String fields) {
            String[] names = name.split("=", 2);
            requireName(names[0]);
            requireName(type);
            return new Input(names[0], names[names.length - 1], type, count, isList, Field.list(fields));
        }
    }

    /** A variable and its value. */
    public record Local(String name, String value) {

        /** @throws IllegalArgumentException if the name is none in all languages */
        public Local {
            requireName(name);
        }
    }

    /**
     * The nearest of some records, which need not be there.
     *
     * @param name  that it gets
     * @param list  of the records, which have x and y
     * @param where condition on each of them, called {@code each}; empty if all count
     * @param from  a record or local variable with the place
     */
    public record Nearest(String name, String list, String where, String from) {

        /** @throws IllegalArgumentException if the name is none in all languages */
        public Nearest {
            requireName(name);
        }
    }

    /** A command, and the condition for it: empty, or such as {@code chip.radius > 5}, or a {@link Nearest} by name. */
    public record Choice(String when, String command) { }

    /**
     * Commands of a kind. Their expressions may use {@code index}, the place of the record in its list.
     *
     * @param name    of the record that is commanded; empty for a single command
     * @param list    of the records
     * @param where   condition on the record; empty if all are commanded
     * @param locals  variables that the choices use
     * @param nearest records that the choices use
     * @param choices the first whose condition holds is taken; the last has none
     */
    public record Command(String name, String list, String where, List<Local> locals, List<Nearest> nearest,
                          List<Choice> choices) {

        /** A single command. */
        public static Command single() {
            return new Command("", "", "", List.of(), List.of(), List.of());
        }

        /** A command for each record of a list. @param where condition on it, or empty */
        public static Command each(String name, String list, String where) {
            requireName(name);
            return new Command(name, list, where, List.of(), List.of(), List.of());
        }

        /** Adds a variable. */
        public Command let(String variable, String value) {
            return new Command(name, list, where, and(locals, new Local(variable, value)), nearest, choices);
        }

        /** Looks for the nearest record to a place, see {@link Nearest}. */
        public Command nearest(String found, String in, String such, String from) {
            return new Command(name, list, where, locals, and(nearest, new Nearest(found, in, such, from)), choices);
        }

        /** Adds a choice. @param command its words, or {@code key: value} pairs in frames, with commas between */
        public Command when(String condition, String command) {
            return new Command(name, list, where, locals, nearest, and(choices, new Choice(condition, command)));
        }

        /** Adds the last choice. */
        public Command otherwise(String command) {
            return when("", command);
        }

        private static <T> List<T> and(List<T> before, T last) {
            List<T> all = new ArrayList<>(before);
            all.add(last);
            return List.copyOf(all);
        }
    }

    private static void requireName(String name) {
        if (!NAME.matcher(name).matches() || RESERVED.contains(name)) {
            throw new IllegalArgumentException("found the name \"" + name
                + "\", expected letters and digits that are no word of Python, Java, C++ or JavaScript");
        }
    }
}
