package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.io.StringReader;
import steward.cli.shared.Games;
import steward.game.podrace.protocol.PodRaceSimulation;
import steward.game.podrace.protocol.PodRaceType;

/** The protocol of {@code steward simulate} without a process. */
final class Simulation {

    private Simulation() {
    }

    /** Returns the fault of an input. */
    static String problemOf(String input) {
        PodRaceType.PodRaceSetup setup = (PodRaceType.PodRaceSetup) Games.open("mad-pod-racing");
        PodRaceSimulation protocol = new PodRaceSimulation(setup, new BufferedReader(new StringReader(input)),
            new PrintStream(new ByteArrayOutputStream()));
        return assertThrows(IllegalArgumentException.class, protocol::run).getMessage();
    }
}
