package steward.machines.check;

import java.util.List;
import steward.match.Protocol;

/**
 * A game that has to have been played.
 *
 * @param names     that the players go by
 * @param protocols that they speak
 */
public record ExpectedGame(long seed, List<String> names, List<Protocol> protocols) {

    public ExpectedGame {
        names = List.copyOf(names);
        protocols = List.copyOf(protocols);
    }
}
