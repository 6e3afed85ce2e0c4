package steward.cli.play;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Games;
import steward.cli.shared.StandardFiles;
import steward.cli.shared.Streams;
import steward.files.InputException;
import steward.game.podrace.protocol.PodRaceType;
import steward.game.podrace.protocol.SimulatorProtocol;

/** {@code steward simulate}: answers the community's tests of pod-race simulators. */
@Command(name = "simulate", description = "Reads states and commands of the pod race from the standard input, plays "
    + "one turn of each by the official rules, and prints the states after it.",
    footer = {"", "Input, until its end, any number of games, each",
        "  checkpointCount",
        "  x y                                                     for each checkpoint",
        "  tests",
        "and then for each test",
        "  x y vx vy angleDegrees nextCheckpointId shield boosted  for each of the 4 pods",
        "  targetX targetY thrust|SHIELD|BOOST                     for each of the 4 pods",
        "Output after each test: the 4 new states in the same form.",
        "", "Example:", "  steward simulate < tests.txt",
        "", "Exit status: 0 done; 2 a line is wrong or missing: the error names it."})
public final class SimulateCommand implements Callable<Integer> {

    private static final String SCENE = "mad-pod-racing";

    private final Streams streams;

    public SimulateCommand(Streams streams) {
        this.streams = streams;
    }

    @Override
    public Integer call() {
        PodRaceType.PodRaceSetup setup = (PodRaceType.PodRaceSetup) Games.open(SCENE);
        // Latin-1 can decode any bytes: an unexpected one is quoted in the error about its line.
        BufferedReader in = new BufferedReader(
            new InputStreamReader(streams.in(), StandardCharsets.ISO_8859_1));
        try {
            new SimulatorProtocol(setup, in, streams.out()).run();
        } catch (IllegalArgumentException problem) {
            throw new InputException(problem.getMessage());
        } catch (IOException problem) {
            throw StandardFiles.unreadable(problem);
        }
        return ExitStatus.DONE;
    }
}
