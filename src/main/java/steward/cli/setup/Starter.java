package steward.cli.setup;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import steward.bot.command.BotCommand;
import steward.cli.shared.Games;
import steward.files.Resources;
import steward.match.Protocol;

/**
 * The bots to start from, for a game one in each language or in some; their files are among the resources. The first of
 * a language is its usual one; in another protocol or with a simulator, a name has more than the language.
 */
enum Starter {

    PYTHON("bot.py", List.of(), "python3 bot.py"),
    JAVA("Bot.java", List.of("javac Bot.java"), "codingame:java Bot"),
    CPP("bot.cpp", List.of("g++ -O2 -o bot bot.cpp"), "codingame:./bot"),
    JS("bot.js", List.of(), "codingame:node bot.js"),
    PYTHON_CODINGAME("bot.py", List.of(), "codingame:python3 bot.py"),
    JS_JSON("bot.js", List.of(), "node bot.js"),
    /** C++ with the header that plays the official turn: cpp with {@code --simulator}. */
    CPP_SIMULATOR("bot.cpp", List.of("g++ -std=c++17 -O3 -march=native -o bot bot.cpp"), "codingame:./bot");

    /** Says how to run the bot. */
    static final String README = "README.md";

    private static final String HEADER = "steward_podrace.hpp";
    private static final String FOLDER = "/steward/starters/";

    private final String source;
    private final List<String> compile;
    private final String bot;

    /**
     * @param source  name of the file with the program
     * @param compile commands that make it ready to run
     * @param bot     as {@code --bot} takes it, when called in the folder
     */
    Starter(String source, List<String> compile, String bot) {
        this.source = source;
        this.compile = compile;
        this.bot = bot;
    }

    /** The language as it is typed. */
    String word() {
        return name().replaceFirst("_.*", "").toLowerCase(Locale.ROOT);
    }

    Protocol protocol() {
        return bot.startsWith(BotCommand.Prefix.CODINGAME.written()) ? Protocol.CODINGAME : Protocol.JSON;
    }

    /** The languages that have one for a game, in their order. */
    static List<String> languages(String game) {
        return Arrays.stream(values()).filter(each -> each.isFor(game)).map(Starter::word).distinct().toList();
    }

    /** True if it is asked for by {@code --simulator}. */
    boolean searches() {
        return this == CPP_SIMULATOR;
    }

    List<String> files() {
        return searches() ? List.of(source, HEADER, README) : List.of(source, README);
    }

    List<String> compile() {
        return compile;
    }

    String bot() {
        return bot;
    }

    boolean isFor(String game) {
        return Starter.class.getResource(folder(game) + source) != null;
    }

    private String folder(String game) {
        return FOLDER + (game.equals(Games.FIRST) ? "" : game + "/")
            + name().toLowerCase(Locale.ROOT).replace('_', '-') + "/";
    }

    /** The content of one of its {@link #files()}. */
    byte[] read(String game, String file) {
        return Resources.bytes(folder(game) + file);
    }
}
