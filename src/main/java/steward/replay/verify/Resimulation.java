package steward.replay.verify;

import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;
import steward.files.JarFolder;
import steward.files.Remedied;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.game.GameType;
import steward.game.GameTypes;
import steward.game.ViewWriter;
import steward.json.LineParser;
import steward.match.GuestSetup;
import steward.replay.RecordedTurn;
import steward.replay.ReplayException;
import steward.replay.ReplayHeader;
import steward.scene.Scene;
import steward.scene.SceneReader;
import steward.scene.json.JsonProblem;
import steward.text.TextFormat;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;

/** Re-simulation of a recorded match from its scene, seed, commands and faults. */
public final class Resimulation {

    /** Characters of a wrong name that errors show. */
    private static final int SHOWN = 60;
    private static final byte[] NULL = {'n', 'u', 'l', 'l'};

    private final GameSetup setup;
    private final Game game;
    private final GameJson codec;
    /** Name of the replay whose referee only says what is recorded; {@code null} otherwise. */
    private final String recorded;
    private final LineParser lines = new LineParser();
    private final String[] noFaults;
    private byte[] outcome;

    /**
     * @param start  of the match as JSON, where what a referee of its own said is enough; {@code null} to run it
     * @param source name of the replay, for errors about its scene
     * @throws ReplayException              if the header says another game or number of players than its scene, or a
     *                                      law that this program does not play
     * @throws steward.scene.json.SceneException if the scene in the header is not one that the known games can play
     */
    public Resimulation(ReplayHeader header, byte[] start, GameTypes types, String source) {
        this(header, start, types, source, null);
    }

    /** @param views writes what a server would have shown of the match, so that the game records it; or {@code null} */
    Resimulation(ReplayHeader header, byte[] start, GameTypes types, String source, ViewWriter views) {
        outcome = start;
        Scene scene = SceneReader.read(header.scene(), source + " (scene)");
        if (types.guest() == null || !types.guest().id().equals(header.game())) {
            checkJar(header, types, source);
        }
        setup = types.open(views == null ? scene : views.observed(scene));
        boolean runs = setup.isGuest() && (start == null || types.guest().isTrusted());
        if (runs && !types.guest().isTrusted()) {
            throw new ReplayException(source + ":1: scene: found a referee of its own, which is a program that the "
                + "replay names and is not run unless that is asked for",
                List.of(new Remedied.Remedy("run-referee", "runs it again")));
        }
        if (runs) {
            checkFiles(header, (GuestSetup) setup, source);
        }
        if (!header.game().equals(setup.scene().gameId())) {
            throw new ReplayException(source + ":1: game: found \""
                + TextFormat.beginning(header.game(), SHOWN) + "\", expected \""
                + setup.scene().gameId() + "\" as in the scene");
        }
        checkLaw(header.law(), source);
        if (setup instanceof GuestSetup guest && !runs) {
            recorded = source;
            game = guest.recorded(header.seed(), () -> outcome);
            said("start", 1, () -> game.isAsked(0));
        } else {
            recorded = null;
            game = setup.create(header.seed());
        }
        codec = setup.codec(game);
        noFaults = new String[game.players()];
        if (game.players() != header.names().size()) {
            throw new ReplayException(source + ":1: players: found " + header.names().size() + ", expected "
                + game.players() + " as in the scene");
        }
    }

    /** Refuses a game of another jar than the one that is here: it need not have the same rules. */
    private static void checkJar(ReplayHeader header, GameTypes types, String source) {
        GameType type = types.of(header.game()).orElse(null);
        String installed = type == null ? null : JarFolder.digestOf(type);
        if (!Objects.equals(header.jar(), installed) && (type != null || header.jar() != null)) {
            throw new ReplayException(source + ":1: jar: found " + (header.jar() == null ? "none"
                : TextFormat.beginning(header.jar(), SHOWN + 20)) + ", expected " + (type == null
                ? "that of a game that is installed: put its jar into the folder of games" : installed == null
                ? "none: the game comes with the program" : installed + ", which is installed"));
        }
    }

