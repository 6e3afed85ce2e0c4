package steward.cli.league.run;

import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import steward.cli.league.view.LeagueArgument;
import steward.cli.league.view.LeagueOpening;
import steward.cli.league.view.ReferenceOptions;
import steward.cli.league.view.RoundText;
import steward.cli.league.view.TableCommand;
import steward.cli.league.view.TableText;
import steward.cli.league.view.WorkerBooks;
import steward.cli.options.CallCheck;
import steward.cli.options.OptionSection;
import steward.cli.options.ProgramCommand;
import steward.cli.options.ThreadsOption;
import steward.cli.options.WatchOptions;
import steward.cli.shared.ExitStatus;
import steward.cli.streams.Interruption;
import steward.contest.Contest;
import steward.files.InputException;
import steward.league.ChosenSeeds;
import steward.league.FolderLock;
import steward.league.LeagueBot;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.pairing.StopRule;
import steward.league.play.LeagueRun;
import steward.league.play.OpenSeason;
import steward.league.play.Roster;
import steward.league.play.RosterReader;
import steward.league.rating.LeagueTable;
import steward.league.rating.Ratings;
import steward.league.rating.Results;
import steward.league.store.GameQueries;
import steward.league.store.GameStore;
import steward.league.store.SeasonOpening;
import steward.text.TextFormat;

/** {@code steward league run}: plays the games of a league. */
@Command(name = "run", description = "Plays a league until it is told to end, and continues where an earlier run "
    + "ended.",
    footer = {
        "", "Every game is stored when it is over. Ctrl-C ends the games that are under way;",
        "finished games are stored, even after 'kill -9'. The same command continues",
        "with the same seeds. league.json is read anew between games.",
        "", "Examples:",
        "  steward league run night --threads auto --for 8h",
        "  steward league run night --games 1000 --watch --open",
        "  steward league run night --until-ranked --equal 5",
        "", "Exit status: 0 an end was reached; 1 broken: games could not be stored, or no",
        "machine can play them; 2 the call or the league is unusable; 130 interrupted,",
        "143 terminated."})
public final class LeagueRunCommand extends ProgramCommand {

    private static final Pattern TIME = Pattern.compile("([0-9]{1,9})([smhd])");

    @Mixin
    private final LeagueArgument league = new LeagueArgument();

    @Mixin
    private final ThreadsOption threads = new ThreadsOption();

    @OptionSection("The end")
    @Option(names = "--games", paramLabel = "N",
        description = "Ends when the league has played N games in all, including earlier runs.")
    private Long games;

    @OptionSection("The end")
    @Option(names = "--for", paramLabel = "TIME", description = "Ends after this time, such as 90s, 30m, 8h or 2d.")
    private String time;

    @Mixin
    private final UntilOptions until = new UntilOptions();

    @Mixin
    private final ReferenceOptions reference = new ReferenceOptions();

    @Option(names = "--pause-after", paramLabel = "N", defaultValue = "20", description = "Pauses a bot that "
        + "failed in N games in a row (see 'league resume'); 0 for never (default: ${DEFAULT-VALUE}).")
    private Integer pauseAfter;

    @Option(names = "--durable", description = "Waits with every game until it is on the disk, so that nothing is "
        + "lost even if the power fails.")
    private boolean durable;

    @Option(names = "--same", description = "Counts a bot whose program has changed as its old version.")
    private boolean same;

    @Option(names = "--new-season", description = "Begins a new table if the scene or the limits have changed; "
        + "the old games stay.")
    private boolean anew;

    @Option(names = "--anyway", description = "Plays even if games of a bot were used to choose the league's list "
        + "of seeds, and flags the table.")
    private boolean anyway;

    @Mixin
    private final WatchOptions watch = new WatchOptions();

    @OptionSection("Watching")
    @Option(names = "--open", description = "Opens the page of --watch in the browser.")
    private boolean open;

    @Mixin
    private final Serving serving;

    @Option(names = "--quiet", description = "Prints no table at the end, and none while it plays.")
    private boolean quiet;

    @Option(names = "--json", description = "Prints each event as a line of JSON with its time, and no table while it "
        + "plays.")
    private boolean json;

    /** Plans the games to be played and no others, or {@code null}. */
    private LeagueRun.Planner plan;
    private Consumer<StoredGame> follower = game -> { };
    /** True if the caller says what begins and what was played. */
    private boolean part;
    /** Names of the bots by whose games the list of seeds was chosen. */
    private List<String> choosers = List.of();

    /** @param serving an object with options that let other machines play */
    public LeagueRunCommand(Serving serving) {
        this.serving = serving;
    }

    /**
     * Plays what a plan says, and prints no table.
     *
     * @param ofMore   true if the caller says itself what begins and how many games there were
     * @param listener is told of each game, by any thread
     */
    public LeagueRunCommand following(LeagueRun.Planner maker, boolean ofMore, Consumer<StoredGame> listener) {
        plan = maker;
        part = ofMore;
        follower = listener;
        return this;
    }

