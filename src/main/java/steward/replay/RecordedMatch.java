package steward.replay;

import java.util.ArrayList;
import java.util.List;

/**
 * A replay read completely into memory.
 *
 * @param source  the name of the file, for errors
 * @param header  what it says of the match
 * @param start   state and hash before the first turn, as JSON; {@code null} of a match in memory
 * @param turns   in order, from the first
 * @param ending  how the match ended, or {@code null} if there is no result
 * @param warning where the file was cut off, or {@code null}
 */
public record RecordedMatch(String source, ReplayHeader header, byte[] start, List<RecordedTurn> turns,
                            String ending, String warning) {

    public RecordedMatch {
        turns = List.copyOf(turns);
    }

    /**
     * Reads a replay.
     *
     * @param replay just opened; not closed
     * @throws ReplayException if it is damaged before its end, or cut off within its header
     */
    public static RecordedMatch read(ReplayReader replay) {
        if (replay.header() == null) {
            throw new ReplayException(replay.warning());
        }
        List<RecordedTurn> turns = new ArrayList<>();
        for (RecordedTurn turn = replay.next(); turn != null; turn = replay.next()) {
            turns.add(turn);
        }
        return new RecordedMatch(replay.source(), replay.header(), replay.start(), turns, replay.ending(),
            replay.warning());
    }

    /** The last turn that a player was asked in, counted from 1; 0 if it never was. */
    public int lastAsked(int player) {
        for (int k = turns.size() - 1; k >= 0; k--) {
            RecordedTurn turn = turns.get(k);
            if (turn.faults()[player] != null || turn.hasCommand(player)) {
                return turn.number();
            }
        }
        return 0;
    }
}
