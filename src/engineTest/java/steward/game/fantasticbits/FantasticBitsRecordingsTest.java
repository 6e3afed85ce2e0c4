package steward.game.fantasticbits;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.game.ChangedWords;
import steward.game.CodecText;
import steward.game.Comparison;
import steward.game.GroundTruth;
import steward.game.TextCodec;

/**
 * Games of the server as its console shows them (in French): what player 0 echoes of its input, the answers of both,
 * what the server says of them, scores and magic. The seed is unknown: snaffles begin where the first turn shows them.
 */
@Execution(ExecutionMode.CONCURRENT)
class FantasticBitsRecordingsTest {

    private static final String TURN = "Sortie d'erreur :";
    private static final String ANSWER = "Sortie standard :";
    private static final Pattern WORD = Pattern.compile("[^\\s():,]+");

    @Test
    void everyTurnThatTheConsoleShowsIsReproduced(TestReporter report) throws IOException {
        GroundTruth.Report all = new GroundTruth.Report(report, "fantastic-bits");
        for (Path file : GroundTruth.RECORDINGS.files("fantastic-bits", ".txt.gz")) {
            Console console = new Console(file.getFileName().toString(), GroundTruth.text(file).lines().toList());
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
        List<String> lines = GroundTruth.text(GroundTruth.RECORDINGS.files("fantastic-bits",
            "sample3-turns1-60.txt.gz").get(0)).lines().toList();
        Set<String> missed = new TreeSet<>();
        int changed = 0;
        for (String deed : List.of("throws", "casts")) {
            int at = lines.indexOf(lines.stream().filter(line -> line.contains(deed)).findFirst().orElseThrow());
            int from = lines.subList(0, at).lastIndexOf(TURN);
            int to = at + lines.subList(at, lines.size()).indexOf(TURN);
            int echo = from + lines.subList(from, to).indexOf(ANSWER);
            for (int line = from; line < to; line++) {
                String text = lines.get(line);
                boolean shown = text.matches(line < echo ? "\\d+ [A-Z_]+ .*" : "[A-Z].* -?\\d.*");
                List<String> other = new ArrayList<>(lines.subList(0, to));
                for (ChangedWords change : ChangedWords.of(shown ? text : "", WORD, ChangedWords::otherEnd)) {
                    other.set(line, change.text());
                    changed++;
                    if (!isFound(other)) {
                        missed.add(change.was());
                    }
                }
            }
        }
        GroundTruth.tell(report, ChangedWords.told("fantastic-bits, console", changed, missed));
        assertEquals(Set.of("DumbleBoss", "Storm"), missed);
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

    /** One game, played again with the answers of its console, beside which stands what ours would show. */
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
            List<String> first = lines.subList(1, lines.indexOf(ANSWER)).stream()
                .filter(line -> line.contains(" SNAFFLE ")).toList();
            Pitch pitch = new Pitch(first.size(), 2);
            for (String line : first) {
                String[] words = line.split(" ");
                pitch.bodies().setPosition(Integer.parseInt(words[0]), Double.parseDouble(words[2]),
                    Double.parseDouble(words[3]));
            }
            FantasticBits any = FantasticBitsReplay.setup(Variant.CONTEST).create(0);
            game = Pitches.game(any, pitch, new int[2], new int[2]);
            codec = FantasticBitsReplay.setup(Variant.CONTEST).textCodec(game).orElseThrow();
        }

        void compare() {
            while (at < lines.size()) {
                switch (lines.get(at++)) {
                    case TURN -> expect(input());
                    case ANSWER -> answer();
                    case "Informations :" -> expect(deeds(answers - 1));
                    case "R\u00e9sum\u00e9 du jeu :" -> expect(standing());
                    default -> { }                            // the bot's own words, and numbers of lines
                }
            }
        }

        /** Compares as many lines, word by word; names of players stand before what is ours. */
        private void expect(List<String> ours) {
            String when = "turn " + (game.turn() + 1) + ", line ";
            for (String line : ours) {
                if (lines.get(at).equals("End reached")) {
                    comparison.same(when + "the end", true, game.isOver());
                    at++;
                }
                String[] shown = lines.get(at++).replaceFirst("^[A-Z]\\w+:? ", "").split(" ");
                String[] found = line.split(" ");
                comparison.same(when + at + ", words", shown.length, found.length);
                for (int k = 0; k < Math.min(shown.length, found.length); k++) {
                    comparison.same(when + at + ", word " + k, shown[k], found[k]);
                }
            }
            comparison.same(when + "behind it", false, at < lines.size() && lines.get(at).matches("\\d+ [A-Z_]+ .*"));
        }

        private List<String> input() {
            return ((game.turn() == 0 ? CodecText.setup(codec, 0) : "") + CodecText.turn(codec, 0)).lines().toList();
        }

        private void answer() {
            String wrong = CodecText.read(codec, answers, lines.get(at) + "\n" + lines.get(at + 1));
            comparison.same("turn " + (game.turn() + 1) + " answer of " + answers, "good",
                wrong == null ? "good" : wrong);
            answers++;
            at += 2;
        }

        /** The server's words about an answer. */
        private List<String> deeds(int player) {
            List<String> deeds = new ArrayList<>();
            for (int k = 0; k < Pitch.WIZARDS_PER_PLAYER; k++) {
                WizardCommand command = game.command(player, k);
                if (command == null) {
                    return deeds;                             // the answer was refused
                }
                String place = " coordinate (" + (long) command.x() + ", " + (long) command.y() + ") with ";
                deeds.add("Wizard " + (player * Pitch.WIZARDS_PER_PLAYER + k) + " " + switch (command.action()) {
                    case MOVE -> "moves towards" + place + "thrust " + (long) command.power();
                    case THROW -> "throws the snaffle to" + place + "power " + (long) command.power();
                    case CAST -> "casts " + command.spell().name().charAt(0) + command.spell().name().substring(1)
                        .toLowerCase(Locale.ROOT) + " on entity " + command.target();
                });
            }
            return deeds;
        }

        /** Plays the turn. @return of each player the score, the magic, and what its wizards have caught */
        private List<String> standing() {
            comparison.same("turn " + (game.turn() + 1) + " answers", 2, answers);
            answers = 0;
            game.play();
            List<String> standing = new ArrayList<>();
            for (int player = 0; player < game.players(); player++) {
                standing.add("Score: " + game.score(player) + " | Magic: " + game.magic(player));
                int first = standing.size();
                for (int k = 0; k < game.log().facts(); k++) {
                    if (game.log().factKind(k) == Captures.CAPTURE && Pitch.playerOf(game.log().factA(k)) == player) {
                        standing.add(game.log().factA(k) + " caught snaffle " + game.log().factB(k));
                    }
                }
                Collections.sort(standing.subList(first, standing.size()));
            }
            return standing;
        }
    }
}
