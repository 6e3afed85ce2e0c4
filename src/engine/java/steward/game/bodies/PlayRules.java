package steward.game.bodies;

import java.util.List;
import steward.physics.Contacts;
import steward.physics.Forces;

/**
 * Rules of play with players: the block {@code play} of a scene.
 *
 * @param maximumTurns  after this many turns the game ends
 * @param restBelow     the game ends when every body of finite mass is slower, in u per turn; 0 for never
 * @param forces        on every body of finite mass
 * @param maximumThrust the longest thrust of a command, an impulse; 0 where there are no players
 * @param contactPoints for each impact of a player's body with one that is not the player's
 * @param zones         in the order of the file
 */
public record PlayRules(int maximumTurns, double restBelow, Forces forces, double maximumThrust, int contactPoints,
                        List<Zone> zones) {

    public PlayRules {
        zones = List.copyOf(zones);
    }

    /** True if a zone takes discs out. */
    boolean removes() {
        return zones.stream().anyMatch(Zone::removes);
    }

    /** True if a zone takes discs out on their way. */
    boolean hasPockets() {
        return zones.stream().anyMatch(Zone::isPocket);
    }

    /** Meanings of contacts under these rules. */
    public Contacts contacts() {
        return hasPockets() ? Pockets.contacts() : new Contacts(1);
    }
}