    /** Refuses to run a referee whose files are missing, or are others than those that were recorded. */
    private static void checkFiles(ReplayHeader header, GuestSetup setup, String source) {
        setup.check();
        String here = JarFolder.digestOf(setup);
        if (Objects.equals(header.jar(), here)) {
            return;
        }
        String absent = setup.words().stream().filter(Resimulation::isAbsentFile).collect(Collectors.joining(", "));
        String recorded = Objects.requireNonNullElse(header.jar(), "none");
        throw new ReplayException(source + ":1: jar: found " + (here == null && !absent.isEmpty()
            ? "no file " + absent + ", expected the files of " + recorded
            : recorded + ", expected " + here + ", which is that of the referee's files here"
                + (absent.isEmpty() ? "" : "; no file is " + absent)));
    }

    /** True for a word of a command that looks like a path, and no file is there. */
    private static boolean isAbsentFile(String word) {
        try {
            return !word.startsWith("-") && word.matches(".*[/\\\\.].*") && !Files.exists(Path.of(word));
        } catch (InvalidPathException noPath) {
            return false;
        }
    }

    private void checkLaw(int recorded, String source) {
        int current = setup.plan().lawVersion();
        String rung = setup.scene().accuracy().text();
        if (recorded < current) {
            throw new OlderLawException(source, rung, recorded, current);
        }
        if (recorded > current) {
            throw new ReplayException(source + ":1: law: found " + recorded + ", expected at most " + current + " on "
                + rung + ": a newer version of Steward wrote this replay");
        }
    }

    /** A match in a scene that is open already, from its seed. */
    public Resimulation(GameSetup setup, long seed) {
        this.setup = setup;
        recorded = null;
        game = setup.create(seed);
        codec = setup.codec(game);
        noFaults = new String[game.players()];
    }

    /** The scene of the header, opened. */
    public GameSetup setup() {
        return setup;
    }

    /** The game as it stands after the turns played again. */
    public Game game() {
        return game;
    }

    public GameJson codec() {
        return codec;
    }

    /** Plays one recorded turn. @return {@code null}, or the difference because of which it cannot be played */
    public ReplayDifference play(RecordedTurn turn) {
        ReplayDifference difference = prepare(turn);
        if (difference == null) {
            said("outcome", turn.number() + 1, game::play);
        }
        return difference;
    }

    /** Runs what listens to a referee, and refuses what it says with its place if it is recorded. */
    private void said(String field, int line, Runnable listen) {
        try {
            listen.run();
        } catch (UncheckedIOException fault) {
            throw recorded == null ? fault : new ReplayException(recorded + ":" + line + ": " + field + ": "
                + fault.getMessage());
        }
    }

    /**
     * Prepares as {@link #prepare} does, for a turn of a match that is not over, in which no player failed and whose
     * commands are written as games usually write them.
     *
     * @param json where the array of commands begins at {@code from} and ends before {@code to}
     * @return the place behind the commands; or -1 if they have to be read by {@link #prepare}
     */
    public int preparePlain(byte[] json, int from, int to) {
        int at = from;
        for (int player = 0; player < game.players(); player++) {
            if (at >= to || json[at] != (player == 0 ? '[' : ',')) {
                return -1;
            }
            at++;
            at = game.isAsked(player) ? codec.readPlainCommand(json, at, to, player) : behindNull(json, at, to);
            if (at < 0) {
                return -1;
            }
        }
        return at < to && json[at] == ']' ? at + 1 : -1;
    }

    private static int behindNull(byte[] json, int from, int to) {
        int behind = from + NULL.length;
        return behind <= to && Arrays.equals(json, from, behind, NULL, 0, NULL.length) ? behind : -1;
    }

    /** Everything of a turn except playing it: commands are read, and players that failed are out. */
    public ReplayDifference prepare(RecordedTurn turn) {
        int expected = game.turn() + 1;
        if (game.isOver()) {
            return new ReplayDifference(turn.number(), "turn", Integer.toString(turn.number()),
                "the match is over: " + game.ending());
        }
        if (turn.number() != expected) {
            return new ReplayDifference(expected, "turn", Integer.toString(turn.number()), Integer.toString(expected));
        }
        ReplayDifference wrong = readCommands(turn);
        if (wrong != null) {
            return wrong;
        }
        for (int player = 0; player < game.players(); player++) {
            if (turn.faults()[player] != null) {
                game.eliminate(player, turn.faults()[player]);
            }
        }
        outcome = turn.outcome();
        return null;
    }