    @Override
    @SuppressWarnings("try")                           // the lock is only closed, never used
    public Integer call() throws InterruptedException {
        // A terminal has a table that is written over; what a service prints is a log.
        streams = json || serving.isServed() && !streams.errTerminal() ? streams.logging(json) : streams;
        threads.check(serving.isServed() ? 0 : 1);      // a league with workers may play nothing itself
        watch.check(check);
        check.that(watch.watch() || !open, "--open is for --watch, expected both");
        StopRule rule = until.rule();
        check.range("--pause-after", pauseAfter, 0, Integer.MAX_VALUE);
        check.range("--games", games, 1, Integer.MAX_VALUE);
        LeagueRun.Limits limits = new LeagueRun.Limits(threads.count(streams), games == null ? Long.MAX_VALUE : games,
            nanos("--for", time));
        LeagueFolder folder = league.openToWrite(streams);
        LeagueFolder.refuseRemote(folder.path());
        LeagueSettings settings = folder.read();
        Contest contest = LeagueOpening.contest(folder, settings, streams);
        choosers = LeagueOpening.choosers(folder, settings);
        if (!choosers.isEmpty() && !anyway) {
            throw new InputException(folder.path().resolve(settings.seedFile()) + ": found seeds that were chosen by "
                + "games of " + TextFormat.plain(String.join(" and ", choosers)) + ", expected others: such seeds tell "
                + "of a bot what its own games told; --anyway plays on them and flags the table");
        }
        Season season = Season.of(contest.setup(), settings);
        try (FolderLock lock = FolderLock.take(folder);
             GameStore store = durable ? GameStore.durable(folder) : GameStore.write(folder);
             GameStore viewed = GameStore.unchecked(folder, false)) {
            store.before().ifPresent(copy -> streams.err().println("steward: " + folder.database()
                + ": brought up to date; as it was: " + copy));
            int number = SeasonOpening.open(folder, store, season, anew);
            ChosenSeeds.keep(folder, folder.seeds(settings));
            choosers = ChosenSeeds.of(folder, settings).choosers(settings.active().stream().map(LeagueBot::entrant)
                .toList());
            return play(new OpenSeason(folder, store, number, season), settings,
                new GameQueries(viewed, number, season), contest, limits, new LeagueRun.Rules(rule, pauseAfter, plan));
        }
    }

    /** Returns the nanoseconds of an option; {@code Long.MAX_VALUE} where it is not there. */
    public static long nanos(String option, String time) {
        if (time == null) {
            return Long.MAX_VALUE;
        }
        Matcher matcher = TIME.matcher(time);
        CallCheck.withHelp().that(matcher.matches() && Long.parseLong(matcher.group(1)) > 0,
            option + ": found '" + time + "', expected a time such as 90s, 30m, 8h or 2d");
        TimeUnit unit = switch (matcher.group(2)) {
            case "s" -> TimeUnit.SECONDS;
            case "m" -> TimeUnit.MINUTES;
            case "h" -> TimeUnit.HOURS;
            default -> TimeUnit.DAYS;
        };
        return unit.toNanos(Long.parseLong(matcher.group(1)));
    }

    @SuppressWarnings("try")                           // only closed, never used
    private int play(OpenSeason open, LeagueSettings settings, GameQueries viewed, Contest contest,
                     LeagueRun.Limits limits, LeagueRun.Rules rules) throws InterruptedException {
        Season season = open.season();
        // What has been played is summed up while the run reads which games it consists of.
        CompletableFuture<Results> past = CompletableFuture.supplyAsync(viewed::results);
        LiveTable screen = new LiveTable(streams.err());
        Consumer<String> teller = what -> screen.say("steward: " + TextFormat.plain(what));
        RosterReader reader = new RosterReader(open.store(), contest, LeagueOpening.environment(settings), same,
            teller, System::currentTimeMillis);
        Roster roster = open.folder().named(() -> reader.read(settings));
        LeagueProgress progress = new LeagueProgress(open.store(), limits);
        Serving.Service machines = serving.start(open.folder(), season, contest, settings, teller);
        LeagueRun run;
        try (screen; machines) {
            run = new LeagueRun(open, contest, reader, roster, limits, rules, machines == null ? null
                : machines.games(), machine(contest.sandbox()), teller, game -> {
                    progress.add(game);
                    follower.accept(game);
                    if (machines != null) {
                        machines.stored(game);
                    }
                });
            progress.goOn(done(past));
            progress.tellAgainst(reference, settings);
            if (plan != null) {
                progress.planned(run.planned());
            }
            try (LeagueWatch page = watch.watch() ? LeagueWatch.start(open.folder(), season, viewed, progress, watch)
                     : null;
                 Interruption interruption = new Interruption(streams, () ->
                     interrupted(run, progress, season, machines, screen))) {
                if (page != null) {
                    page.follow(run, machines, streams, this.open);
                }
                if (machines != null) {
                    machines.follow(run, () -> WorkerBooks.read(viewed, open.store()),
                        () -> progress.replace(viewed::results));
                }
                if (streams.errTerminal() && !quiet) {
                    screen.draw(() -> progress.lines(run, machines, streams::errColour));
                }
                if (!quiet && !part) {
                    sayBegin(teller, contest, plan != null ? progress.planned() : length(settings, season, roster));
                    sayNeeded(teller, progress, run);
                }
                run.play();
                if (!interruption.over()) {
                    return ExitStatus.FAILED;          // the process is about to end, with the status of its signal
                }
            }
        }
        tell(run, progress, season, machines);
        if (run.stopped() != null) {
            streams.err().println("steward: the league ends: " + TextFormat.plain(run.stopped())
                + "; what was over before is stored, and the same command goes on");
            return ExitStatus.FAILED;
        }
        return ExitStatus.DONE;
    }

