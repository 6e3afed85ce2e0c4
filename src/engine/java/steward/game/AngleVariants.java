package steward.game;

import java.util.function.Consumer;
import steward.physics.TurnLog;

/**
 * A turn about to be played, computed in every way in which the sines and cosines that it uses may be a unit in the
 * last place off. It says how far such an error reaches: another referee whose functions are not correctly rounded
 * gives times and impulses within that range. Grazing impacts amplify the error far beyond a unit in the last place.
 */
@FunctionalInterface
public interface AngleVariants {

    /** @param each is told the impacts of each variant in turn; the log is reused */
    void play(Consumer<TurnLog> each);
}
