package steward.bot.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** The quoting rules of the POSIX shell (IEEE Std 1003.1, Shell Command Language, 2.2 Quoting). */
class CommandLineTest {

    private static void splits(String text, String... words) {
        assertEquals(List.of(words), CommandLine.split(text), () -> "words of <" + text + ">");
    }

    private static void fails(String text, String message) {
        Exception e = assertThrows(IllegalArgumentException.class, () -> CommandLine.split(text), () -> text);
        assertEquals(message, e.getMessage());
    }

    @Test
    void blanksSeparateWords() {
        splits("");
        splits(" \t\n ");
        splits("one", "one");
        splits("  one two\tthree\nfour ", "one", "two", "three", "four");
    }

    @Test
    void singleQuotesKeepEverything() {
        splits("'a b'", "a b");
        splits("'a\\b\"c$d`e'", "a\\b\"c$d`e");
        splits("a'b'c", "abc");
        splits("''", "");
        splits("a '' b", "a", "", "b");
        splits("'line one\nline two'", "line one\nline two");
    }

    @Test
    void doubleQuotesKnowFourEscapes() {
        splits("\"a b\"", "a b");
        splits("\"a'b\"", "a'b");
        splits("\"\\\"\\\\\\$\\`\"", "\"\\$`");
        splits("\"a\\nb\\'c\"", "a\\nb\\'c");
        splits("\"\"", "");
        splits("x\"y z\"'w'", "xy zw");
    }

    @Test
    void aBackslashOutsideQuotesProtectsAnything() {
        splits("a\\ b", "a b");
        splits("\\'\\\"\\\\", "'\"\\");
        splits("\\a\\n", "an");
    }

    @Test
    void aBackslashAtALineEndJoinsLines() {
        splits("on\\\ne", "one");
        splits("one \\\n two", "one", "two");
        splits("\"on\\\ne\"", "one");
        splits("'on\\\ne'", "on\\\ne");
    }

    @Test
    void nothingIsExpanded() {
        splits("echo $HOME * ~ `date` | > & ; # $(x)",
            "echo", "$HOME", "*", "~", "`date`", "|", ">", "&", ";", "#", "$(x)");
    }

    @Test
    void errorsSayWhereAndWhat() {
        fails("a 'b c", "column 3: the single quote is never closed");
        fails("a b\"c d", "column 4: the double quote is never closed");
        fails("\"a\\\"", "column 1: the double quote is never closed");
        fails("\"a\\", "column 1: the double quote is never closed");
        fails("ab\\", "column 3: nothing follows the backslash");
        fails("a\0b", "column 2: a NUL character cannot be part of a command");
        fails("\ud83d\ude80 'x", "column 3: the single quote is never closed");
    }

    @Test
    void quotedWordsAreOnlyThoseThatNeedIt() {
        assertEquals("python3 -u a_b.py --x=1", CommandLine.quote(List.of("python3", "-u", "a_b.py", "--x=1")));
        assertEquals("'' 'a b' 'it'\\''s' '$x' 'a\nb'", CommandLine.quote(List.of("", "a b", "it's", "$x", "a\nb")));
        assertEquals("", CommandLine.quote(List.of()));
    }

    @Test
    void whatIsQuotedSplitsIntoTheSameWords() {
        long seed = new Random().nextLong();
        Random random = new Random(seed);
        String letters = "ab \t\n'\"\\$`*#~=;|&<>()[]{}!?-\u00e9\u4e16";
        for (int round = 0; round < 5000; round++) {
            List<String> words = new ArrayList<>();
            for (int w = random.nextInt(5); w > 0; w--) {
                StringBuilder word = new StringBuilder();
                for (int c = random.nextInt(8); c > 0; c--) {
                    word.append(letters.charAt(random.nextInt(letters.length())));
                }
                words.add(word.toString());
            }
            String line = CommandLine.quote(words);
            assertEquals(words, CommandLine.split(line), () -> "seed " + seed + ": <" + line + ">");
        }
    }
}
