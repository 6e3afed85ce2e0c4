package steward.game.fantasticbits;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.game.Comparison;
import steward.game.GroundTruth;
import steward.game.TextCodec;

/**
 * Games of the server as its console shows them (in French): what player 0 echoes of its input, the answers of both,
 * what the server says of them, scores and magic. The seed is unknown: snaffles begin where the first turn shows them.
 */
@Execution(ExecutionMode.CONCURRENT)
class FantasticBitsRecordingsTest {

    private static final Pattern ENTITY = Pattern.compile("(\\d+) ([A-Z_]+) (-?\\d+) (-?\\d+) (-?\\d+) (-?\\d+) (\\d)");
    private static final Pattern STANDING = Pattern.compile(".* Score: (-?\\d+) \\| Magic: (\\d+)");
    private static final Pattern CAUGHT = Pattern.compile("\\w+ (\\d) caught snaffle (\\d+)");
    private static final Pattern TOLD = Pattern.compile("\\w+: Wizard (\\d) (.*)");
    private static final String TURN = "Sortie d'erreur :";
    private static final Pattern WORD = Pattern.compile("[^\\s():,]+");

    @Test
    void everyTurnThatTheConsoleShowsIsReproduced(TestReporter report) throws IOException {
        GroundTruth.Report all = new GroundTruth.Report(report, "fantastic-bits");
        for (Path file : GroundTruth.RECORDINGS.files("fantastic-bits", ".txt.gz")) {
            Console console = new Console(file.getFileName().toString(), lines(file));
            console.compare();
            all.add(file.getFileName().toString(), console.game.turn(), console.comparison.values(),
                console.comparison.differences().stream().findFirst().orElse(null), List.of("names, line numbers"));
        }
        assertTrue(all.values() > 0, "the folder holds games");
        assertEquals(List.of(), all.differences().stream().limit(20).toList());
    }

    /** Changes each number and word of a turn in which wizards throw, and of one in which one casts, one at a time. */
    @Test
    @Tag("slow")
    void everyWordOfATurnIsCompared(TestReporter report) throws IOException {
        List<String> lines = lines(GroundTruth.RECORDINGS.files("fantastic-bits", "sample3-turns1-60.txt.gz").get(0));
        Set<String> missed = new TreeSet<>();
        int changed = 0;
        for (String deed : List.of("throws", "casts")) {
            int at = lines.indexOf(lines.stream().filter(line -> line.contains(deed)).findFirst().orElseThrow());
            int from = lines.subList(0, at).lastIndexOf(TURN);
            int to = at + lines.subList(at, lines.size()).indexOf(TURN);
            int echo = from + lines.subList(from, to).indexOf("Sortie standard :");
            for (int line = from; line < to; line++) {
                String text = lines.get(line);
                boolean shown = line < echo ? ENTITY.matcher(text).matches() : text.matches("[A-Z].* -?\\d.*");
                Matcher word = WORD.matcher(shown ? text : "");
                while (word.find()) {
                    List<String> other = new ArrayList<>(lines.subList(0, to));
                    int last = word.end() - 1;
                    String end = Character.isDigit(text.charAt(last)) ? "" + (text.charAt(last) - '0' + 5) % 10
                        : text.charAt(last) + "x";
                    other.set(line, text.substring(0, last) + end + text.substring(word.end()));
                    changed++;
                    if (!isFound(other)) {
                        missed.add(word.group());
                    }
                }
            }
        }
        GroundTruth.tell(report, "fantastic-bits, console: " + changed + " numbers and words changed one at a time, "
            + "not found: " + missed);
        assertEquals(Set.of("DumbleBoss", "Storm", "Wizard"), missed);
    }

    private static boolean isFound(List<String> lines) {
        try {
            Console console = new Console("changed", lines);
            console.compare();
            return !console.comparison.differences().isEmpty();
        } catch (NumberFormatException | IndexOutOfBoundsException refused) {
            return true;
        }
    }

