package steward.replay;

/**
 * One turn as it was recorded.
 *
 * @param number    counted from 1
 * @param commands  the array of commands, one per player or null, as JSON
 * @param faults    per player why it failed in this turn, or null
 * @param inputHash a hash of commands and faults
 * @param outcome   impacts, paths, events, state and hash, as JSON
 * @param messages  per player, or null
 * @param stderr    per player what it wrote, or null
 * @param times     the measured part as JSON, or null if absent
 * @param where     file and line, for errors
 */
public record RecordedTurn(int number, byte[] commands, String[] faults, String inputHash, byte[] outcome,
                           String[] messages, String[] stderr, byte[] times, String where) {

    static RecordedTurn of(JsonLine line, int players) {
        return new RecordedTurn(line.integer("turn"), line.array("commands"), line.texts("faults", players),
            line.text("inputHash"), line.object("outcome"), line.texts("messages", players),
            line.texts("stderr", players), line.has("times") ? line.object("times") : null, line.where());
    }
}
