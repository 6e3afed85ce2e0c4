package steward.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Rules that show in the text of sources alone: class docs, options in messages, comparisons, names of games. */
@Execution(ExecutionMode.CONCURRENT)
class SourceTextTest {

    private static Map<String, String> problems(Map<String, String> sources, Check check) {
        Map<String, String> problems = new TreeMap<>();
        sources.forEach((file, text) -> {
            String problem = check.problem(file, text);
            if (problem != null) {
                problems.put(file, problem);
            }
        });
        return problems;
    }

    private interface Check {
        /** Returns what is wrong with a file, or {@code null}. */
        String problem(String file, String text);
    }

    // ---- class docs: each type has one, and its first sentence can be understood at once ---------

    private static final int MOST_WORDS = 25;
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
            : LEANING.matcher(sentence).matches() ? "leans on another sentence: " + sentence : null;
    }

    @Test
    void firstSentencesOfClassDocsAreShortAndStandAlone() {
        assertEquals(Map.of(), problems(SourceText.main(), SourceTextTest::docProblem));
        assertTrue(SourceText.main().size() > 1000, "files are seen");

        String head = "package steward.x;\n\n/** Not of a type. */\nimport java.util.List;\n\n";
        assertEquals("no class doc", docProblem("Bare.java", "package steward.x;\n\nfinal class Bare { }\n"));
        String tail = "\n/** Rule of \"class\" games. */\nfinal class Rule {\n    /** It counts. */\n    int n;\n}\n";
        assertNull(docProblem("Rule.java", head + tail));
        assertEquals("leans on another sentence: It counts games.",
            docProblem("x/package-info.java", "/** It counts games. It is\n * quick. */\npackage steward.x;\n"));
        String longest = " word".repeat(MOST_WORDS).strip();
        assertNull(docProblem("R.java", "/**\n * " + longest + ".\n *\n * @param n a\n */\nrecord R(int n) { }\n"));
        assertEquals(MOST_WORDS + 1 + " words: " + longest + " more.",
            docProblem("I.java", "/** " + longest + "\n * more. */\ninterface I { }\n"));
        assertEquals("Table (by D. Knuth).", firstSentence("Table (by D. Knuth). Second."));
        assertEquals("Ends by Ctrl-C.", firstSentence("Ends by Ctrl-C. Second."));
    }

    // ---- libraries do not speak of options: who calls them from Java has none --------------------

    private static final Pattern LITERAL = Pattern.compile("\"(?:[^\"\\\\\n]|\\\\.)*\"");
    private static final Pattern OPTION = Pattern.compile("(?<!-)--[a-z][a-z-]*");

    private static final String OF_OTHERS = "options of other programs that are started";
    private static final String STORED = "league.json has the sandbox as the words of a call";
    private static final String ADVICE = "advice to people who play games, beside what happened, in no exception";
    private static final String OTHER_SIDE = "about a call on the other side of a connection";

    /** Sources that may, with the reason. Others name the parameter, see {@link steward.files.Remedied}. */
    private static final Map<String, String> MAY_NAME_OPTIONS = Map.ofEntries(
        Map.entry("bot/isolation/StrictSandbox", OF_OTHERS), Map.entry("bot/isolation/ShellLauncher", OF_OTHERS),
        Map.entry("bot/command/Program", OF_OTHERS), Map.entry("guest/GuestProgram", OF_OTHERS),
        Map.entry("live/PagePicture", OF_OTHERS), Map.entry("league/LeagueText", STORED),
        Map.entry("league/LeagueReader", STORED), Map.entry("league/LeagueSettings", STORED),
        Map.entry("contest/FailureHints", ADVICE), Map.entry("contest/FailureStreaks", ADVICE),
        Map.entry("league/play/Roster", ADVICE), Map.entry("bot/command/ProgramFinder", ADVICE),
        Map.entry("scene/AccuracyFigures", "the whole call of the workshop that makes the file"),
        Map.entry("machines/worker/Worker", OTHER_SIDE), Map.entry("machines/serve/WorkerState", OTHER_SIDE),
        Map.entry("machines/check/GameJar", OTHER_SIDE));

    private static List<String> options(String source) {
        return LITERAL.matcher(source).results().flatMap(literal -> OPTION.matcher(literal.group()).results())
            .map(MatchResult::group).toList();
    }

    @Test
    void librariesDoNotSpeakOfOptions() {
        SortedMap<String, String> sources = SourceText.below("src/engine/java", "src/main/java");
        sources.keySet().removeIf(file -> file.contains("/steward/cli/"));
        Set<String> speaking = problems(sources, (file, text) -> options(text).isEmpty() ? null : "speaks").keySet()
            .stream().map(file -> file.replaceAll(".*/java/steward/|\\.java", "")).collect(Collectors.toSet());
        assertEquals(new TreeSet<>(MAY_NAME_OPTIONS.keySet()), new TreeSet<>(speaking));

        assertEquals(List.of("--overwrite", "--out"), options("throw new InputException(file + \": kept; --overwrite "
            + "would\");\nString s = \"--out\"; int k = 3; k--; // --none\n"));
        assertEquals(List.of(), options("for (int k = 3; k --> 0;) { a(\"a - b\"); }"));
    }

    // ---- a new arithmetic must not pass for another one in silence -------------------------------

    private static String comparison(String file, String text) {
        return Pattern.compile("[!=]= *Arithmetic\\.").matcher(text).find() ? "compares" : null;
    }

    @Test
    void thePhysicsComparesNoArithmeticsButByExhaustiveSwitches() {
        assertEquals(Map.of(), problems(SourceText.below("src/engine/java/steward/physics"),
            SourceTextTest::comparison));
        assertEquals("compares", comparison("X.java", "boolean exact = of !=Arithmetic.DOUBLE;"));
    }

    // ---- no file names a game other than the first, but for its own room, resources and lists ----

    private static final String FIRST_GAME = "podrace";
    /** Lists in which every game has a line. */
    private static final List<String> LISTS = List.of("src/engine/resources/META-INF/services/steward.game.GameType",
        "src/engine/java/steward/scene/SceneFiles.java", "src/main/resources/steward/view/page.js");

    /**
     * A room's name with a hyphen at any place: {@code searchrace} is also {@code search-race} and SearchRace. Bodies
     * are everywhere; the game of this name is known by its package, its types and its files.
     */
    private static Pattern nameOf(String game) {
        return game.equals("bodies") ? Pattern.compile("steward[./]game[./]bodies|Bodies(Game|Type)|/bodies\\.js")
            : Pattern.compile(String.join("-?", game.split("")), Pattern.CASE_INSENSITIVE);
    }

    private static Set<String> filesThatName(String game, Map<String, String> files) {
        Pattern name = nameOf(game);
        return problems(files, (file, text) -> file.contains("/java/steward/game/" + game + "/")
            || file.matches("src/\\w+/(resources|schemas)/.*") && name.matcher(file).find()
            || !name.matcher(text).find() ? null : "names " + game).keySet();
    }

    @Test
    @Tag("slow")
    void aGameIsNamedInTheListsAlone() {
        Map<String, String> files = SourceText.ofKind("", "src/engine", "src/main", "src/lab");
        Set<String> games = House.ROOMS.stream().filter(room -> room.matches("game\\.\\w+"))
            .map(room -> room.replace("game.", "")).collect(Collectors.toSet());
        assertTrue(games.remove(FIRST_GAME) && games.contains("searchrace"), games::toString);
        for (String game : games) {
            Set<String> elsewhere = new TreeSet<>(filesThatName(game, files));
            LISTS.forEach(elsewhere::remove);
            assertEquals(Set.of(), elsewhere, game);
        }
        assertTrue(filesThatName(FIRST_GAME, files)
            .contains("src/main/java/steward/codingame/recording/RecordingImport.java"), "it can find something");
    }
}
