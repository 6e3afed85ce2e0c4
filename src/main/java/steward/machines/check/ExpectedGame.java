package steward.machines.check;

import java.util.List;
import java.util.Map;
import steward.match.Protocol;
import steward.scene.Time;

/**
 * A game that a worker was told to play, for comparison with its report.
 *
 * @param names     that the players go by
 * @param protocols that they speak
 * @param limits    of players that have their own
 */
public record ExpectedGame(long seed, List<String> names, List<Protocol> protocols, Map<Integer, Time> limits) {

    public ExpectedGame {
        limits = Map.copyOf(limits);
        names = List.copyOf(names);
        protocols = List.copyOf(protocols);
    }
}
