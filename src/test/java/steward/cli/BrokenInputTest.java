package steward.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import steward.bot.Bot;
import steward.bot.InProcessPlayer;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Games;
import steward.cli.shared.Streams;
import steward.codingame.OfficialGame;
import steward.game.GameSetup;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.match.Referee;
import steward.match.Seat;
import steward.match.TimeControl;
import steward.replay.Forge;
import steward.scene.SceneFiles;

/**
 * Files and answers that are broken in ways nobody has thought of, see {@link Mutations}: every one ends with a
 * documented exit status and, where it is refused, with one message that names the place.
 *
 * <p>{@code -Dsteward.inputs=N} tries so many of each kind, {@code -Dsteward.seed=S} others.
 */
class BrokenInputTest {

    private static final int INPUTS = Integer.getInteger("steward.inputs", 60);
    private static final Pattern QUOTED = Pattern.compile("\".*\"", Pattern.DOTALL);
    private static final long SEED = Long.getLong("steward.seed", 12);

    /** Whether the input is a replay whose lines get the hashes that belong to them, so that more of it is read. */
    private enum Hashes { AS_THEY_ARE, RIGHT }

    /**
     * A kind of broken input.
     *
     * @param name     for failures
     * @param original what is broken
     * @param file     the name it gets, or null for the standard input
     * @param beside   another file, its name and text, or empty
     * @param call     with {@code FILE} for the file
     * @param hashes   of replays
     */
    private record Kind(String name, byte[] original, String file, List<String> beside, String call, Hashes hashes) {

        static Kind file(String name, String original, String file, String call) {
            return new Kind(name, original.getBytes(StandardCharsets.UTF_8), file, List.of(), call,
                Hashes.AS_THEY_ARE);
        }

        static Kind input(String name, byte[] original, String call) {
            return new Kind(name, original, null, List.of(), call, Hashes.AS_THEY_ARE);
        }

        Kind rehashed() {
            return new Kind(name + ", with right hashes", original, file, beside, call, Hashes.RIGHT);
        }

        @Override
        public String toString() {
            return name;
        }
    }

    /** What is broken; made once. */
    private static final class Originals {
        static final byte[] REPLAY = Recorded.duel(7).bytes();
        static final byte[] FAULTY = Recorded.play(Games.open("duel"), 7, "df", 9).bytes();
        static final byte[] RECORDING = OfficialGame.play(12).sketch(12).getBytes(StandardCharsets.UTF_8);
        static final String DEMAND = text("duel").replace("\"advance\": \"event\", \"arithmetic\": \"official\"",
            "\"maxPositionError\": 0.01, \"share\": 0.999");

        static String text(String scene) {
            return SceneFiles.load(scene).text();
        }
    }

    @TempDir
    private Path folder;

