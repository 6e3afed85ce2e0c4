package steward.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
import steward.bot.InProcessPlayer;
import steward.bot.TestBots;
import steward.bot.command.BotCommand;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Games;
import steward.cli.streams.Streams;
import steward.codingame.recording.OfficialGame;
import steward.game.GameSetup;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.match.Referee;
import steward.match.Seat;
import steward.match.TimeControl;
import steward.replay.Forge;
import steward.scene.SceneFiles;
import steward.scene.SceneReader;

/**
 * Files, answers and commands that are broken in ways nobody has thought of, see {@link Mutations}: which kinds there
 * are, how one is made from a seed and a number, and what has to become of it: a documented exit status and, where it
 * is refused, one message that names the place.
 */
final class BrokenInputs {

    /** Everything that can stand in it; its bots are not there, so that no game is played. */
    private static final String LEAGUE = """
        {
          "league": 1,
          "scene": "duel",
          "seed": "7",
          "pairing": "gauntlet b-1",
          "lag": 3,
          "hiccups": "count",
          "time": { "factor": 1.5, "basis": "wall" },
          "sandbox": { "level": "light", "memory": "512M", "processes": 64, "fileSize": "1G", "openFiles": 256,
            "network": true, "cleanEnvironment": true, "hold": "never", "environment": ["LANG"], "visible": ["/opt"] },
          "replays": { "keep": "lost", "of": ["b-1"] },
          "bots": [
            { "name": "b-1", "command": "codingame:./no-such-program --level 3", "files": ["a", "b"], "resumed": 2 },
            { "name": "c", "command": "./no-such-program", "retired": true, "random": true },
            { "name": "d", "command": "builtin:racer", "platforms": [
              { "platform": "linux-aarch64", "command": "./no-such-program", "files": ["a"] } ] },
            { "name": "d@linux-arm", "command": "./no-such-program" }
          ]
        }
        """;

    private static final Pattern QUOTED = Pattern.compile("\".*\"", Pattern.DOTALL);

    private final Path folder;
    private final long seed;

    /** @param folder for the files that are read and written */
    BrokenInputs(Path folder, long seed) {
        this.folder = folder;
        this.seed = seed;
    }

    /** Treatment of hashes in a broken replay: with right ones, more of it is read. */
    enum Hashes { AS_THEY_ARE, RIGHT }

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
    record Kind(String name, byte[] original, String file, List<String> beside, String call, Hashes hashes) {

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

    /** Inputs to break; made once. The replays are short, so that more are tried; two of their turns have impacts. */
    private static final class Originals {
        static final GameSetup DUEL = Games.open("duel");
        static final GameSetup SHORT = Games.types().open(SceneReader.read(
            text("duel").replaceFirst("\"maximumTurns\": [0-9]+", "\"maximumTurns\": 12"), "duel.json"));
        static final byte[] REPLAY = Recorded.play(SHORT, 7, "dd", 0).bytes();
        static final byte[] FAULTY = Recorded.play(SHORT, 7, "df", 9).bytes();
        static final byte[] RECORDING = OfficialGame.play(12).sketch(12).getBytes(StandardCharsets.UTF_8);
        static final String DEMAND = text("duel").replace("\"advance\": \"event\", \"arithmetic\": \"official\"",
            "\"maxPositionError\": 0.01, \"share\": 0.999");

        static String text(String scene) {
            return SceneFiles.load(scene).text();
        }
    }

