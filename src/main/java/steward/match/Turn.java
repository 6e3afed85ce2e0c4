package steward.match;

import steward.Internal;
import steward.bot.Answer;
import steward.bot.Burner;
import steward.bot.TimeSpent;

/** Reusable buffer for the players' actions in one turn. Arrays are indexed by player. */
public final class Turn {

    private int number;
    final boolean[] asked;
    final boolean[] answered;
    final Answer[] answers;
    final String[] faults;
    final String[] messages;
    final String[] stderr;
    final long[] nanos;
    final TimeSpent[] timeSpent;
    final Burner[] burners;

    Turn(int players) {
        asked = new boolean[players];
        answered = new boolean[players];
        answers = new Answer[players];
        faults = new String[players];
        messages = new String[players];
        stderr = new String[players];
        nanos = new long[players];
        timeSpent = new TimeSpent[players];
        burners = new Burner[players];
    }

    /** A turn that no referee asks for, such as a recorded one; no player has been asked yet. */
    public static Turn of(int number, int players) {
        Turn turn = new Turn(players);
        turn.begin(number);
        return turn;
    }

    /** Records a valid command; message and stderr may be {@code null}. */
    public void answer(int player, String message, String error, long answerNanos) {
        asked[player] = true;
        answered[player] = true;
        messages[player] = SafeText.wellFormed(message);
        stderr[player] = SafeText.wellFormed(error);
        nanos[player] = answerNanos;
    }

    /** Records a failure; stderr may be {@code null}. */
    public void fail(int player, String fault, String error, long answerNanos) {
        asked[player] = true;
        faults[player] = SafeText.wellFormed(fault);
        stderr[player] = SafeText.wellFormed(error);
        nanos[player] = answerNanos;
    }

    /** Records where the time of a late answer went. */
    public void late(int player, TimeSpent spent) {
        timeSpent[player] = spent;
    }

    void begin(int turnNumber) {
        number = turnNumber;
        for (int player = 0; player < asked.length; player++) {
            asked[player] = false;
            answered[player] = false;
            answers[player] = null;
            faults[player] = null;
            messages[player] = null;
            stderr[player] = null;
            nanos[player] = 0;
            timeSpent[player] = null;
            burners[player] = null;
        }
    }

    /** Counted from 1. */
    public int number() {
        return number;
    }

    /** Returns the number of players, including those who are out. */
    public int players() {
        return asked.length;
    }

    /** True if the player was asked: players who are out are not. */
    public boolean asked(int player) {
        return asked[player];
    }

    /** True if the player gave a valid command. */
    public boolean answered(int player) {
        return answered[player];
    }

    /**
     * The player's answer as it came, its lines separated by {@code '\n'}; with a fault, what had been received by
     * then. Each call creates a new string; {@code null} if the player was not asked.
     */
    public String answer(int player) {
        return answers[player] == null ? null : answers[player].text();
    }

    /** Returns how the player failed in this turn, or {@code null}. */
    public String fault(int player) {
        return faults[player];
    }

    /** Returns where the time of a late answer went; {@code null} if it was not late, or the player is no process. */
    public TimeSpent timeSpent(int player) {
        return timeSpent[player];
    }

    /** The bot that burned while this one was late and was not yet held; {@code null} if none did. */
    @Internal
    public Burner burner(int player) {
        return burners[player];
    }

    /** The message that came with the answer, or {@code null}. */
    public String message(int player) {
        return messages[player];
    }

    /** Returns the player's stderr up to its answer, bounded, or {@code null}. */
    public String stderr(int player) {
        return stderr[player];
    }

    /** Returns how long the player took, in nanoseconds. */
    public long nanos(int player) {
        return nanos[player];
    }
}
