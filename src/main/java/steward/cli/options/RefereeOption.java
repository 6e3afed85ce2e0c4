package steward.cli.options;

import picocli.CommandLine.Option;
import steward.cli.shared.Games;
import steward.game.GameTypes;

/** Option that permits a replay's own referee to be run, since a replay may name any program of this machine. */
public final class RefereeOption {

    @Option(names = "--run-referee", description = "Runs the program that the replay names as its referee, where "
        + "it has one: for replays that are yours.")
    private boolean run;

    /** The games that a replay may be played again with. */
    public GameTypes types() {
        return Games.types(run);
    }
}
