package steward.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.BinaryOperator;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Rules that show in the text of sources alone: class docs, options in messages, comparisons, names of games. */
@Execution(ExecutionMode.CONCURRENT)
class SourceTextTest {

    private static final SortedMap<String, String> FILES = SourceText.ofKind("", "src/engine", "src/main", "src/lab");

    private static final int MOST_WORDS = 25;
    private static final String LONGEST = "word" + " word".repeat(MOST_WORDS - 1);

    /** Which files keep it, those that need not, what is wrong with a text, and planted texts with their faults. */
    enum Rule {
        /** Each type has a class doc, and its first sentence can be understood at once. */
        CLASS_DOCS("src/\\w+/java/.*\\.java", Set.of(), SourceTextTest::docProblem, new String[][] {
            {"Bare.java", "/** Of the package. */\npackage x;\n\nclass Bare {\n    /** It. */\n    int n;\n}\n",
                "no class doc"},
            {"Rule.java", "package x;\n\n/** It imports. */\nimport y.Z;\n\n/** Rule of \"class\" games. */\n"
                + "class Rule {\n    /** It. */\n    int n;\n}\n", ""},
            {"x/package-info.java", "/** It counts games. It is\n * quick. */\npackage steward.x;\n",
                "leans on another sentence: It counts games."},
            {"R.java", "/**\n * " + LONGEST + ".\n *\n * @param n a\n */\nrecord R(int n) { }\n", ""},
            {"I.java", "/** " + LONGEST + "\n * more. */\ninterface I { }\n", "26 words: " + LONGEST + " more."},
            {"D.java", "/** It (by D. Knuth). Second. */\nclass D { }", "leans on another sentence: It (by D. Knuth)."},
            {"C.java", "/** It, by Ctrl-C. Second. */\nclass C { }", "leans on another sentence: It, by Ctrl-C."}}),
        /** Each room says what it is for. */
        ROOMS("src/\\w+/java/.*\\.java", Set.of(), (file, text) ->
            Files.exists(Path.of(file).resolveSibling("package-info.java")) ? "" : "no package-info",
            new String[][] {{"src/test/java/steward/architecture/House.java", "", "no package-info"}}),
        /**
         * Libraries do not speak of options, but name the parameter, see {@link steward.files.Remedied}: who calls them
         * from Java has none. Excepted are, in this order: options of other programs that are started; a
         * sandbox that league.json has as the words of a call; advice to people who play games, beside what happened,
         * in no exception; the whole call of the workshop that makes a file; calls on the other side of a connection.
         */
        OPTIONS("src/(engine|main)/java/steward/(?!cli/).*", Set.of(
            "bot/isolation/StrictSandbox", "bot/isolation/ShellLauncher", "bot/command/Program", "guest/GuestProgram",
            "live/PagePicture", "league/LeagueText", "league/LeagueReader", "league/LeagueSettings",
            "contest/FailureHints", "contest/FailureStreaks", "league/play/Roster", "bot/command/ProgramFinder",
            "scene/AccuracyFigures", "machines/worker/Worker", "machines/serve/WorkerState", "machines/check/GameJar"),
            SourceTextTest::options, new String[][] {
                {"Two.java", "throw new InputException(file + \": kept; --overwrite would\");\nString s = \"--out\";"
                    + " int k = 3; k--; // --none\n", "--overwrite --out"},
                {"None.java", "for (int k = 3; k --> 0;) { a(\"a - b\"); }", ""}}),
        /** A new arithmetic must not pass for another one in silence: the physics has exhaustive switches. */
        COMPARISONS("src/engine/java/steward/physics/.*", Set.of(), (file, text) ->
            Pattern.compile("[!=]= *Arithmetic\\.").matcher(text).find() ? "compares" : "",
            new String[][] {{"X.java", "boolean exact = of !=Arithmetic.DOUBLE;", "compares"}}),
        /** No file names a game other than the first, but for its own room and resources, and lists of all games. */
        GAMES("src/.*", Set.of("src/engine/resources/META-INF/services/steward.game.GameType", "scene/SceneFiles",
            "src/main/resources/steward/view/page.js"), SourceTextTest::namedGames, new String[][] {
                {"src/main/java/steward/game/Game.java", "search-race, mean-max or SearchRace, a pod race of bodies",
                    "meanmax searchrace"},
                {"src/main/java/steward/game/meanmax/MeanMax.java", "MeanMax", ""},
                {"src/main/java/steward/game/Games.java", "steward.game.bodies", "bodies"},
                {"src/engine/resources/mean-max.json", "mean-max", ""}});

        private final Pattern files;
        private final Set<String> mayBreak;
        private final BinaryOperator<String> problem;
        private final String[][] planted;

