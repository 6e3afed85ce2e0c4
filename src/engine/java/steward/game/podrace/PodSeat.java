package steward.game.podrace;

/**
 * Seat of one player in a pod race, which takes the bot's commands without JSON, checked as a line of JSON would be.
 * Pods are numbered over all players, as in {@link PodRace#pod}.
 */
public final class PodSeat {

    private final PodRace race;
    private final int first;
    private final int end;

    /** For the commands of a player, numbered from 0. */
    public PodSeat(PodRace race, int player) {
        this.race = race;
        first = player * race.settings().podsPerPlayer();
        end = first + race.settings().podsPerPlayer();
    }

    public int first() {
        return first;
    }

    /** The number after the player's last pod. */
    public int end() {
        return end;
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
        setCommand(pod, x, y, thrust);
    }

    /** Steers towards a place and raises the shield; throws as {@link #thrust}. */
    public void shield(int pod, double x, double y) {
        setCommand(pod, x, y, PodRace.SHIELD);
    }

    /** Steers towards a place and boosts; throws as {@link #thrust}. */
    public void boost(int pod, double x, double y) {
        setCommand(pod, x, y, PodRace.BOOST);
    }

    private void setCommand(int pod, double x, double y, int thrust) {
        if (pod < first || pod >= end) {
            throw new IllegalArgumentException("pod: found " + pod + ", expected " + first + ".." + (end - 1));
        }
        if (!Double.isFinite(x) || !Double.isFinite(y)) {
            throw new IllegalArgumentException("target: found " + x + ", " + y + ", expected finite numbers");
        }
        race.command(pod, x, y, thrust);
    }

    /** Index of the checkpoint that a pod of any player must pass next. */
    public int nextCheckpoint(int pod) {
        return race.nextCheckpoint(pod);
    }
}
