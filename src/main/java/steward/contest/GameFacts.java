package steward.contest;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import steward.game.Game;
import steward.game.GameTypes;
import steward.replay.RecordedTurn;
import steward.replay.ReplayException;
import steward.replay.ReplayReader;
import steward.replay.TranscriptDigest;
import steward.replay.verify.Resimulation;

/**
 * Facts of one game that its result does not contain.
 *
 * @param transcript digest of all commands and states, see {@link TranscriptDigest}; 0 if it is not known
 * @param values     the game's own values by player, see {@link Game#ownValues}; empty if they are not known
 */
public record GameFacts(long transcript, List<SortedMap<String, Double>> values) {

    public static final GameFacts UNKNOWN = new GameFacts(0, List.of());

    public GameFacts {
        values = List.copyOf(values);
    }

    /** Own values of a player; empty if they are not known. */
    public SortedMap<String, Double> values(int player) {
        return player < values.size() ? values.get(player) : Collections.emptySortedMap();
    }

    public static GameFacts of(Game game, TranscriptDigest digest) {
        List<SortedMap<String, Double>> values = new ArrayList<>();
        for (int player = 0; player < game.players(); player++) {
            SortedMap<String, Double> own = new TreeMap<>();
            for (Map.Entry<String, double[]> value : game.ownValues().entrySet()) {
                own.put(value.getKey(), value.getValue()[player]);
            }
            values.add(own);
        }
        return new GameFacts(digest.value(), values);
    }

    /**
     * Plays a recorded game again.
     *
     * @param replay just opened
     * @throws ReplayException if it is cut off, or cannot be played again
     */
    public static GameFacts of(ReplayReader replay, GameTypes types) {
        if (replay.header() == null || replay.imported()) {
            throw new ReplayException(replay.source() + ": found no replay of ours, expected one");
        }
        Resimulation again = new Resimulation(replay.header(), null, types, replay.source());
        Game game = again.game();
        TranscriptDigest digest = new TranscriptDigest();
        for (RecordedTurn turn = replay.next(); turn != null; turn = replay.next()) {
            if (again.prepare(turn) != null) {
                throw new ReplayException(turn.where() + ": found a turn that cannot be played");
            }
            digest.commands(game.players(), turn::hasCommand, player -> false, again.codec());
            game.play();
            digest.played(game);
        }
        if (!game.isOver()) {
            throw new ReplayException(replay.source() + ": found a replay that is cut off, expected a whole one");
        }
        return of(game, digest);
    }
}
