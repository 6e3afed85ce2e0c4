package steward.game.podrace;

import java.util.Locale;
import steward.Internal;

/**
 * Edition of the pod race's rules, {@code race.rules} of a scene. Both have the same physics; they differ in when a
 * checkpoint is passed and when a player is out.
 */
public enum RulesEdition {

    /**
     * The rules of the live server, read off its games of 2025-26. A checkpoint of radius r is passed when some segment
     * of the path comes nearer than r, or the rounded end of the turn is at r or nearer. Five turns with a distance of
     * exactly r inside a segment do not pass. That r itself counts at the end rests on indirect evidence: an older
     * server shows it, and none of the turns at hand contradicts it. A player is out when no turn is left and one more
     * has been played (-1 turns left).
     */
    LIVE,

    /**
     * The rules of the contest's published referee: r itself counts everywhere on the path, and a player is out when no
     * turn is left. Scenes without the field have these.
     */
    CONTEST;

    private static final double NEVER = -1;

    /** The name in a scene. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The greatest distance of a segment of the path from a checkpoint that is passed. */
    @Internal
    public double reachOfPath(double radius) {
        return this == LIVE ? Math.nextDown(radius) : radius;
    }

    /** The greatest distance of the rounded end of a turn from a checkpoint that is passed; below 0 for none. */
    @Internal
    public double reachOfEnd(double radius) {
        return this == LIVE ? radius : NEVER;
    }

    /** The fewest turns left of a player who is in. */
    @Internal
    public int fewestTurnsLeft() {
        return this == LIVE ? 0 : 1;
    }

    /**
     * The checkpoint that is shown as a pod's next one: of a pod that has finished, the live server goes on to show
     * checkpoint 0.
     *
     * @param passed      checkpoints that the pod has passed
     * @param toFinish    checkpoints of the whole race
     * @param checkpoints number of checkpoints of the map
     */
    @Internal
    public int shownNext(int passed, int toFinish, int checkpoints) {
        return this == LIVE && passed >= toFinish ? 0 : (passed + 1) % checkpoints;
    }
}