    /** All kinds, each with a sound original. */
    static List<Kind> kinds() throws IOException {
        List<Kind> kinds = new ArrayList<>();
        for (String scene : List.of("duel", "walled-race")) {
            kinds.add(Kind.file("scene " + scene, Originals.text(scene), "s.json", "explain FILE"));
        }
        String figures;
        try (var in = BrokenInputs.class.getResourceAsStream("/scenes/duel.accuracy.json")) {
            figures = new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
        kinds.add(new Kind("figures", figures.getBytes(StandardCharsets.UTF_8), "s.accuracy.json",
            List.of("s.json", Originals.DEMAND),
            "explain s.json", Hashes.AS_THEY_ARE));
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
        kinds.add(league("list"));
        kinds.add(Kind.file("public key", "-----BEGIN PUBLIC KEY-----\n"
            + "MCowBQYDK2VwAyEAGhmrpVI9+WCl01n7z0to2Ve4DEzAEmZOUov8TpJKT98=\n-----END PUBLIC KEY-----\n", "my.key",
            "key show FILE"));
        kinds.add(Kind.file("private key", "-----BEGIN PRIVATE KEY-----\n"
            + "MC4CAQAwBQYDK2VwBCIEILwhFe32ZzA9NwP0hZw7nJU/jlQ3JlO7Ed20vasRgVSr\n-----END PRIVATE KEY-----\n",
            "my.key", "key show FILE"));
        return kinds;
    }

    /** A league.json that a command reads; to be played it lacks the programs. */
    static Kind league(String command) {
        return Kind.file("league.json, league " + command, LEAGUE, "./night/league.json", "league " + command
            + " ./night" + (command.equals("run") ? " --games 1" : ""));
    }

    /** Writes what stands beside the inputs of a kind. */
    void prepare(Kind kind) throws IOException {
        if (kind.file() != null) {
            Files.createDirectories(folder.resolve(kind.file()).getParent());
        }
        if (kind.beside().size() == 2) {
            Files.writeString(folder.resolve(kind.beside().get(0)), kind.beside().get(1));
        }
    }

    /** An input of a kind. */
    byte[] broken(Kind kind, int number) {
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

    private SplittableRandom random(int number) {
        return new SplittableRandom(seed * 1_000_003 + number);
    }

    /**
     * Calls the program with an input; whether it was refused.
     *
     * @throws AssertionError if it ends in another way than the documented ones
     */
    boolean check(Kind kind, byte[] broken) {
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
        String text = new String(broken, StandardCharsets.UTF_8);
        for (String line : said.split("\n")) {
            String problem = BadMessage.problem(line, text);
            assertEquals(null, problem, () -> problem + " in: " + said);
        }
        long messages = said.lines().filter(line -> line.startsWith("steward: ")
            && !line.startsWith("steward: warning: ")).count();
        if (status == ExitStatus.UNUSABLE) {
            assertEquals(1, messages, said);
            String place = kind.call().startsWith("simulate") ? "input line "
                : kind.file() == null ? "standard input" : "TMP/" + kind.file();
            assertTrue(said.contains(place) || said.contains("TMP/s.json:") || kind.name().equals("feed")
                || said.contains("found 3, expected 1 to") || isFedToNobody(kind, said), said);
        } else {
            assertEquals(status == ExitStatus.FAILED && frames ? 1 : 0, messages, said);
        }
        if (status == ExitStatus.FAILED && !frames) {
            assertFalse(out.toString(StandardCharsets.UTF_8).isBlank(), "nothing is said");
        }
        return status == ExitStatus.UNUSABLE && !isFedToNobody(kind, said);
    }

    /** True if a replay was read whole, and only the program is missing to which its frames are fed. */
    private static boolean isFedToNobody(Kind kind, String said) {
        return kind.call().startsWith("feed") && said.contains("no-such-program");
    }

    /**
     * A match with one broken answer: it has a result, and the fault says what was wrong; whether there is one.
     *
     * @throws AssertionError if it is said in words of Java
     */
    boolean answer(Protocol protocol, String original, int number) throws InterruptedException {
        byte[] broken = new Mutations(random(number)).of(original.getBytes(StandardCharsets.UTF_8));
        String answer = new String(broken, StandardCharsets.UTF_8);
        String fault = fault(Originals.DUEL, protocol, answer);
        if (fault == null) {
            return false;
        }
        // What is quoted of the answer may look like a place.
        String wrong = QUOTED.matcher(fault.replaceFirst("(?s); received: .*", ""))
            .replaceAll(quoted -> Matcher.quoteReplacement(quoted.group().replace(":", "")));
        assertEquals(null, BadMessage.problem(wrong), () -> "steward.seed " + seed + ", input " + number + ": "
            + fault + "\n--- the answer:\n" + answer);
        return true;
    }

    /**
     * A broken command of a bot, which is read and looked up but not started; whether it was refused.
     *
     * @throws AssertionError if it is refused in words of Java, or does not mean the same when it is written anew
     */
    boolean command(String original, int number) {
        String text = new String(new Mutations(random(number)).of(original.getBytes(StandardCharsets.UTF_8)),
            StandardCharsets.UTF_8);
        BotCommand command;
        try {
            command = BotCommand.parse(text);
        } catch (IllegalArgumentException refusal) {
            assertTrue(refusal.getMessage().startsWith("bot "), refusal.getMessage());
            return true;
        }
        BotCommand again = BotCommand.parse(command.toString());
        assertEquals(command.words(), again.words(), text);
        assertEquals(command.prefix(), again.prefix(), text);
        try {
            assertFalse(command.displayName(Path.of("")) == null || command.resolve(Path.of("")).isEmpty(), text);
            return false;
        } catch (IllegalArgumentException refusal) {
            assertTrue(refusal.getMessage().startsWith("bot "), refusal.getMessage());
            return true;
        }
    }

    /** The fault of the first answer; later ones are no answers. */
    private static String fault(GameSetup setup, Protocol protocol, String answer) throws InterruptedException {
        List<Seat> seats = Stream.of(answer, "nonsense").map(first -> new Seat(new InProcessPlayer("a",
            TestBots.byTurn(turn -> turn == 1 ? first : "nonsense")), protocol)).toList();
        MatchResult result = Referee.of(setup, 7, seats, TimeControl.UNLIMITED, new MatchListener() { }).play();
        return result.players().get(0).answers() == 1 ? result.players().get(0).fault() : null;
    }
}
