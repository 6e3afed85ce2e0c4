package steward.machines.check;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import steward.bot.FaultMessages;
import steward.bot.TimeBasis;
import steward.contest.Contest;
import steward.contest.repeat.GameFacts;
import steward.files.JarFolder;
import steward.game.Game;
import steward.json.JsonNumbers;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Turn;
import steward.replay.JsonLine;
import steward.replay.RecordedMatch;
import steward.replay.RecordedTurn;
import steward.replay.ReplayException;
import steward.replay.ReplayHeader;
import steward.replay.ReplayWriter;
import steward.replay.TranscriptDigest;
import steward.replay.verify.ReplayDifference;
import steward.replay.verify.Resimulation;
import steward.scene.json.JsonProblem;
import steward.scene.json.SceneException;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;

/**
 * Check that replays a game from its transcript (see {@link TranscriptWriter}), so that states, events and result
 * follow from the commands alone. The hash of states tells whether the other machine computed the same. Answer times
 * are believed, and so are other outputs of the bots: messages, standard error, data. Thread-safe.
 */
public final class TranscriptCheck {

    private static final byte[] NO_OUTCOME = {'{', '}'};
    private static final Set<String> HEAD = Set.of("bots", "sandbox");
    private static final Set<String> TURN = Set.of("commands", "faults", "messages", "stderr");
    private static final List<String> TIMES = List.of("averageNanos", "worstNanos", "firstNanos", "earlyTurns");

    /** How long a fault may be, in characters: several times the longest line of a bot. It is stored with the game. */
    private static final int LONGEST_FAULT = 1 << 18;

    private final Contest contest;
    private final String scene;

    /** @param contest of the scene; its own bots do not matter */
    public TranscriptCheck(Contest contest) {
        this.contest = contest;
        scene = contest.setup().scene().json();
    }

    /**
     * Plays a transcript.
     *
     * @param source names it in errors
     * @param gzip   the transcript, compressed
     * @throws DisprovedException if it is none of that game, or other states were computed where it was played
     */
    public CheckedGame check(String source, byte[] gzip, ExpectedGame expected)
            throws DisprovedException {
        return playing(source, gzip, expected, null, null).outcome;
    }

    /**
     * The replay of a game, as it would have been written where it was played.
     *
     * @throws DisprovedException as above
     */
    public byte[] replay(String source, byte[] gzip, ExpectedGame expected) throws DisprovedException {
        ByteArrayOutputStream replay = new ByteArrayOutputStream();
        playing(source, gzip, expected, replay, null);
        return replay.toByteArray();
    }

    /**
     * The game in memory, to ask its bots again. Its turns have commands and no outcomes, which have been computed just
     * now.
     *
     * @throws DisprovedException as above
     */
    public RecordedMatch match(String source, byte[] gzip, ExpectedGame expected) throws DisprovedException {
        List<RecordedTurn> turns = new ArrayList<>();
        Playing playing = playing(source, gzip, expected, null, turns);
        return new RecordedMatch(source, playing.header, null, turns, playing.game.ending(), null);
    }

    private Playing playing(String source, byte[] gzip, ExpectedGame expected, ByteArrayOutputStream replay,
                            List<RecordedTurn> turns) throws DisprovedException {
        Resimulation again = new Resimulation(contest.setup(), expected.seed());
        try {
            Playing playing = new Playing(source, GzipText.bytes(gzip), expected, again, replay, turns);
            playing.play();
            return playing;
        } catch (ReplayException | SceneException | ArithmeticException problem) {
            throw new DisprovedException(String.valueOf(problem.getMessage()));
        } catch (JacksonException problem) {
            throw new DisprovedException(source + ": found no JSON: " + JsonProblem.message(problem));
        } catch (IOException | UncheckedIOException problem) {
            throw new DisprovedException(source + ": cannot be unpacked: " + problem.getMessage());
        } finally {
            again.game().close();
        }
    }

    /** A game while it is played again. */
    private final class Playing {

        private final String source;
        private final byte[] text;
        private final ExpectedGame expected;
        private final int players = contest.players();
        private final Resimulation again;
        private final Game game;
        private final String[] none = new String[players];
        private final String[] faults = new String[players];
        private final int[] asked = new int[players];
        private final StatesHash states;
        private final TranscriptDigest digest = new TranscriptDigest();
        private final MatchListener listener;
        private final ReplayHeader header;
        private final List<RecordedTurn> turns;
        private final JsonLine last;
        private CheckedGame outcome;
        private JsonParser nanos;
        private long spent;
        private int from;
        private int number = 1;

