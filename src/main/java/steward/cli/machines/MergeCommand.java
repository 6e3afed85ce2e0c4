package steward.cli.machines;

import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import steward.cli.league.view.LeagueArgument;
import steward.cli.league.view.LeagueOpening;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Games;
import steward.contest.Contest;
import steward.files.OutputFiles;
import steward.league.FolderLock;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Season;
import steward.league.play.Roster;
import steward.league.play.RosterReader;
import steward.league.store.GameStore;
import steward.league.store.PartStore;
import steward.league.store.SeasonOpening;
import steward.machines.part.PartMerge;
import steward.text.TextFormat;

/** {@code steward league merge}: parts that were played elsewhere. */
@Command(name = "merge", description = "Takes parts that 'league shard' has played into the league.",
    footer = {"",
        "Every game is played again, and what is stored follows from that alone. In the",
        "first 20 games of a part, and in a share of the others, bots that do not draw",
        "by lot are asked again what they were asked, and have to give the same answers.",
        "A part in which anything is wrong is refused as a whole. Games that the league",
        "has are passed over: merging again changes nothing.",
        "", "Example:", "  steward league merge night part*.db"})
final class MergeCommand extends ProgramCommand {

    private static final int PERCENT = 100;

    @Mixin
    private final LeagueArgument league = new LeagueArgument();

    @Parameters(index = "1..*", arity = "1..*", paramLabel = "FILE", description = "The parts.")
    private List<String> files;

    @Option(names = "--again", paramLabel = "PERCENT", defaultValue = "5", description = "Asks the bots again in so "
        + "many of the games behind the first 20 of a part (default: ${DEFAULT-VALUE}); 0 for none, not in the first "
        + "20 either.")
    private int again;

    @Override
    @SuppressWarnings("try")                           // the lock is only held
    public Integer call() {
        check.range("--again", again, 0, PERCENT);
        LeagueFolder folder = league.openToWrite(streams);
        LeagueFolder.refuseRemote(folder.path());
        LeagueSettings settings = folder.read();
        Contest contest = LeagueOpening.contest(folder, settings, streams);
        Season season = Season.of(contest.setup(), settings);
        try (FolderLock lock = FolderLock.take(folder); GameStore store = GameStore.write(folder)) {
            int number = SeasonOpening.open(folder, settings, store, season, false);
            RosterReader reader = new RosterReader(store, contest, LeagueOpening.environment(settings), false,
                what -> streams.err().println("steward: " + TextFormat.plain(what)), System::currentTimeMillis);
            Roster roster = folder.named(() -> reader.read(settings));
            PartMerge merge = new PartMerge(folder, store, season, number, roster, contest, Games.types(),
                (double) again / PERCENT);
            for (String file : files) {
                Path path = OutputFiles.path(file);
                try (PartStore part = PartStore.read(path)) {
                    tell(path, part, merge.merge(part, path.toString()));
                }
            }
        }
        return ExitStatus.DONE;
    }

    private void tell(Path path, PartStore part, PartMerge.Merged merged) {
        streams.out().println(path + ": part " + part.head().part() + "/" + part.head().parts() + ", "
            + TextFormat.count(merged.added(), "game") + " stored, " + merged.there() + " were there already; bots "
            + "were asked again in " + TextFormat.count(merged.again(), "game"));
    }
}