    static Stream<Kind> kinds() throws IOException {
        List<Kind> kinds = new ArrayList<>();
        for (String scene : List.of("duel", "walled-race")) {
            kinds.add(Kind.file("scene " + scene, Originals.text(scene), "s.json", "explain FILE --no-prices"));
        }
        String figures;
        try (var in = BrokenInputTest.class.getResourceAsStream("/scenes/duel.accuracy.json")) {
            figures = new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
        kinds.add(new Kind("figures", figures.getBytes(StandardCharsets.UTF_8), "s.accuracy.json",
            List.of("s.json", Originals.DEMAND.replace("\"mass\": 1 ", "\"mass\": 2 ")),
            "explain s.json --no-prices", Hashes.AS_THEY_ARE));
        for (String options : List.of("", "--verify", "--verify --json", "--turn 3", "--turn 3 --json", "--impacts",
                "--impacts --json", "--json", "--frames --player 1", "--quiet")) {
            Kind kind = Kind.input("replay " + options, options.contains("3") ? Originals.FAULTY : Originals.REPLAY,
                "replay - " + options);
            kinds.add(kind);
            kinds.add(kind.rehashed());
        }
        Kind page = new Kind("page", Originals.REPLAY, "m.jsonl", List.of(),
            "replay FILE --view page.html --overwrite --quiet", Hashes.AS_THEY_ARE);
        kinds.add(page);
        kinds.add(page.rehashed());
        Kind feed = Kind.input("feed", Originals.FAULTY, "feed - --player 0 -- no-such-program");
        kinds.add(feed);
        kinds.add(feed.rehashed());
        kinds.add(Kind.input("import", Originals.RECORDING, "import - --out imported.jsonl --overwrite"));
        Path excerpt = Path.of(System.getProperty("steward.replays", ""), "game_870230020_excerpt.json");
        if (Files.isRegularFile(excerpt)) {
            kinds.add(Kind.input("import of an excerpt", Files.readAllBytes(excerpt),
                "import - --out imported.jsonl --overwrite"));
        }
        kinds.add(Kind.input("simulate", """
            2
            1000 1000
            9000 5000
            1
            1000 1000 0 0 0 1 0 0
            2000 1000 10.5 0 359.5 1 3 0
            3000 1000 0 -1 0 1 0 1
            4000 1000 0 0 0 0 0 0
            9000 5000 100
            9000 5000 SHIELD
            9000 5000 BOOST
            9000 5000 0
            """.getBytes(StandardCharsets.UTF_8), "simulate"));
        kinds.add(Kind.file("key", "-----BEGIN PUBLIC KEY-----\nMCowBQYDK2VwAyEA\n-----END PUBLIC KEY-----\n", "my.key",
            "key show FILE"));
        return kinds.stream();
    }

    @ParameterizedTest
    @MethodSource("kinds")
    @Timeout(7200)
    void endsWithAStatusAndOneMessage(Kind kind) throws IOException {
        if (kind.beside().size() == 2) {
            Files.writeString(folder.resolve(kind.beside().get(0)), kind.beside().get(1));
        }
        int refused = 0;
        for (int number = 0; number < INPUTS; number++) {
            byte[] broken = broken(kind, number);
            try {
                refused += check(kind, broken) ? 1 : 0;
            } catch (AssertionError | RuntimeException problem) {
                fail(kind.name() + ", steward.seed " + SEED + ", input " + number + ": " + problem.getMessage()
                    + "\n--- the input:\n" + shown(broken), problem);
            }
        }
        assertTrue(refused > 0, "nothing was refused");
    }

    private static byte[] broken(Kind kind, int number) {
        byte[] bytes = new Mutations(random(number)).of(kind.original());
        if (kind.hashes() == Hashes.AS_THEY_ARE) {
            return bytes;
        }
        StringBuilder lines = new StringBuilder();
        for (String line : new String(bytes, StandardCharsets.UTF_8).split("\n")) {
            lines.append(rehashed(line)).append('\n');
        }
        return lines.toString().getBytes(StandardCharsets.UTF_8);
    }

    /** A line that has no hash, or is too broken to have one, as it is. */
    private static String rehashed(String line) {
        try {
            return Forge.rehash(line);
        } catch (RuntimeException | AssertionError broken) {
            return line;
        }
    }

    private static SplittableRandom random(int number) {
        return new SplittableRandom(SEED * 1_000_003 + number);
    }

    private static String shown(byte[] bytes) {
        String text = new String(bytes, StandardCharsets.UTF_8);
        return text.length() < 5000 ? text : text.substring(0, 5000) + "...";
    }

    /** Whether it was refused. */
    private boolean check(Kind kind, byte[] broken) {
        byte[] input = new byte[0];
        Path file = kind.file() == null ? null : folder.resolve(kind.file());
        try {
            if (file == null) {
                input = broken;
            } else {
                Files.write(file, broken);
            }
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
        String[] arguments = Stream.of(kind.call().split(" "))
            .map(word -> word.equals("FILE") || word.contains(".") ? folder.resolve(word.equals("FILE") ? kind.file()
                : word).toString() : word).toArray(String[]::new);
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        int status = Main.run(new Streams(new ByteArrayInputStream(input), false, out, err, false, false), arguments);
        String said = err.toString(StandardCharsets.UTF_8).replace(folder.toString(), "TMP");
        boolean frames = kind.call().contains("--frames");            // are made by playing again
        boolean playsAgain = frames || kind.call().contains("--verify");
        assertTrue(status == ExitStatus.DONE || status == ExitStatus.UNUSABLE
            || status == ExitStatus.FAILED && playsAgain, () -> "status " + status + "\n" + said);
        for (String line : said.split("\n")) {
            String problem = BadMessage.problem(line);
            assertEquals(null, problem, () -> problem + " in: " + said);
        }
        long messages = said.lines().filter(line -> line.startsWith("steward: ")
            && !line.startsWith("steward: warning: ")).count();
        if (status == ExitStatus.UNUSABLE) {
            assertEquals(1, messages, said);
            String place = kind.call().startsWith("simulate") ? "input line "
                : kind.file() == null ? "standard input" : "TMP/" + kind.file();
            assertTrue(said.contains(place) || said.contains("TMP/s.json:") || kind.name().equals("feed")
                || said.contains("found 3, expected 1 to") || said.contains("no-such-program"), said);
        } else {
            assertEquals(status == ExitStatus.FAILED && frames ? 1 : 0, messages, said);
        }
        if (status == ExitStatus.FAILED && !frames) {
            assertFalse(out.toString(StandardCharsets.UTF_8).isBlank(), "nothing is said");
        }
        return status == ExitStatus.UNUSABLE;
    }

    @Test
    void anAnswerInJson() throws InterruptedException {
        answers(Protocol.JSON, "{\"pods\":[{\"x\":1,\"y\":2.5,\"thrust\":100}],\"message\":\"hello\"}");
        answers(Protocol.JSON, "{\"pods\":[{\"x\":1,\"y\":2,\"shield\":true}]}");
    }

    @Test
    void anAnswerInWords() throws InterruptedException {
        answers(Protocol.CODINGAME, "1000 2000 100 hello");
        answers(Protocol.CODINGAME, "1000 -20 SHIELD");
    }

    /** A league of bots that each give one broken answer: the match has a result, and the fault says what was wrong. */
    private static void answers(Protocol protocol, String original) throws InterruptedException {
        GameSetup setup = Games.open("duel");
        int faults = 0;
        for (int number = 0; number < 10 * INPUTS; number++) {
            byte[] broken = new Mutations(random(number)).of(original.getBytes(StandardCharsets.UTF_8));
            String answer = new String(broken, StandardCharsets.UTF_8);
            String fault = fault(setup, protocol, answer);
            if (fault != null) {
                faults++;
                assertNotNull(fault, answer);
                int input = number;
                // What is quoted of the answer may look like a place.
                String wrong = QUOTED.matcher(fault.replaceFirst("(?s); received: .*", ""))
                    .replaceAll(quoted -> Matcher.quoteReplacement(quoted.group().replace(":", "")));
                assertEquals(null, BadMessage.problem(wrong), () -> "steward.seed " + SEED + ", input " + input + ": "
                    + fault + "\n--- the answer:\n" + answer);
            }
        }
        assertTrue(faults > 0, "no answer was refused");
    }

    private static String fault(GameSetup setup, Protocol protocol, String answer) throws InterruptedException {
        List<Seat> seats = List.of(new Seat(new InProcessPlayer("a", new Once(answer)), protocol),
            new Seat(new InProcessPlayer("b", new Once("nonsense")), protocol));
        MatchResult result = Referee.of(setup, 7, seats, TimeControl.UNLIMITED, new MatchListener() { }).play();
        return result.players().get(0).answers() == 1 ? result.players().get(0).fault() : null;
    }

    /** Answers once, then never well again. */
    private static final class Once implements Bot {

        private String answer;

        Once(String answer) {
            this.answer = answer;
        }

        @Override
        public void setup(String line) {
            return;
        }

        @Override
        public String turn(String line) {
            String said = answer;
            answer = "nonsense";
            return said;
        }
    }
}