        /** @param replay and {@code turns} are filled, unless {@code null} */
        Playing(String source, byte[] text, ExpectedGame expected, Resimulation again, ByteArrayOutputStream replay,
                List<RecordedTurn> turns) {
            this.source = source;
            this.text = text;
            this.expected = expected;
            this.again = again;
            game = again.game();
            states = new StatesHash(game);
            this.turns = turns;
            int end = text.length - 1;
            int begin = end - 1;
            while (begin >= 0 && text[begin] != '\n') {
                begin--;
            }
            if (end < 0 || text[end] != '\n' || begin < 0) {
                throw new ReplayException(source + ": found " + text.length + " bytes, expected a whole game");
            }
            last = new JsonLine(source + ", its end", Arrays.copyOfRange(text, begin + 1, end));
            JsonLine head = new JsonLine(source + ":1", line());
            only(head, HEAD);
            String[] bots = head.texts("bots", players);
            if (Arrays.asList(bots).contains(null)) {
                throw new ReplayException(source + ":1: found no bots, expected " + players);
            }
            header = new ReplayHeader(contest.setup().scene().gameId(), scene,
                expected.seed(), expected.names(), List.of(bots), expected.protocols(), contest.timeFactor(),
                contest.setup().plan().lawVersion(), null, head.text("sandbox"),
                JarFolder.digestOf(contest.setup()), expected.limits());
            listener = replay == null ? null : new ReplayWriter(replay, header);
        }

        /** The bytes up to the next end of a line. */
        private byte[] line() {
            int end = from;
            while (text[end] != '\n') {
                end++;
            }
            byte[] line = Arrays.copyOfRange(text, from, end);
            from = end + 1;
            return line;
        }

        private void only(JsonLine line, Set<String> names) {
            for (String name : line.names()) {
                if (!names.contains(name)) {
                    throw new ReplayException(line.where() + ": found the field \"" + name
                        + "\", expected no such field");
                }
            }
        }

        void play() throws DisprovedException {
            byte[] times = last.array(TranscriptWriter.NANOS);
            nanos = RecordedTurn.parser(times);
            nanos.nextToken();
            if (listener != null) {
                listener.start(game, again.codec());
            }
            while (!game.isOver()) {
                number++;
                int behind = again.preparePlain(text, from, text.length);
                if (behind >= 0 && text[behind] == '\n') {
                    plainTurn(behind);
                    continue;
                }
                byte[] line = from < text.length ? line() : new byte[0];
                if (from == text.length) {
                    throw DisprovedException.computed(source + ": ends after turn " + game.turn()
                        + ", expected the rest of the game");
                }
                turn(line);
            }
            if (from == text.length) {
                throw new DisprovedException(source + ": found no end, expected one");
            }
            line();
            if (from < text.length) {
                throw DisprovedException.computed(source + ": goes on after turn " + game.turn()
                    + ", expected the end of the game");
            }
            outcome = end();
        }

        /** A turn of nothing but commands, which have been read. The last line is an object and never such a turn. */
        private void plainTurn(int behind) {
            Turn turn = Turn.of(game.turn() + 1, players);
            for (int player = 0; player < players; player++) {
                if (game.isAsked(player)) {
                    asked[player]++;
                    turn.answer(player, null, null, nanos());
                }
            }
            if (turns != null) {
                turns.add(new RecordedTurn(game.turn() + 1, Arrays.copyOfRange(text, from, behind), none, null,
                    NO_OUTCOME, none, none, null, source));
            }
            from = behind + 1;
            play(turn);
        }

        private void play(Turn turn) {
            digest.commands(turn, again.codec());
            if (listener != null) {
                listener.commands(turn);
            }
            game.play();
            digest.played(game);
            if (listener != null) {
                listener.played(turn);
            }
            states.played();
        }