    private static List<String> lines(Path file) throws IOException {
        try (InputStream in = new GZIPInputStream(Files.newInputStream(file))) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8).lines().toList();
        }
    }

    /** One game, played again while its console is read. */
    private static final class Console {

        private final List<String> lines;
        private final Comparison comparison;
        private final FantasticBits game;
        private final TextCodec codec;
        private int at;
        private int answers;

        Console(String name, List<String> lines) {
            this.lines = lines;
            comparison = new Comparison(name);
            List<String> first = lines.subList(1, lines.indexOf("Sortie standard :")).stream()
                .filter(line -> line.contains(" SNAFFLE ")).toList();
            Pitch pitch = new Pitch(first.size(), 2);
            for (String line : first) {
                String[] words = line.split(" ");
                pitch.bodies().setPosition(Integer.parseInt(words[0]), Double.parseDouble(words[2]),
                    Double.parseDouble(words[3]));
            }
            FantasticBits any = FantasticBitsReplay.setup(Variant.CONTEST).create(0);
            game = any.on(pitch, new int[2], new int[2]);
            codec = FantasticBitsReplay.setup(Variant.CONTEST).textCodec(game).orElseThrow();
        }

        void compare() {
            while (at < lines.size()) {
                switch (lines.get(at++)) {
                    case TURN -> compareInput();
                    case "Sortie standard :" -> answer();
                    case "R\u00e9sum\u00e9 du jeu :" -> compareStanding();
                    default -> compareTold(lines.get(at - 1));
                }
            }
        }

        /** The server's words about an answer name the wizard and what it does. */
        private void compareTold(String line) {
            Matcher told = TOLD.matcher(line);
            int wizard = told.matches() ? Integer.parseInt(told.group(1)) : 0;
            WizardCommand command = game.command(wizard / 2, wizard % 2);
            if (told.matches() && command != null) {
                String place = " coordinate (" + (long) command.x() + ", " + (long) command.y() + ") with ";
                String ours = switch (command.action()) {
                    case MOVE -> "moves towards" + place + "thrust " + (long) command.power();
                    case THROW -> "throws the snaffle to" + place + "power " + (long) command.power();
                    case CAST -> "casts " + command.spell().name().charAt(0) + command.spell().name().substring(1)
                        .toLowerCase(Locale.ROOT) + " on entity " + command.target();
                };
                compareWords("turn " + (game.turn() + 1) + " wizard " + wizard + " ", told.group(2), ours);
            }
        }

        private void compareInput() {
            StringBuilder text = new StringBuilder();
            if (game.turn() == 0) {
                codec.writeSetup(text, 0);
            }
            codec.writeTurn(text, 0);
            List<String> found = text.toString().lines().toList();
            String when = "turn " + (game.turn() + 1) + " input, line ";
            for (int k = 0; k < found.size(); k++) {
                compareWords(when + (k + 1) + " ", lines.get(at + k), found.get(k));
            }
            at += found.size();
            comparison.same(when + "after the last", false, ENTITY.matcher(lines.get(at)).matches());
        }

        private void compareWords(String what, String recorded, String found) {
            String[] shown = recorded.split(" ");
            String[] ours = found.split(" ");
            comparison.same(what + "words", shown.length, ours.length);
            for (int k = 0; k < Math.min(shown.length, ours.length); k++) {
                comparison.same(what + k, shown[k], ours[k]);
            }
        }

        private void answer() {
            byte[] answer = (lines.get(at) + "\n" + lines.get(at + 1)).getBytes(StandardCharsets.UTF_8);
            comparison.same("turn " + (game.turn() + 1) + " answer of " + answers, "good",
                String.valueOf(codec.readAnswer(answers, answer, answer.length)).replace("null", "good"));
            answers++;
            at += 2;
        }

        private void compareStanding() {
            comparison.same("turn " + (game.turn() + 1) + " answers", 2, answers);
            answers = 0;
            game.play();
            List<String> shown = new ArrayList<>();
            int player = 0;
            for (; at < lines.size() && !lines.get(at).startsWith("Sortie"); at++) {
                if (lines.get(at).equals("End reached")) {
                    comparison.same("turn " + game.turn() + " is the last", true, game.isOver());
                    continue;
                }
                Matcher caught = CAUGHT.matcher(lines.get(at));
                if (caught.matches()) {
                    shown.add(caught.group(1) + " caught " + caught.group(2));
                    continue;
                }
                Matcher standing = STANDING.matcher(lines.get(at));
                comparison.same("turn " + game.turn() + " standing is shown", true, standing.matches());
                if (!standing.matches() || player >= game.players()) {
                    continue;                                 // what else a console says
                }
                comparison.same("turn " + game.turn() + " score", Integer.parseInt(standing.group(1)),
                    game.score(player));
                comparison.same("turn " + game.turn() + " magic", Integer.parseInt(standing.group(2)),
                    game.magic(player++));
            }
            List<String> found = new ArrayList<>();
            for (int k = 0; k < game.log().facts(); k++) {
                if (game.log().factKind(k) == Captures.CAPTURE) {
                    found.add(game.log().factA(k) + " caught " + game.log().factB(k));
                }
            }
            Collections.sort(found);
            Collections.sort(shown);
            comparison.same("turn " + game.turn() + " captures", shown, found);
        }
    }
}
