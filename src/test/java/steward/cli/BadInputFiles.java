package steward.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.codingame.recording.OfficialGame;
import steward.replay.sign.SigningKey;
import steward.scene.SceneFiles;

/**
 * Makes the files of an entry of the table of bad inputs, each from a base:
 * <ul>
 * <li>{@code empty}; {@code folder};
 * <li>{@code scene NAME}, a shipped scene; {@code figures NAME}, the figures of its accuracy;
 * <li>{@code replay}, of the scene duel; {@code recording}, CodinGame's JSON of a game of ours; {@code simulation}, an
 *     input of {@code steward simulate};
 * <li>{@code key}, a private key, with its public one in FILE.pub;
 * <li>{@code bot}, the script of {@link ShellBots}, and {@code lines}, that of {@link TextShellBots}; {@code short}, a
 *     duel of 8 turns, and {@code drawn}, one whose places the seed draws;
 * <li>{@code there}, the file that an earlier call left; {@code gone}, none.
 * </ul>
 * and from the lines below it: {@code - OLD} and {@code + NEW} replace a text that is there; {@code + NEW} alone goes
 * to the end; {@code ~ N bytes} and {@code ~ N lines} keep the beginning; {@code ~ N times TEXT} goes to the end.
 * {@code \n}, {@code \t}, {@code \\} and {@code \xHH}, a byte, are what they usually are.
 */
final class BadInputFiles {

    private static final Pattern ESCAPE = Pattern.compile("\\\\(n|t|\\\\|x[0-9a-f]{2})");
    private static final Pattern KEPT = Pattern.compile("(\\d+) (bytes|lines|times)(?: (.*))?");

    private static final String SIMULATION = """
        2
        1000 1000
        9000 5000
        1
        1000 1000 0 0 0 1 0 0
        2000 1000 0 0 0 1 0 0
        3000 1000 0 0 0 1 0 0
        4000 1000 0 0 0 1 0 0
        9000 5000 100
        9000 5000 100
        9000 5000 100
        9000 5000 100
        """;

    /** Files that are made once. */
    private static final class Bases {
        /** All answers took as long: columns are the same every time. */
        static final String REPLAY = bytes(Recorded.duel(7).bytes())
            .replaceAll("\"answerNanos\":\\[[^]]*]", "\"answerNanos\":[1000,2000]");
        static final String RECORDING = OfficialGame.play(12).json();
    }

    private final Path folder;

    /** The content of the files, a character for each byte. */
    private final Map<String, String> contents = new LinkedHashMap<>();

    /** @param folder the files go there */
    BadInputFiles(Path folder) {
        this.folder = folder;
    }

    /**
     * Makes all files.
     *
     * @return the standard input
     */
    byte[] make(List<String> recipe) throws IOException {
        String name = null;
        String old = null;
        for (String line : recipe) {
            String rest = line.length() < 2 ? "" : line.substring(2);
            switch (line.charAt(0)) {
                case '<' -> {
                    String[] words = rest.split(" ", 2);
                    name = words[0];
                    begin(name, words[1]);
                }
                case '-' -> old = text(rest);
                case '?' -> { }
                case '+' -> {
                    change(name, old, text(rest));
                    old = null;
                }
                default -> keep(name, rest);
            }
        }
        for (Map.Entry<String, String> file : contents.entrySet()) {
            if (!file.getKey().equals("-")) {
                Files.write(folder.resolve(file.getKey()), file.getValue().getBytes(StandardCharsets.ISO_8859_1));
            }
        }
        return contents.getOrDefault("-", "").getBytes(StandardCharsets.ISO_8859_1);
    }

    private void begin(String name, String base) throws IOException {
        String[] words = base.split(" ");
        switch (words[0]) {
            case "folder" -> Files.createDirectories(folder.resolve(name));
            case "key" -> SigningKey.generate().write(folder.resolve(name));
            case "empty" -> contents.put(name, "");
            case "scene" -> contents.put(name, utf8(SceneFiles.load(words[1]).text()));
            case "figures" -> contents.put(name, resource("/scenes/" + words[1] + ".accuracy.json"));
            case "replay" -> contents.put(name, Bases.REPLAY);
            case "recording" -> contents.put(name, utf8(Bases.RECORDING));
            case "simulation" -> contents.put(name, SIMULATION);
            case "bot" -> contents.put(name, utf8(ShellBots.ANSWER));
            case "lines" -> contents.put(name, utf8(TextShellBots.SCRIPT));
            case "short" -> contents.put(name, utf8(ShellBots.shortDuel(8)));
            case "drawn" -> contents.put(name, utf8(ShellBots.drawn(ShellBots.shortDuel(8))));
            case "there" -> contents.put(name, bytes(Files.readAllBytes(folder.resolve(name))));
            case "gone" -> Files.delete(folder.resolve(name));
            default -> throw new AssertionError("no such base of a file: " + base);
        }
    }

    private static String resource(String name) throws IOException {
        try (var in = BadInputFiles.class.getResourceAsStream(name)) {
            return bytes(in.readAllBytes());
        }
    }

    private void change(String name, String old, String replacement) {
        String content = contents.get(name);
        if (old == null) {
            contents.put(name, content + replacement);
            return;
        }
        int at = content.indexOf(old);
        assertTrue(at >= 0, () -> name + ": there is no " + old + " in " + content);
        contents.put(name, content.substring(0, at) + replacement + content.substring(at + old.length()));
    }

    private void keep(String name, String what) {
        Matcher kept = KEPT.matcher(what);
        assertTrue(kept.matches(), what);
        int count = Integer.parseInt(kept.group(1));
        String content = contents.get(name);
        contents.put(name, switch (kept.group(2)) {
            case "bytes" -> content.substring(0, count);
            case "lines" -> String.join("", lines(content).subList(0, count));
            default -> content + text(kept.group(3)).repeat(count);
        });
    }

    private static List<String> lines(String content) {
        List<String> lines = new ArrayList<>();
        for (int from = 0; from < content.length();) {
            int end = content.indexOf('\n', from) + 1;
            end = end == 0 ? content.length() : end;
            lines.add(content.substring(from, end));
            from = end;
        }
        assertEquals(content.length(), lines.stream().mapToInt(String::length).sum());
        return lines;
    }

    /** As bytes, with its escapes. */
    private static String text(String written) {
        return ESCAPE.matcher(utf8(written)).replaceAll(match -> Matcher.quoteReplacement(switch (match.group(1)) {
            case "n" -> "\n";
            case "t" -> "\t";
            case "\\" -> "\\";
            default -> String.valueOf((char) Integer.parseInt(match.group(1).substring(1), 16));
        }));
    }

    private static String utf8(String text) {
        return bytes(text.getBytes(StandardCharsets.UTF_8));
    }

    private static String bytes(byte[] bytes) {
        return new String(bytes, StandardCharsets.ISO_8859_1);
    }
}
