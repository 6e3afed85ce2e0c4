package steward.cli.machines;

import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import steward.cli.league.run.RunCommand;
import steward.cli.league.view.LeagueArgument;
import steward.cli.league.view.LeagueOpening;
import steward.cli.options.ProgramCommand;
import steward.cli.options.ThreadsOption;
import steward.cli.play.StoredSeries;
import steward.cli.shared.ExitStatus;
import steward.cli.streams.Interruption;
import steward.contest.Contest;
import steward.contest.ProgramWatch;
import steward.files.OutputFiles;
import steward.league.LeagueBot;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Season;
import steward.league.play.Roster;
import steward.league.play.RosterReader;
import steward.league.store.PartStore;
import steward.machines.part.PartPlay;
import steward.text.TextFormat;

/** {@code steward league shard}: one part of a league's games, in a file of its own. */
@Command(name = "shard", description = "Plays one part of a league's games, to be merged later: for clusters.",
    footer = {"",
        "The folder of the league is only read, and may be on a disk of another machine",
        "as long as nobody plays the league. All parts of the same league with the same",
        "--games are together the games of 'league run --games N'. Ended at any moment,",
        "the same command goes on where it was.",
        "", "Examples:",
        "  steward league shard night --part 3/16 --games 10000 --out part03.db",
        "  steward league merge night part*.db",
        "", "Exit status: 0 the part or the time is over; 1 games could not be stored; 2 the",
        "call or the league is unusable; 130 interrupted."})
final class ShardCommand extends ProgramCommand {

    private static final Pattern PART = Pattern.compile("([0-9]{1,5})/([0-9]{1,5})");
    private static final int MOST_PARTS = 10_000;

    @Mixin
    private final LeagueArgument league = new LeagueArgument();

    @Option(names = "--part", paramLabel = "K/N", required = true, description = "Which part of how many, such as "
        + "3/16.")
    private String part;

    @Option(names = "--games", paramLabel = "N", required = true, description = "How many games the league has when "
        + "all parts are merged, those that it has now included; the same for all parts.")
    private long games;

    @Option(names = "--out", paramLabel = "FILE", required = true, description = "Where the part goes; one that is "
        + "there is gone on with.")
    private String out;

    @Mixin
    private final ThreadsOption threads = new ThreadsOption();

    @Option(names = "--for", paramLabel = "TIME", description = "Ends after so long, such as 90s, 30m, 8h or 2d.")
    private String time;

    @Option(names = "--quiet", description = "Prints nothing at the end.")
    private boolean quiet;

    @Override
    public Integer call() throws InterruptedException {
        threads.check();
        check.range("--games", games, 1, Integer.MAX_VALUE);
        Matcher matcher = PART.matcher(part);
        int of = matcher.matches() ? Integer.parseInt(matcher.group(2)) : 0;
        int number = matcher.matches() ? Integer.parseInt(matcher.group(1)) : 0;
        check.that(number >= 1 && number <= of && of <= MOST_PARTS, "--part: found '" + part
            + "', expected a number and how many parts there are, such as 3/16, up to " + MOST_PARTS);
        long nanos = RunCommand.nanos(time);
        LeagueFolder folder = league.open();
        LeagueSettings settings = folder.read();
        Contest contest = LeagueOpening.contest(folder, settings, streams);
        Season season = Season.of(contest.setup(), settings);
        PartPlay.check(settings, season);
        Path file = OutputFiles.path(out);
        try (PartStore store = PartStore.write(file, new PartStore.Head(number, of, games, settings.seed(),
                settings.pairing()), season)) {
            PartPlay.prepare(folder, store);
            ProgramWatch watch = StoredSeries.watch(contest.between(settings.active().stream().map(LeagueBot::entrant)
                .toList()), streams);
            RosterReader reader = new RosterReader(store.games(), contest, LeagueOpening.environment(settings), false,
                what -> streams.err().println("steward: " + TextFormat.plain(what)), System::currentTimeMillis);
            Roster roster = folder.named(() -> reader.read(settings));
            return play(folder, store, file, roster, watch, contest, nanos);
        }
    }

    @SuppressWarnings("try")                           // only closed, never used
    private int play(LeagueFolder folder, PartStore store, Path file, Roster roster, ProgramWatch watch,
                     Contest contest, long nanos) throws InterruptedException {
        AtomicLong played = new AtomicLong();
        PartPlay run = new PartPlay(folder, store, roster, watch, contest, RunCommand.machine(contest), nanos,
            game -> played.addAndGet(game.counts() ? 1 : 0));
        AtomicBoolean told = new AtomicBoolean();
        try (Interruption interruption = new Interruption(streams, () -> told.getAndSet(true) ? null
                : interrupted(run.breakOff(), played.get()))) {
            run.play(threads.count(streams));
            if (told.getAndSet(true)) {
                return ExitStatus.FAILED;              // the process is about to end, with the status of its signal
            }
        }
        if (run.stopped() != null) {
            streams.err().println("steward: the part ends: " + TextFormat.plain(run.stopped())
                + "; what was over before is stored");
            return ExitStatus.FAILED;
        }
        if (!quiet) {
            streams.out().println("Part " + part + ": " + TextFormat.count(played.get(), "game") + " played, "
                + store.count() + " in " + file);
        }
        return ExitStatus.DONE;
    }

    private static String interrupted(int cut, long played) {
        return TextFormat.count(played, "game") + " of this run " + (played == 1 ? "is" : "are") + " stored, " + cut
            + " under way " + (cut == 1 ? "was" : "were") + " ended; the same command goes on";
    }
}
