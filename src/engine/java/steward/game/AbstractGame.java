package steward.game;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import steward.numerics.StateHash;
import steward.physics.TurnLog;

/**
 * Base class of games with their common state. It has the turn, which players are out since when and why, how the game
 * ended, and the impacts and events of the last turn. A game adds its rules, {@link #playTurn}, and its state.
 */
public abstract class AbstractGame implements Game {

    /** The turn of elimination of a player who is in. */
    protected static final int NOT_OUT = Integer.MAX_VALUE;

    /** Impacts and knots of the turn that is played. */
    protected final TurnLog log = new TurnLog(TurnLog.RECORDED);
    /** Events of the turn that is played. */
    protected final TurnEvents events = new TurnEvents();
    /** For {@link #hash}, to be reset first. */
    protected final StateHash hash = new StateHash();

    private final String[] outReason;
    private final int[] outTurn;
    private int turn;
    private String ending;

    /** Order of players while the game goes on. */
    @FunctionalInterface
    public interface Order {

        boolean isAhead(int one, int other);
    }

    /** A game before its first turn. */
    protected AbstractGame(int players) {
        outReason = new String[players];
        outTurn = new int[players];
        Arrays.fill(outTurn, NOT_OUT);
    }

    /** A copy of a game between two turns, without the impacts and events of its last turn. */
    protected AbstractGame(AbstractGame other) {
        outReason = other.outReason.clone();
        outTurn = other.outTurn.clone();
        turn = other.turn;
        ending = other.ending;
    }

    /** One own value by its name, as {@link #ownValues} tells it. */
    protected final SortedMap<String, double[]> ownValue(String name, IntToDoubleFunction ofPlayer) {
        return new TreeMap<>(Map.of(name, IntStream.range(0, players()).mapToDouble(ofPlayer).toArray()));
    }

    /** The rules of one turn; turn, log and events are ready for it. */
    protected abstract void playTurn();

    @Override
    public final void play() {
        if (isOver()) {
            throw new IllegalStateException("the game is over: " + ending);
        }
        turn++;
        log.clear();
        events.clear();
        playTurn();
    }

    /** Ends the game with this turn. @param how one sentence without its full stop */
    protected final void end(String how) {
        ending = how;
    }

    /** By the rules: eliminates a player who is in as of this turn. */
    protected final void putOut(int player, String reason) {
        putOut(player, reason, turn);
    }

    private void putOut(int player, String reason, int when) {
        if (isIn(player)) {
            outTurn[player] = when;
            outReason[player] = reason;
        }
    }

    @Override
    public final void eliminate(int player, String reason) {
        putOut(player, reason, turn + 1);
    }

    @Override
    public final String eliminationReason(int player) {
        return outReason[player];
    }

    /** The turn in which a player went out, {@link #NOT_OUT} while in. */
    public final int outTurn(int player) {
        return outTurn[player];
    }

    @Override
    public final int players() {
        return outReason.length;
    }

    @Override
    public final int turn() {
        return turn;
    }

    @Override
    public final boolean isOver() {
        return ending != null;
    }

    @Override
    public final String ending() {
        return ending;
    }

    @Override
    public TurnLog log() {
        return log;
    }

    @Override
    public final List<TurnEvent> events() {
        return events.list();
    }

    /** Per player how many others are ahead. */
    protected final int[] ranks(Order order) {
        int[] ranks = new int[players()];
        for (int player = 0; player < ranks.length; player++) {
            for (int other = 0; other < ranks.length; other++) {
                ranks[player] += order.isAhead(other, player) ? 1 : 0;
            }
        }
        return ranks;
    }
}
