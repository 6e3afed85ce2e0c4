package steward.cli.options;

import picocli.CommandLine.Option;
import steward.cli.shared.Games;
import steward.game.GameTypes;

/** Option that permits a replay's own referee to be run, since a replay may name any program of this machine. */
public final class RefereeOption {

    @Option(names = "--run-referee", description = "Runs the referee program that the replay names, if it has "
        + "one. Use it only for replays that you trust.")
    private boolean run;

    /** The games that a replay may be played again with. */
    public GameTypes types() {
        return Games.types(run);
    }
}
