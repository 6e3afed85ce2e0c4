package steward.cli;

import java.util.List;
import steward.game.GameTypes;
import steward.game.podrace.PodRaceType;

/** The games that the program knows. */
final class Games {

    private Games() {
    }

    /** All of them. */
    static GameTypes types() {
        return new GameTypes(List.of(new PodRaceType()));
    }
}
