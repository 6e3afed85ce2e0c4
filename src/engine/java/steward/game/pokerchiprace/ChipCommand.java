package steward.game.pokerchiprace;

/**
 * A chip's command for a turn: to wait, or to push itself toward a place by ejecting a part of itself backward.
 *
 * @param x the place, in u from the centre of the table; NaN to wait
 * @param y the same
 */
public record ChipCommand(double x, double y) {

    public static final ChipCommand WAIT = new ChipCommand(Double.NaN, Double.NaN);

    public boolean waits() {
        return Double.isNaN(x);
    }
}
