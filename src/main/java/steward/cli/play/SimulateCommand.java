package steward.cli.play;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import steward.cli.options.ProgramCommand;
import steward.cli.options.SceneOptions;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Games;
import steward.cli.streams.StandardFiles;
import steward.files.InputException;
import steward.game.GameSetup;

/** {@code steward simulate}: answers the community's test cases for simulators. */
@Command(name = "simulate", description = "Reads states and commands of a game from the standard input, plays one "
    + "turn of each by the rules of the scene, and prints the states after it.",
    footer = {
        "", "The input is any number of games, each",
        "  checkpointCount",
        "  x y                                                     for each checkpoint",
        "  tests",
        "and then for each test",
        "  x y vx vy angleDegrees nextCheckpointId shield boosted  for each of the 4 pods",
        "  targetX targetY thrust|SHIELD|BOOST                     for each of the 4 pods",
        "The output after each test is the 4 new states in the same form. Other games",
        "than the pod race have other lines, which their pages in docs/ describe.",
        "", "Example:",
        "  steward simulate < tests.txt",
        "", "Exit status: 0 done; 2 a line is wrong or missing: the error names it."})
public final class SimulateCommand extends ProgramCommand {

    @Mixin
    private final SceneOptions scene = new SceneOptions();

    @Override
    public Integer call() {
        if (scene.isPiped()) {
            throw new InputException("--scene: found -, expected a file or a name: the standard input is for "
                + "the states");
        }
        GameSetup setup = Games.computed(scene.open(streams), "simulate");
        // Latin-1 can decode any bytes: an unexpected one is quoted in the error about its line.
        BufferedReader in = new BufferedReader(new InputStreamReader(streams.in(), StandardCharsets.ISO_8859_1));
        try {
            if (!setup.simulate(in, streams.out())) {
                throw new InputException("--scene: the game " + setup.scene().gameId()
                    + " has no lines for simulators");
            }
        } catch (IllegalArgumentException problem) {
            throw new InputException(problem.getMessage());
        } catch (IOException problem) {
            throw StandardFiles.unreadable(problem);
        }
        return ExitStatus.DONE;
    }
}
