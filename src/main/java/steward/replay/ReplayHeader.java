package steward.replay;

import java.util.Collections;
import java.util.List;
import steward.match.Protocol;

/**
 * What a replay says of its match before the first turn.
 *
 * @param game       id of the game
 * @param scene      the scene as used, one line of JSON
 * @param seed       what everything drawn by lot followed from
 * @param names      of the players, in order
 * @param bots       their commands, in order
 * @param protocols  the languages they speak, in order
 * @param timeFactor by which the scene's limits were multiplied; {@code POSITIVE_INFINITY} for no deadlines
 */
public record ReplayHeader(String game, String scene, long seed, List<String> names, List<String> bots,
                           List<Protocol> protocols, double timeFactor) {

    /** The version of the format that is written, and the newest that is read. */
    public static final int FORMAT = 2;
    /** The value of {@code type} in the first line. */
    public static final String TYPE = "steward-replay";
    /** How every replay begins, up to the number of its format. */
    public static final String SIGNATURE = "{\"type\":\"" + TYPE + "\",\"format\":";

    /** Copies the lists. */
    public ReplayHeader {
        names = List.copyOf(names);
        bots = List.copyOf(bots);
        protocols = List.copyOf(protocols);
    }

    /** A match between players who all speak JSON. */
    public ReplayHeader(String game, String scene, long seed, List<String> names, List<String> bots,
                        double timeFactor) {
        this(game, scene, seed, names, bots, Collections.nCopies(names.size(), Protocol.JSON), timeFactor);
    }
}