        Rule(String files, Set<String> mayBreak, BinaryOperator<String> problem, String[][] planted) {
            this.files = Pattern.compile(files);
            this.mayBreak = mayBreak;
            this.problem = problem;
            this.planted = planted;
        }
    }

    @ParameterizedTest
    @EnumSource
    void theSourcesKeepTheRule(Rule rule) {
        Map<String, String> problems = new TreeMap<>();
        FILES.forEach((file, text) -> {
            String problem = rule.files.matcher(file).matches() ? rule.problem.apply(file, text) : "";
            if (!problem.isEmpty()) {
                problems.put(file.replaceAll(".*/java/steward/|\\.java", ""), problem);
            }
        });
        assertEquals(new TreeSet<>(rule.mayBreak), problems.keySet(), problems::toString);
    }

    @ParameterizedTest
    @EnumSource
    void theRuleFindsWhatIsPlanted(Rule rule) {
        for (String[] each : rule.planted) {
            assertEquals(each[2], rule.problem.apply(each[0], each[1]), each[0]);
        }
        long files = FILES.keySet().stream().filter(rule.files.asMatchPredicate()).count();
        assertTrue(files > (rule == Rule.COMPARISONS ? 50 : 700), files + " files are seen");
    }

    /** A comment, a text, or the beginning of the type or package that a file is named after. */
    private static final Pattern TOKEN = Pattern.compile("(?s)/\\*\\*(.*?)\\*/|/\\*.*?\\*/|//[^\n]*"
        + "|\"(?:\\\\.|[^\"\\\\])*\"|\\b(?:class|interface|enum|record)\\s+\\w+|(?m)^package\\s");
    /** Words with which a sentence leans on another one. */
    private static final Pattern LEANING = Pattern.compile("(?:It|They|This|That|Those|These|What|Where|Whether|How"
        + "|Which|Who|Of|The same)\\b.*");

    /** Returns the last Javadoc before the type of a file, or before the package of a package-info; else empty. */
    private static String doc(String source, boolean ofPackage) {
        String last = "";
        Matcher token = TOKEN.matcher(source);
        while (token.find()) {
            String text = token.group();
            if (token.group(1) != null) {
                last = token.group(1).replaceAll("\n\\s*\\*", "\n");
            } else if (text.startsWith("package")) {
                if (ofPackage) {
                    return last;
                }
                last = "";
            } else if (Character.isLetter(text.charAt(0))) {
                return last;
            }
        }
        return "";
    }

    /** Returns the first sentence as Javadoc takes it, up to a tag or a full stop; an initial does not end it. */
    private static String firstSentence(String doc) {
        String text = doc.replaceAll("\\{@\\w+\\s+([^}]*)}", "$1").split("(?m)<(?:p|pre|ul|ol)>|^\\s*@")[0].strip()
            .replaceAll("\\s+", " ");
        Matcher end = Pattern.compile("(?<![ (][A-Z])[.](?= |$)").matcher(text);
        return end.find() ? text.substring(0, end.end()) : text;
    }

    private static String docProblem(String file, String source) {
        String sentence = firstSentence(doc(source, file.endsWith("package-info.java")));
        int words = sentence.split(" ").length;
        return sentence.isEmpty() ? "no class doc" : words > MOST_WORDS ? words + " words: " + sentence
            : LEANING.matcher(sentence).matches() ? "leans on another sentence: " + sentence : "";
    }

    private static final Pattern LITERAL = Pattern.compile("\"(?:[^\"\\\\\n]|\\\\.)*\"");
    private static final Pattern OPTION = Pattern.compile("(?<!-)--[a-z][a-z-]*");

    private static final Pattern BODIES = Pattern.compile("steward[./]game[./]bodies|Bodies(Game|Type)|/bodies\\.js");

    private static String options(String file, String source) {
        return LITERAL.matcher(source).results().flatMap(literal -> OPTION.matcher(literal.group()).results())
            .map(MatchResult::group).collect(Collectors.joining(" "));
    }

    private static String namedGames(String file, String text) {
        return House.ROOMS.stream().filter(room -> room.matches("game\\.(?!podrace$)\\w+"))
            .map(room -> room.substring("game.".length()))
            .filter(game -> names(text, game) && !file.contains("/java/steward/game/" + game + "/")
                && !(file.matches("src/\\w+/(resources|schemas)/.*") && names(file, game)))
            .collect(Collectors.joining(" "));
    }

    /**
     * Tests whether a text names the game of a room: {@code searchrace} is also {@code search-race} and SearchRace.
     * Bodies are everywhere; the game of this name is known by its package, its types and its files.
     */
    private static boolean names(String text, String game) {
        return game.equals("bodies") ? BODIES.matcher(text).find()
            : text.replace("-", "").toLowerCase(Locale.ROOT).contains(game);
    }
}
