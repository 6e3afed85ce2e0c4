package steward.cli.setup;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import steward.match.Protocol;

/**
 * Programming languages of starter bots: the template, how a program is built and run, and how expressions are written.
 */
enum StarterLanguage {

    PYTHON("bot.py", List.of(), "python3 bot.py", Protocol.JSON),
    JAVA("Bot.java", List.of("javac Bot.java"), "java Bot", Protocol.CODINGAME),
    CPP("bot.cpp", List.of("g++ -std=c++17 -O2 -o bot bot.cpp"), "./bot", Protocol.CODINGAME),
    JS("bot.js", List.of(), "node bot.js", Protocol.CODINGAME);

    private static final Pattern WORD_COMPARED = Pattern.compile("([\\w.]+) (==|!=) ('[^']*')");

    private final String source;
    private final List<String> compile;
    private final String run;
    private final Protocol usual;

    /**
     * @param source  name of the file with the program, and of its template
     * @param compile commands that make it ready to run
     * @param run     its command in its folder
     * @param usual   the protocol where none is asked for
     */
    StarterLanguage(String source, List<String> compile, String run, Protocol usual) {
        this.source = source;
        this.compile = compile;
        this.run = run;
        this.usual = usual;
    }

    String source() {
        return source;
    }

    List<String> compile() {
        return compile;
    }

    Protocol usual() {
        return usual;
    }

    /** The bot as {@code --bot} takes it, when called in the folder. */
    String bot(Protocol protocol) {
        return (protocol == Protocol.CODINGAME ? "codingame:" : "") + run;
    }

    /** The language as it is typed. */
    String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    static List<String> words() {
        return Arrays.stream(values()).map(StarterLanguage::word).toList();
    }

    /** An expression in the language. @param nearest names of records that need not be there */
    String expression(String text, List<String> nearest) {
        String expression = text;
        if (this == JAVA) {
            expression = WORD_COMPARED.matcher(text).replaceAll(
                match -> (match.group(2).equals("!=") ? "!" : "") + match.group(1) + ".equals(" + match.group(3) + ")");
        }
        if (this == CPP) {
            for (String name : nearest) {
                expression = expression.replaceAll("\\b" + name + "\\.", name + "->");
            }
        }
        return switch (this) {
            case PYTHON -> expression.replace("'", "\"").replace(" && ", " and ").replaceAll("\\btrue\\b", "True");
            case JS -> expression.replace(" == ", " === ").replace(" != ", " !== ");
            default -> expression.replace("'", "\"");
        };
    }

    /** A condition in the language, in which a record alone is true if it is there. */
    String condition(String text, List<String> nearest) {
        List<String> parts = Arrays.stream(text.split(" && ")).map(part -> !nearest.contains(part) ? part
            : this == JAVA ? part + " != null" : this == PYTHON ? part + " is not None" : part).toList();
        return expression(String.join(" && ", parts), nearest);
    }
}