        private void turn(byte[] line) throws DisprovedException {
            String[] texts = none;
            String[] messages = none;
            String[] stderr = none;
            byte[] commands = line;
            if (line.length == 0 || line[0] != '[') {
                JsonLine told = new JsonLine(source + ":" + number, line);
                only(told, TURN);
                texts = told.texts("faults", players);
                messages = told.texts("messages", players);
                stderr = told.texts("stderr", players);
                commands = told.array("commands");
            }
            Turn turn = Turn.of(game.turn() + 1, players);
            RecordedTurn read = new RecordedTurn(turn.number(), commands, texts, null, NO_OUTCOME, messages, stderr,
                null, source);
            for (int player = 0; player < players; player++) {
                if (game.isAsked(player) && read.asked(player)) {
                    asked[player]++;
                    long time = nanos();
                    if (texts[player] == null) {
                        turn.answer(player, messages[player], stderr[player], time);
                    } else if (texts[player].length() > LONGEST_FAULT) {
                        throw new DisprovedException(source + ":" + number + ": faults[" + player + "]: found "
                            + texts[player].length() + " characters, expected at most " + LONGEST_FAULT);
                    } else {
                        checkLate(player, texts[player], time);
                        turn.fail(player, texts[player], stderr[player], time);
                        faults[player] = turn.fault(player);
                    }
                }
            }
            if (turns != null) {
                turns.add(read);
            }
            ReplayDifference wrong = again.prepare(read);
            if (wrong != null) {
                throw DisprovedException.computed(source + ": cannot be played again: " + wrong);
            }
            play(turn);
        }

        /** Refuses a missed deadline that the worker's own measurement does not allow. */
        private void checkLate(int player, String fault, long time) throws DisprovedException {
            long limit = contest.time().limit(expected.limits().get(player), game.limitMs(player), asked[player] - 1);
            if (FaultMessages.isTime(fault) && contest.time().basis() == TimeBasis.WALL && time < limit) {
                throw new DisprovedException(source + ":" + number + ": faults[" + player + "]: found '"
                    + fault.replaceFirst("(?s): .*", "") + "' after " + time / 1000
                    + " us, expected a late answer only after " + limit / 1000 + " us");
            }
        }

        private long nanos() {
            JsonToken token = nanos.nextToken();
            if (token != JsonToken.VALUE_NUMBER_INT || nanos.getLongValue() < 0) {
                throw wrongTimes(TranscriptWriter.NANOS);
            }
            spent = Math.addExact(spent, nanos.getLongValue());
            return nanos.getLongValue();
        }

        private ReplayException wrongTimes(String name) {
            return new ReplayException(last.where() + ": " + name + ": found something else, expected whole numbers "
                + "from 0, one for each answer or player");
        }

        private CheckedGame end() throws DisprovedException {
            String found = last.text(TranscriptWriter.STATES);
            if (!found.equals(states.hex())) {
                throw DisprovedException.computed(source + ": differs when it is played again: found states of the "
                    + "hash " + found + ", expected " + states.hex());
            }
            List<long[]> times = new ArrayList<>();
            TIMES.forEach(name -> times.add(numbers(name)));
            times.add(last.has(TranscriptWriter.HELD) ? numbers(TranscriptWriter.HELD) : new long[players]);
            for (int player = 0; player < players; player++) {
                faults[player] = faults[player] != null ? faults[player] : game.expulsion(player);
            }
            List<CheckedGame.Seat> seats = new ArrayList<>();
            List<MatchResult.PlayerResult> results = new ArrayList<>();
            for (int player = 0; player < players; player++) {
                seats.add(new CheckedGame.Seat(game.ranks()[player], game.scores()[player], faults[player],
                    asked[player], times.get(0)[player], times.get(1)[player], times.get(2)[player]));
                results.add(new MatchResult.PlayerResult(expected.names().get(player), game.ranks()[player],
                    game.scores()[player], faults[player], game.eliminationReason(player), asked[player],
                    times.get(0)[player], times.get(1)[player], times.get(2)[player], (int) times.get(3)[player],
                    data("data" + player), (int) times.get(4)[player]));
            }
            MatchResult result = new MatchResult(game.turn(), game.ending(), results, data("data"));
            if (listener != null) {
                listener.end(result);
            }
            return new CheckedGame(game.turn(), GameFacts.of(game, digest), seats, spent);
        }

        private long[] numbers(String name) {
            byte[] array = last.array(name);
            long[] numbers = new long[players];
            try (JsonParser in = JsonNumbers.FACTORY.createParser(ObjectReadContext.empty(), array, 0, array.length)) {
                in.nextToken();
                for (int player = 0; player < players; player++) {
                    if (in.nextToken() != JsonToken.VALUE_NUMBER_INT || in.getLongValue() < 0) {
                        throw wrongTimes(name);
                    }
                    numbers[player] = in.getLongValue();
                }
                if (in.nextToken() != JsonToken.END_ARRAY) {
                    throw wrongTimes(name);
                }
            }
            return numbers;
        }

        private Map<String, String> data(String name) {
            Map<String, String> data = new HashMap<>();
            if (last.has(name)) {
                JsonLine told = new JsonLine(last.where() + ": " + name, last.object(name));
                told.names().forEach(key -> data.put(key, told.text(key)));
            }
            return data;
        }
    }
}
