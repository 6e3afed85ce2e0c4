package steward.codingame;

import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.LongSupplier;
import java.util.stream.IntStream;
import steward.game.FrameCodec;
import steward.game.Game;
import steward.game.GameSetup;
import steward.match.MatchListener;
import steward.match.MatchResult.PlayerResult;
import steward.match.Protocol;
import steward.match.Referee;
import steward.match.Seat;
import steward.match.TimeControl;
import steward.text.TextFormat;

/**
 * A referee for tools that start the bots themselves and pass lines on, both ways on the standard streams:
 * <pre>
 * tool  ###Seed N            if it wants a certain game
 * tool  ###Start P           P players
 *       ###Input i           and lines for player i, up to the next command
 *       ###Output i n
 * tool  n lines that player i wrote
 *       ###End 0 1           the best first, players that tie in one word, as in ###End 01
 * </pre>
 * When the input ends, the player that was being asked has failed and the game is over.
 */
public final class OldReferee {

    private static final String SEED = "###Seed ";
    private static final String START = "###Start ";

    private final GameSetup setup;
    private final OldRefereeLines lines;
    private final Set<Integer> failed = new TreeSet<>();
    private boolean brokenOff;

    /** The streams stay open. */
    public OldReferee(GameSetup setup, InputStream in, OutputStream out) {
        this.setup = setup;
        lines = new OldRefereeLines(in, out);
    }

    /**
     * Plays one game.
     *
     * @param seed for a tool that names none
     * @throws IllegalArgumentException if the tool's first lines are wrong, or the game has no text protocol
     */
    public void play(TimeControl time, LongSupplier seed) throws InterruptedException {
        Long wanted = readStart();
        List<Seat> seats = IntStream.range(0, setup.scene().players()).mapToObj(player ->
            new Seat(new OldRefereePlayer(this, lines, player), Protocol.CODINGAME)).toList();
        Standing standing = new Standing();
        Referee referee = Referee.of(setup, wanted == null ? seed.getAsLong() : wanted, seats, time, standing);
        try {
            end(referee.play().players().stream().mapToInt(PlayerResult::rank).toArray());
        } catch (InputEnded ended) {
            end(standing.brokenOff());
        }
    }

    /** @return the seed, or {@code null} */
    private Long readStart() {
        Long seed = null;
        for (String line = line(); ; line = line()) {
            if (line.startsWith(SEED)) {
                seed = number(line, SEED, "a whole number of 64 bits");
            } else if (line.startsWith(START)) {
                int players = setup.scene().players();
                if (number(line, START, "a number of players") != players) {
                    throw wrong("found \"" + line + "\", expected " + players + ": the scene \""
                        + setup.scene().name() + "\" is for " + players + " players");
                }
                return seed;
            } else {
                throw wrong("found \"" + line + "\", expected ###Seed N or ###Start P");
            }
        }
    }

    private String line() {
        byte[] line = lines.read();
        if (line == null) {
            throw new IllegalArgumentException("the input ends after " + lines.number()
                + " lines, expected ###Start P");
        }
        return TextFormat.beginning(new String(line, StandardCharsets.UTF_8).strip(), 100);
    }

    private long number(String line, String command, String expected) {
        try {
            return Long.parseLong(line.substring(command.length()).strip());
        } catch (NumberFormatException problem) {
            throw wrong("found \"" + line + "\", expected " + expected + " after " + command.strip());
        }
    }

    private IllegalArgumentException wrong(String problem) {
        return new IllegalArgumentException("input line " + lines.number() + ": " + problem);
    }

    private void end(int[] ranks) {
        StringBuilder text = new StringBuilder("###End");
        for (int rank = 0; rank < ranks.length; rank++) {
            boolean first = true;
            for (int player = 0; player < ranks.length; player++) {
                if (ranks[player] == rank) {
                    text.append(first ? " " : "").append(player);
                    first = false;
                }
            }
        }
        lines.write(text.append('\n').toString());
        lines.flush();
    }

    void failed(int player) {
        if (!brokenOff) {
            failed.add(player);
        }
    }

    /** The input has ended, so no player can be asked: one that is closed from now on has not failed. */
    InputEnded breakOff() {
        brokenOff = true;
        return new InputEnded();
    }

    /** Another player should have been asked, but the input had ended already. */
    static final class InputEnded extends RuntimeException {

        private InputEnded() {
            super("the input ended", null, false, false);
        }
    }

    /** Knows the ranks when a game breaks off. */
    private final class Standing implements MatchListener {

        private Game game;

        @Override
        public void start(Game started, FrameCodec codec) {
            game = started;
        }

        /** The ranks after the players that failed in the turn that could not be played are out. */
        int[] brokenOff() {
            failed.forEach(player -> game.eliminate(player, "failed"));
            return game.ranks();
        }
    }
}
