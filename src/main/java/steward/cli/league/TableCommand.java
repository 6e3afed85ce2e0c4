package steward.cli.league;

import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Streams;

/** {@code steward league table}: ratings and who beat whom. */
@Command(name = "table", description = "Prints the table of a league: ratings with their bars, and who beat whom.",
    footer = {"", "Example:", "  steward league table night"})
final class TableCommand implements Callable<Integer> {

    private final Streams streams;

    @Mixin
    private final LeagueArgument league = new LeagueArgument();

    TableCommand(Streams streams) {
        this.streams = streams;
    }

    @Override
    public Integer call() {
        try (LeagueOpening.Opened opened = LeagueOpening.read(league.open())) {
            TableText.whole(opened.table(), opened.season(), streams.outColour()).forEach(streams.out()::println);
        }
        return ExitStatus.DONE;
    }
}
