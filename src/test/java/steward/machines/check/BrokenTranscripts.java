package steward.machines.check;

import java.io.IOException;
import steward.game.Pilot;

/** Messages that a worker may send in place of a game: they have to be refused with a message, or to be a game. */
public final class BrokenTranscripts {

    private static final long SEED = 11;

    private final PlayedGame game = PlayedGame.of(PlayedGame.piloted("duel", Pilot.Aim.MINGLE), SEED);
    private final byte[] sent;

    /** Plays the game that is broken. */
    public BrokenTranscripts() throws InterruptedException, IOException {
        sent = GzipText.bytes(game.transcript());
    }

    /** The sound one; not compressed. */
    public byte[] sent() {
        return sent;
    }

    /**
     * True if a broken one is refused.
     *
     * @param bare whether it is not compressed, either
     * @throws AssertionError if it is refused in words of Java
     */
    public boolean check(byte[] broken, boolean bare) {
        try {
            new TranscriptCheck(game.contest()).replay("a game", bare ? broken : GzipText.compressed(broken),
                game.expected());
            return false;
        } catch (DisprovedException problem) {
            String message = problem.getMessage();
            if (!message.startsWith("a game") || message.contains("Exception")) {
                throw new AssertionError("a refusal that is not for people: " + message);
            }
            return true;
        }
    }
}
