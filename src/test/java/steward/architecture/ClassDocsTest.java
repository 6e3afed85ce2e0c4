package steward.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Class docs of the three parts: each type has one, and its first sentence can be understood at once. */
class ClassDocsTest {

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

    /** Returns what is wrong with the class doc of a source, or {@code null}. */
    private static String problem(String source, boolean ofPackage) {
        String doc = doc(source, ofPackage);
        if (doc.isBlank()) {
            return "no class doc";
        }
        String sentence = firstSentence(doc);
        int words = sentence.split(" ").length;
        return words > MOST_WORDS ? words + " words: " + sentence
            : LEANING.matcher(sentence).matches() ? "leans on another sentence: " + sentence : null;
    }

    @Test
    void firstSentencesAreShortAndStandAlone() throws IOException {
        Map<String, String> wrong = new TreeMap<>();
        int seen = 0;
        for (String part : List.of("engine", "main", "lab")) {
            List<Path> files = new ArrayList<>();
            try (Stream<Path> all = Files.walk(Path.of("src", part, "java"))) {
                all.filter(file -> file.toString().endsWith(".java")).forEach(files::add);
            }
            for (Path file : files) {
                seen++;
                String problem = problem(Files.readString(file), file.endsWith("package-info.java"));
                if (problem != null) {
                    wrong.put(file.toString(), problem);
                }
            }
        }
        assertEquals(Map.of(), wrong);
        assertTrue(seen > 1000, "files: " + seen);
    }

    @Test
    void whatIsWrongIsFound() {
        String head = "package steward.x;\n\n/** Not of a type. */\nimport java.util.List;\n\n";
        assertEquals("no class doc", problem("package steward.x;\n\nfinal class Bare { }\n", false));
        String tail = "\n/** Rule of \"class\" games. */\nfinal class Rule {\n    /** It counts. */\n    int n;\n}\n";
        assertEquals(null, problem(head + tail, false));
        assertEquals("leans on another sentence: It counts games.",
            problem("/** It counts games. It is\n * quick. */\npackage steward.x;\n", true));
        String longest = " word".repeat(MOST_WORDS).strip();
        assertEquals(null, problem("/**\n * " + longest + ".\n *\n * @param n a\n */\nrecord R(int n) { }\n", false));
        assertEquals(MOST_WORDS + 1 + " words: " + longest + " more.",
            problem("/** " + longest + "\n * more. */\ninterface I { }\n", false));
        assertEquals("Table (by D. Knuth).", firstSentence("Table (by D. Knuth). Second."));
        assertEquals("Ends by Ctrl-C.", firstSentence("Ends by Ctrl-C. Second."));
    }
}
