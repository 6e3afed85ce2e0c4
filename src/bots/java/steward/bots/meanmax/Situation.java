package steward.bots.meanmax;

import java.util.ArrayList;
import java.util.List;

/** A bot's knowledge in a turn: its number, scores, rages, and all that is in the arena. */
final class Situation {

    private static final String REAPER = "reaper";

    int player;
    double arenaRadius = 6000;
    final List<Integer> scores = new ArrayList<>();
    final List<Integer> rages = new ArrayList<>();
    final List<Thing> units = new ArrayList<>();
    final List<Thing> wrecks = new ArrayList<>();
    final List<Thing> effects = new ArrayList<>();

    /** The own looter of a kind. */
    Thing own(String kind) {
        return of(player, kind);
    }

    /** A player's looter of a kind; its reaper where the league has no such looter, and obeys no order to it. */
    Thing of(int owner, String kind) {
        for (Thing unit : units) {
            if (unit.player == owner && unit.kind.equals(kind)) {
                return unit;
            }
        }
        if (!kind.equals(REAPER)) {
            return of(owner, REAPER);
        }
        throw new IllegalStateException("no " + kind + " of player " + owner);
    }

    /** All tankers. */
    List<Thing> tankers() {
        List<Thing> tankers = new ArrayList<>();
        for (Thing unit : units) {
            if (unit.kind.equals("tanker")) {
                tankers.add(unit);
            }
        }
        return tankers;
    }

    /** The reapers of the others. */
    List<Thing> rivals() {
        List<Thing> rivals = new ArrayList<>();
        for (Thing unit : units) {
            if (unit.kind.equals(REAPER) && unit.player != player) {
                rivals.add(unit);
            }
        }
        return rivals;
    }

    /** The nearest of some things, {@code null} if there is none. */
    static Thing nearest(Thing from, List<Thing> things) {
        Thing nearest = null;
        for (Thing thing : things) {
            if (nearest == null || thing.distance(from) < nearest.distance(from)) {
                nearest = thing;
            }
        }
        return nearest;
    }

    int rage() {
        return rages.get(player);
    }
}
