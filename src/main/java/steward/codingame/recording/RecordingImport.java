package steward.codingame.recording;

import java.io.OutputStream;
import steward.game.GameTypes;
import steward.game.podrace.RulesEdition;
import steward.match.GuestSetup;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Importer of a game that CodinGame's server has played; makes a replay of ours from its recording. */
@FunctionalInterface
public interface RecordingImport {

    /** How long a recording may be, in bytes: some fifty times what the longest games of the site take. */
    int MOST_BYTES = 1 << 24;

    /**
     * Result of an import.
     *
     * @param turns  how many turns the replay has
     * @param ending how the game ended by our rules, or {@code null} if the recording ends before
     * @param note   on what the recording has and a replay cannot have, or {@code null}
     */
    record Imported(int turns, String ending, String note) {

        Imported(int turns, String ending) {
            this(turns, ending, null);
        }
    }

    /**
     * Writes the replay.
     *
     * @throws DifferentGameException if the server has sent other lines than our rules give
     */
    Imported write(OutputStream out) throws InterruptedException;

    /**
     * Reads a recording: frames of the site's page, or the lines of the only player of a game.
     *
     * @param json   the text
     * @param source its name, for errors
     * @param types  the games that are known
     * @param rules  edition of the rules by which a pod race was played; {@code null} for those of today
     * @throws IllegalArgumentException     if it is no recording of a game that is known; says where
     * @throws steward.scene.json.SceneException if its map is none that can be played on
     */
    static RecordingImport of(String json, String source, GameTypes types, RulesEdition rules) {
        JsonNode read = null;
        try {
            read = JsonMapper.shared().readTree(json);
        } catch (JacksonException problem) {
            // said below, with its place
        }
        if (read == null || !read.has("stdin") || !read.has("stdout")) {
            return ServerGameImport.of(GameRecordingFile.gameResult(json, source), source, types, rules);
        }
        if (rules != null) {
            throw ServerGameImport.otherGame(source);
        }
        return LineRecordingImport.of(read, source, types);
    }

    /**
     * Reads a recording of a game whose referee a scene names.
     *
     * @throws IllegalArgumentException if no game of the scene can be played so; says where
     */
    static RecordingImport ofGuest(String json, String source, GameTypes types, GuestSetup scene) {
        return GuestGameImport.of(GameRecordingFile.gameResult(json, source), source, types, scene);
    }
}