    /** Reads the command of one player of a recorded turn. @return what is wrong with it and where, or {@code null} */
    public String readCommand(RecordedTurn turn, int player) {
        try (JsonParser in = turn.command(player)) {
            String wrong = in == null ? "found none, expected a command" : codec.readCommand(in, player);
            return wrong == null ? null : turn.where() + ": commands[" + player + "]: " + wrong;
        } catch (JacksonException problem) {
            return turn.where() + ": commands: " + JsonProblem.message(problem);
        }
    }

    /** Reads the commands anew if anything is wrong with them: the error has its place in a parser of their own. */
    private ReplayDifference readCommands(RecordedTurn turn) {
        byte[] json = turn.commands();
        if (readCommands(json, 0, json.length, turn.faults()) >= 0) {
            return null;
        }
        try (JsonParser in = RecordedTurn.parser(json)) {
            in.nextToken();
            return readEach(in, turn.number(), turn.faults());
        } catch (JacksonException problem) {
            return new ReplayDifference(turn.number(), "commands", JsonProblem.message(problem), "JSON");
        }
    }

    /**
     * Reads the commands of a turn in which no player failed.
     *
     * @return how many bytes there are behind them; negative if there is anything wrong or unusual about them
     */
    int readCommands(byte[] json, int from, int to) {
        return readCommands(json, from, to, noFaults);
    }

    private int readCommands(byte[] json, int from, int to, String[] faults) {
        int behind = Arrays.equals(faults, noFaults) ? preparePlain(json, from, to) : -1;
        if (behind >= 0) {
            return to - behind;
        }
        if (!LineParser.canRead(json, from, to)) {
            return -1;
        }
        try {
            JsonParser in = lines.begin(json, from, to);
            if (in.nextToken() == JsonToken.START_ARRAY && readEach(in, 0, faults) == null) {
                return lines.endValue();
            }
            lines.reset();
            return -1;
        } catch (JacksonException problem) {
            lines.reset();
            return -1;
        }
    }

    /** Reads an array of commands, behind its bracket. @return what is wrong, or {@code null} */
    private ReplayDifference readEach(JsonParser in, int turn, String... faults) {
        int player = 0;
        for (JsonToken token = in.nextToken(); token != JsonToken.END_ARRAY; token = in.nextToken()) {
            boolean asked = player < game.players() && game.isAsked(player) && !isSpared(token, player, faults);
            if (!asked && token != JsonToken.VALUE_NULL) {
                return new ReplayDifference(turn, "commands[" + player + "]", "a command", "null");
            }
            String wrong = asked ? readOne(in, token, player, faults[player]) : null;
            if (wrong != null) {
                return new ReplayDifference(turn, "commands[" + player + "]", wrong, "a command");
            }
            player++;
        }
        return player == game.players() ? null
            : new ReplayDifference(turn, "commands", player + " entries", game.players() + " entries");
    }

    /**
     * True if the player has no command because faults of those before it decide the turn. In older replays such a
     * player was asked all the same.
     */
    private boolean isSpared(JsonToken token, int player, String... faults) {
        return token == JsonToken.VALUE_NULL && faults[player] == null && isDecided(player, faults);
    }

    /** True if faults of the players before this one decide the turn, so that this one is not asked. */
    public boolean isDecided(int player, String... faults) {
        int in = 0;
        for (int other = 0; other < game.players(); other++) {
            in += game.isIn(other) && (other >= player || faults[other] == null) ? 1 : 0;
        }
        return in < game.fewestPlayers();
    }

    /** @return what is wrong with the command of a player that was asked, or {@code null} */
    private String readOne(JsonParser in, JsonToken token, int player, String fault) {
        if (fault == null) {
            return token == JsonToken.VALUE_NULL ? "null" : codec.readCommand(in, player);
        }
        codec.clearCommand(player);
        return token == JsonToken.VALUE_NULL ? null : codec.readPartialCommand(in, player);
    }
}
