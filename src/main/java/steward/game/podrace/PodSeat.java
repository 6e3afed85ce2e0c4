package steward.game.podrace;

/**
 * Gives the commands of one player of a pod race to the race itself, with the same checks as a line of JSON has to
 * pass. Pods are numbered over all players, as in {@link PodRace#pod}.
 */
public final class PodSeat {

    private final PodRace race;
    private final int first;
    private final int behind;

    /** The commands of a player, numbered from 0. */
    public PodSeat(PodRace race, int player) {
        this.race = race;
        first = player * race.settings().podsPerPlayer();
        behind = first + race.settings().podsPerPlayer();
    }

    /** The player's first pod. */
    public int first() {
        return first;
    }

    /** The number after that of the player's last pod. */
    public int behind() {
        return behind;
    }

    /**
     * Steers towards a place, in u.
     *
     * @throws IllegalArgumentException if the pod is another player's, the place is not finite, or the thrust is not
     *                                  from 0 to the scene's maximum
     */
    public void thrust(int pod, double x, double y, int thrust) {
        if (thrust < 0 || thrust > race.settings().maximumThrust()) {
            throw new IllegalArgumentException("thrust: found " + thrust + ", expected 0.."
                + race.settings().maximumThrust());
        }
        give(pod, x, y, thrust);
    }

    /** Steers towards a place and raises the shield; throws as {@link #thrust}. */
    public void shield(int pod, double x, double y) {
        give(pod, x, y, PodRace.SHIELD);
    }

    /** Steers towards a place and boosts; throws as {@link #thrust}. */
    public void boost(int pod, double x, double y) {
        give(pod, x, y, PodRace.BOOST);
    }

    private void give(int pod, double x, double y, int thrust) {
        if (pod < first || pod >= behind) {
            throw new IllegalArgumentException("pod: found " + pod + ", expected " + first + ".." + (behind - 1));
        }
        if (!Double.isFinite(x) || !Double.isFinite(y)) {
            throw new IllegalArgumentException("target: found " + x + ", " + y + ", expected finite numbers");
        }
        race.command(pod, x, y, thrust);
    }

    /** Index of the checkpoint that a pod, of whichever player, must pass next. */
    public int nextCheckpoint(int pod) {
        return race.nextCheckpoint(pod);
    }
}