    /** Returns the result of a reading that went on meanwhile. */
    private static <T> T done(CompletableFuture<T> reading) {
        try {
            return reading.join();
        } catch (CompletionException problem) {
            throw problem.getCause() instanceof InputException unusable ? unusable : problem;
        }
    }

    private static String length(LeagueSettings settings, Season season, Roster roster) {
        return RoundText.length(settings, roster.versions(), season.players(), settings.gauntlet() == null ? -1
            : roster.versionOf(settings.gauntlet()).orElse(-1), roster.meeting());
    }

    private void sayNeeded(Consumer<String> teller, LeagueProgress progress, LeagueRun run) {
        if (!Double.isNaN(until.rule().bars())) {
            Results results = progress.table(run.roster().settings()).results();
            UntilOptions.needed(until.rule(), Ratings.of(results, run.active()), run.roster()).forEach(teller);
        }
    }

    private static void sayBegin(Consumer<String> teller, Contest contest, String length) {
        if (!contest.hold().isEmpty()) {
            teller.accept(contest.hold());
        }
        teller.accept(length);
    }

    /** Called at Ctrl-C, on another thread than the playing ones. */
    private String interrupted(LeagueRun run, LeagueProgress progress, Season season,
                               Serving.Service machines, LiveTable screen) {
        int cut = run.breakOff();
        screen.close();
        tell(run, progress, season, machines);
        streams.out().flush();
        return TextFormat.count(progress.played(), "game") + " of this run " + (progress.played() == 1 ? "is" : "are")
            + " stored, " + cut + " under way " + (cut == 1 ? "was" : "were")
            + " ended and will be played again; the same command goes on";
    }

    private void tell(LeagueRun run, LeagueProgress progress, Season season, Serving.Service machines) {
        if (quiet) {
            return;
        }
        progress.settle();
        if (plan == null) {
            tellTable(run, progress, season, machines);
        }
        if (!part) {
            streams.out().println(playedText(progress.played(), progress.rate()));
        }
    }

    /** Returns the number of games and games a second, in words. */
    public static String playedText(long played, double rate) {
        return TextFormat.count(played, "game") + " in this run, " + TextFormat.number(rate, 2) + " games/s.";
    }

    private void tellTable(LeagueRun run, LeagueProgress progress, Season season, Serving.Service machines) {
        LeagueTable table = progress.table(run.roster().settings());
        TableText.whole(table, season, machines == null ? List.of() : machines.workers(), streams.outColour())
            .forEach(streams.out()::println);
        (run.ended() != null ? UntilOptions.tell(run.ended(), run.roster(), season.players())
            : UntilOptions.missing(until.rule(), Ratings.of(table.results(), run.active()), run.roster(),
                season.players()))
            .forEach(streams.out()::println);
        RoundText.unfinished(table, run.roster().settings(), season.players()).ifPresent(streams.out()::println);
        TableCommand.flag(choosers, streams);
        if (run.isExhausted(true)) {
            streams.out().println("The bots have played all seeds of " + run.roster().settings().seedFile() + ".");
        }
        if (run.isExhausted(false)) {
            streams.out().println("The bots only repeat games that were played before, whatever the seed is: more of "
                + "them tell nothing. A bot that draws by lot is to be marked, \"random\": true in league.json.");
        }
    }

    /** Returns the machine that is noted with each game. @param sandbox level of isolation */
    public static String machine(String sandbox) {
        return "Java " + System.getProperty("java.version") + ", " + System.getProperty("os.name") + " "
            + System.getProperty("os.arch") + ", "
            + TextFormat.count(ManagementFactory.getOperatingSystemMXBean().getAvailableProcessors(), "processor")
            + ", sandbox " + sandbox;
    }
}
