package steward.replay;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import steward.Internal;
import steward.match.Protocol;
import steward.scene.Time;

/**
 * Header of a replay: the facts of its match that are known before the first turn, such as scene, seed and bots.
 *
 * @param game       id of the game
 * @param scene      the scene as used, one line of JSON
 * @param seed       the seed of all random draws of the match
 * @param names      of the players, in order
 * @param bots       their commands, in order
 * @param protocols  the languages they speak, in order
 * @param timeFactor by which the scene's limits were multiplied; {@code POSITIVE_INFINITY} for no deadlines
 * @param law        the version of the law of the scene's rung
 * @param signer     the public key of the signer, as {@link steward.replay.sign.SignerKey#text}; or
 *                   {@code null}
 * @param sandbox    at which level bots were kept apart, or {@code null} where that is not known; it is written with
 *                   what was measured, is neither hashed nor signed, and is not read
 * @param jar        digest of the jar that the game is from, or {@code null} for a game of the program
 * @param limits     time limits of players that had their own, before the factor; the others had the scene's
 */
public record ReplayHeader(String game, String scene, long seed, List<String> names, List<String> bots,
                           List<Protocol> protocols, double timeFactor, int law, String signer, String sandbox,
                           String jar, Map<Integer, Time> limits) {

    public static final int FORMAT = 3;
    /** Word of the header for sines and cosines that are the doubles nearest to the true values. */
    static final String ANGLES = "correctly-rounded";
    /** The value of {@code type} in the first line. */
    public static final String TYPE = "steward-replay";
    /** How every replay begins, up to the number of its format. */
    public static final String SIGNATURE = "{\"type\":\"" + TYPE + "\",\"format\":";

    /** Copies the lists. */
    @Internal
    public ReplayHeader {
        names = List.copyOf(names);
        bots = List.copyOf(bots);
        protocols = List.copyOf(protocols);
        limits = Map.copyOf(limits);
    }

    /** A match of which it is not known how bots were kept apart. */
    @Internal
    public ReplayHeader(String game, String scene, long seed, List<String> names, List<String> bots,
                        List<Protocol> protocols, double timeFactor, int law, String signer) {
        this(game, scene, seed, names, bots, protocols, timeFactor, law, signer, null, null, Map.of());
    }

    /** An unsigned match by law 1. */
    public ReplayHeader(String game, String scene, long seed, List<String> names, List<String> bots,
                        List<Protocol> protocols, double timeFactor) {
        this(game, scene, seed, names, bots, protocols, timeFactor, 1, null, null, null, Map.of());
    }

    /** Returns this header, signed; or unsigned for {@code null}. */
    ReplayHeader signedBy(String key) {
        return new ReplayHeader(game, scene, seed, names, bots, protocols, timeFactor, law, key, sandbox, jar, limits);
    }

    /** Returns this header for a version of the law: that of the scene's plan, where it is not the first. */
    public ReplayHeader ofLaw(int version) {
        return new ReplayHeader(game, scene, seed, names, bots, protocols, timeFactor, version, signer, sandbox, jar,
            limits);
    }

    /** Returns this header for a game that is from a jar, or from the program for {@code null}. */
    public ReplayHeader ofJar(String digest) {
        return new ReplayHeader(game, scene, seed, names, bots, protocols, timeFactor, law, signer, sandbox, digest,
            limits);
    }

    /** Returns this header for a game in which some players have time limits of their own. */
    @Internal
    public ReplayHeader ofLimits(Map<Integer, Time> own) {
        return new ReplayHeader(game, scene, seed, names, bots, protocols, timeFactor, law, signer, sandbox, jar, own);
    }

    /** A match between players that all use JSON. */
    public ReplayHeader(String game, String scene, long seed, List<String> names, List<String> bots,
                        double timeFactor) {
        this(game, scene, seed, names, bots, Collections.nCopies(names.size(), Protocol.JSON), timeFactor);
    }
}
