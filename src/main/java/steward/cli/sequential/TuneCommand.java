package steward.cli.sequential;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import steward.bot.command.BotCommand;
import steward.cli.options.BotFolders;
import steward.cli.options.BuiltinBotWords;
import steward.cli.options.CallCheck;
import steward.cli.options.OptionSection;
import steward.cli.options.ProgramCommand;
import steward.cli.options.SandboxOptions;
import steward.cli.options.SceneOptions;
import steward.cli.options.SeedFileOption;
import steward.cli.options.SeedOption;
import steward.cli.options.ThreadsOption;
import steward.cli.options.TimeLimitOptions;
import steward.cli.play.FailureReport;
import steward.cli.play.StoredSeries;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.FailedException;
import steward.cli.shared.Games;
import steward.cli.shared.Verbosity;
import steward.cli.streams.Interruption;
import steward.cli.streams.Json;
import steward.contest.Contest;
import steward.contest.FailureCounts;
import steward.contest.FailureStreaks;
import steward.contest.Hiccups;
import steward.contest.PairedPlay;
import steward.contest.ProgramWatch;
import steward.contest.repeat.Repeats;
import steward.contest.seeds.Seeds;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.game.GameSetup;
import steward.league.sequential.Gsprt;
import steward.league.tune.Spsa;
import steward.league.tune.TunedCommand;
import steward.match.OwnLimits;
import steward.match.Protocol;
import steward.text.TextFormat;

/**
 * {@code steward tune}: finds good parameters of a bot. Over 400 lines, because steps, interruption and the last test
 * share one state, which goes on after an interruption.
 */
@Command(name = "tune", description = "Finds good values for parameters in a bot's command.",
    footer = {
        "", "A parameter is written {name:0.5..2} for a real number, {name:1..9} for a whole",
        "one, {name:one|other} for a choice. {name:1..9@3} begins at 3; the default is",
        "the middle. Each step plays two sets of values against the same bots on the",
        "same seeds from all seats, and moves towards the better one (SPSA). At the end",
        "the result is tested against the start. With --into the same command continues",
        "after an interruption. Of a --seed-file, the search plays the first half, again",
        "and again, and the test the second.",
        "", "Example:",
        "  steward tune --bot 'mine=./mine --aggression {a:0.2..2} --look {n:1..9}' \\",
        "      --against builtin:veteran --games 4000 --into night",
        "", "Exit status: 0 done; 1 games have no result, or a bot failed in 10 games in a",
        "row; 2 wrong call; 130 interrupted."})
public final class TuneCommand extends ProgramCommand {

    private static final long TELL_NANOS = TimeUnit.SECONDS.toNanos(10);
    private static final int MOST_SEEDS = 1000;
    /** Steps in a row of which every game was played before: the search ends. */
    private static final int STALE = 10;
    /** Steps before there is a result: a quarter of the path is one of them. */
    private static final int LEAST_STEPS = 4;
    private static final double ALPHA = 0.05;
    private static final double GAIN = 20;
    private static final String PREFIX = "tune.";
    private static final String RESULT = PREFIX + "result";
    private static final String START = PREFIX + "start";

    /** Form of a parameter. Other braces may be the bot's own business. */
    private static final Pattern PLACEHOLDER = Pattern.compile("\\{\\w+:[^{}\"]*}");

    @Mixin
    private final SceneOptions scene = new SceneOptions();

    @Option(names = "--bot", paramLabel = "BOT", required = true,
        description = "The bot, with parameters in its command.")
    private String bot;

    @Option(names = "--against", paramLabel = "BOT", required = true, completionCandidates = BuiltinBotWords.class,
        description = "A bot that it plays; can be repeated.")
    private List<String> against = new ArrayList<>();

    @Mixin
    private final BotFolders folders = new BotFolders();

    @OptionSection("The search")
    @Option(names = "--games", paramLabel = "N", defaultValue = "2000",
        description = "How many games the search plays (default: ${DEFAULT-VALUE}).")
    private Integer games;

    @OptionSection("The search")
    @Option(names = "--seeds", paramLabel = "N", defaultValue = "4",
        description = "How many seeds each set of values plays in a step (default: ${DEFAULT-VALUE}).")
    private Integer seeds;

    @OptionSection("The search")
    @Option(names = "--test-games", paramLabel = "N", defaultValue = "1000",
        description = "Tests the result against the start with at most N games; 0 for none "
            + "(default: ${DEFAULT-VALUE}).")
    private Integer testGames;

    @Option(names = "--protocol", paramLabel = "P", defaultValue = "json",
        description = "What bots without a prefix speak: json or codingame (default: ${DEFAULT-VALUE}).")
    private Protocol protocol;

    @Mixin
    private final SeedOption seed = new SeedOption();

    @Mixin
    private final SeedFileOption list = new SeedFileOption();

    @Mixin
    private final ThreadsOption threads = new ThreadsOption();

    @Option(names = "--into", paramLabel = "DIR",
        description = "Stores the games in this league, and uses games that it already has. Its table does not "
            + "list them.")
    private String into;

    @OptionSection("The search")
    @Option(names = "--keep-going", description = "Goes on when a bot has failed in 10 games in a row.")
    private boolean keepGoing;

    @OptionSection("The search")
    @Option(names = "--random", description = "Says that a bot uses random numbers: equal games are independent, "
        + "and do not end the search. In a league, the bot's mark \"random\" says so, too.")
    private boolean random;

    @Option(names = "--json", description = "Prints a JSON object in place of the result, and one of the test, each on "
        + "a line of its own.")
    private boolean json;

    @Mixin
    private final TimeLimitOptions pace = new TimeLimitOptions();

    @Mixin
    private final SandboxOptions sandbox = new SandboxOptions();

    private final FailureStreaks streaks = new FailureStreaks();
    /** By the bot that is played against. */
    private final Map<String, Failures> failures = new LinkedHashMap<>();
    private GameSetup setup;
    private TunedCommand command;
    private double factor;
    /** Of bots that have their own, by the names under which they play. */
    private Map<String, OwnLimits> limits = Map.of();
    private ProgramWatch watch;
    private final Map<List<String>, Repeats> seen = new HashMap<>();
    /** True if a game of the step was not played before. */
    private boolean fresh;
    /** Steps in which both sets of values scored alike, so that they told nothing. */
    private int tied;
    private long told = System.nanoTime();
    /** Names of the bots by whose games the seeds were chosen. */
    private List<String> choosers = List.of();

    private record Failures(Contest contest, FailureCounts counts) { }

    @Override
    public Integer call() throws InterruptedException {
        check.games(games);
        check.range("--seeds", seeds, 1, MOST_SEEDS);
        check.range("--test-games", testGames, 0, CallCheck.MOST_GAMES);
        threads.check();
        list.check(seed.isGiven(), false);
        factor = pace.factor();
        command = InputException.of("--bot: ", () -> TunedCommand.parse(bot));
        for (String other : against) {
            Matcher placeholder = PLACEHOLDER.matcher(other);
            if (placeholder.find()) {
                throw new InputException("--against: found the parameter '" + placeholder.group()
                    + "', expected a bot without any: those in --bot are tuned");
            }
        }
        setup = Games.warn(scene.open(streams), streams);
        int players = setup.scene().players();
        check.that(players <= 2, "found a scene for " + players + " players, expected one for one or two");
        int ofStep = 2 * Math.max(1, players) * seeds * against.size();
        check.that(games >= LEAST_STEPS * ofStep, "--games: found " + games + ", expected at least "
            + LEAST_STEPS * ofStep + ", as fewer than " + LEAST_STEPS + " steps tell nothing; a step has " + ofStep
            + ": two sets of values, " + TextFormat.count(seeds, "seed") + ", "
            + TextFormat.count(against.size(), "bot") + " against them, from all seats");
        limits = limits();
        checkBots();
        choosers = list.choosers(everyone().entrants().stream().distinct().toList());
        if (list.isGiven()) {
            list.atLeast(2L * seeds, ": the search takes one half, " + seeds + " a step, the test the other");
        }
        long first = seed.or(into == null ? SeedOption.draw() : 1);
        for (;;) {
            watch = StoredSeries.watch(everyone(), streams);
            int status = search(first, ofStep);
            if (watch.changed() == null) {
                return status;
            }
            if (into == null) {
                throw new FailedException(watch.changed() + " has changed: values are compared by games of one "
                    + "version of each bot; with --into the search begins anew with the new one");
            }
            streams.err().println("steward: " + TextFormat.plain(watch.changed())
                + " has changed: the search begins anew, with a new version");
            failures.clear();
            seen.clear();
        }
    }

    /** All bots that play, to be watched. */
    private Contest everyone() {
        List<Contest.Entrant> all = new ArrayList<>();
        for (int k = 0; k < against.size(); k++) {
            all.addAll(contest(command.start(), k).entrants());
        }
        return Contest.withoutBots(setup, factor).between(all);
    }

    /** Searches and tests, until it is over or a program has become another one; returns the exit status. */
    private int search(long first, int ofStep) throws InterruptedException {
        Spsa search = new Spsa(command, games / ofStep, first);
        streams.err().println("Tuning " + TextFormat.count(command.parameters().size(), "parameter") + " in "
            + TextFormat.count(games / ofStep, "step") + " of " + TextFormat.count(ofStep, "game") + ", from "
            + command.text(command.start()));
        try (Interruption interruption = new Interruption(streams, () -> search.step() + " of "
                + TextFormat.count(games / ofStep, "step") + (search.step() == 1 ? " is" : " are") + " over; "
                + (into == null ? "without --into nothing is kept" : "the games are stored, and the same command goes "
                + "on"))) {
            search(search, first);
            interruption.over();
        }
        return watch.changed() != null ? ExitStatus.FAILED : result(search, ofStep, first);
    }

    private int result(Spsa search, int ofStep, long first) throws InterruptedException {
        if (search.step() > 0 && tied == search.step()) {
            streams.err().println("steward: in each of the " + TextFormat.count(tied, "step") + " both sets of values "
                + "scored alike: the search saw no difference, and stays at the start. Try wider ranges, parameters "
                + "that the bot reads, opponents nearer in strength (--against), or more seeds a step (--seeds)");
        }
        if (!search.isOver()) {
            streams.err().println("steward: the search ends after " + TextFormat.count(search.step(), "step")
                + ": in the last " + STALE + " every game was one that had been played before. These bots play alike "
                + "whatever the seed is, and the values differ in nothing that is seen");
        }
        if (json) {
            Json.print(streams, TuneJson.of(command, search, tied, search.step() >= LEAST_STEPS).with(
                "choosers", choosers, "failures", FailureReport.json(failures.values().stream()
                    .flatMap(each -> each.counts().kinds().stream()).toList())));
        }
        if (search.step() < LEAST_STEPS) {
            if (json) {
                return ExitStatus.DONE;
            }
            streams.out().println("Start:  " + command.text(command.start()));
            streams.out().println("Result: withheld, " + TextFormat.count(search.step(), "step") + " of "
                + TextFormat.count(ofStep, "game") + " tell nothing yet; " + LEAST_STEPS + " steps are --games "
                + LEAST_STEPS * ofStep);
            return ExitStatus.DONE;
        }
        tell(search);
        return test(search, first);
    }

    private void search(Spsa search, long first) throws InterruptedException {
        int stale = 0;
        tied = 0;
        while (!search.isOver() && stale < STALE) {
            fresh = false;
            Seeds at = ofStep(first, search.step());
            double plus = score(search.trial(1), at);
            if (watch.changed() != null) {
                return;
            }
            double minus = command.with(search.trial(1)).equals(command.with(search.trial(-1))) ? plus
                : score(search.trial(-1), at);
            if (watch.changed() != null) {
                return;
            }
            search.go(plus, minus);
            tied += plus == minus ? 1 : 0;
            stale = fresh ? 0 : stale + 1;
            if (System.nanoTime() - told > TELL_NANOS) {
                told = System.nanoTime();
                streams.err().println("step " + search.step() + ": " + command.text(search.path().get(search.step())));
            }
        }
    }

    /** The tuned bot's limits are those of all its values. */
    private Map<String, OwnLimits> limits() {
        String tuned = name(command.with(command.start()));
        List<String> names = new ArrayList<>(List.of(tuned));
        everyone().entrants().stream().map(Contest.Entrant::name).filter(each -> !each.startsWith(PREFIX))
            .forEach(names::add);
        Map<String, OwnLimits> own = new HashMap<>(pace.own(names));
        if (own.containsKey(tuned)) {
            check.that(names.lastIndexOf(tuned) == 0, "--time-limit: found '" + tuned + "' in --bot and in --against, "
                + "expected another name for one of them, such as NAME=COMMAND");
            List.of(PREFIX + tuned, RESULT, START).forEach(each -> own.put(each, own.get(tuned)));
        }
        return own;
    }

    private String name(String text) {
        return BotCommand.parse(text).displayName(folders.of("--bot").get(0));
    }

    private String named(String text) {
        return PREFIX + name(text) + "=" + bare(text);
    }

    private Contest contest(List<String> bots, List<Path> own) {
        return Contest.ofSeries(setup, bots, own, protocol, factor).limitedBy(pace.basis())
            .limitedBy(limits).isolatedBy(sandbox.isolation(streams));
    }

    /** The bot with these values, and one of those that it plays. */
    private Contest contest(double[] places, int other) {
        return contest(List.of(named(command.with(places)), against.get(other)),
            List.of(folders.of("--bot").get(0), folders.of("--against").get(other)));
    }

    /** Refuses bots that cannot be started, and a league of other games, before anything is played. */
    private void checkBots() {
        for (int k = 0; k < against.size(); k++) {
            Contest contest = contest(command.start(), k);
            if (into != null) {
                StoredSeries.open(OutputFiles.path(into), contest, factor, sandbox.variables(), streams).close();
                list.keepIn(OutputFiles.path(into));
            }
        }
    }

    /** The programs that play, whatever they are called. */
    private static List<String> players(Contest contest) {
        return contest.entrants().stream().map(entrant -> String.join(" ", entrant.words())).toList();
    }

    /** The seeds of a step; of a list those of its first half, again and again. */
    private Seeds ofStep(long first, int step) {
        return !list.isGiven() ? Seeds.from(first + (long) step * seeds)
            : Seeds.of(IntStream.range(0, seeds).mapToObj(k -> list.seeds()
                .at((int) (((long) step * seeds + k) % (list.seeds().count() / 2)))).toList());
    }

    /** Mean score of these values on some seeds, 0..1. */
    private double score(double[] places, Seeds ofStep) throws InterruptedException {
        double[] sum = new double[1];
        int[] count = new int[1];
        for (int k = 0; k < against.size(); k++) {
            String other = against.get(k);
            Contest contest = contest(places, k);
            try (StoredSeries store = into == null ? null
                    : StoredSeries.open(OutputFiles.path(into), contest, factor, sandbox.variables(), streams)) {
                int[] over = new int[1];
                new PairedPlay(contest, ofStep, Hiccups.REPLAY,
                    store == null ? (number, rotation) -> null : store::outcome,
                    store == null ? game -> { } : store::add,
                    failures.computeIfAbsent(other, bot -> new Failures(contest, new FailureCounts(contest))).counts(),
                    watch, result -> {
                        if (result.isWhole()) {
                            fresh |= random || store != null && store.isRandom()
                                || !result.isRepeat(seen.computeIfAbsent(players(contest), key -> new Repeats()));
                            sum[0] += (1 + result.difference(contest, 0, 1)) / 2;
                            count[0]++;
                        }
                        streaks.add(contest, result);
                        return ++over[0] < seeds && (keepGoing || streaks.failing() == null);
                    }).play(Math.min(threads.count(streams), seeds * 2));
            }
        }
        if (!keepGoing && streaks.failing() != null) {
            printFailures();
            streams.out().flush();
            throw new FailedException(streaks.ending("the search"));
        }
        if (count[0] == 0 && watch.changed() == null) {
            printFailures();
            throw new FailedException("no game of " + command.text(places) + " has a result");
        }
        return sum[0] / count[0];
    }

    private void printFailures() {
        failures.values().forEach(each ->
            FailureReport.print(streams.out(), streams.outColour(), each.contest(), each.counts().kinds()));
    }

    private void tell(Spsa search) {
        if (!json) {
            print(search);
        }
    }

    private void print(Spsa search) {
        double[] result = search.result();
        double[] spread = search.spread();
        streams.out().println("Start:  " + command.text(command.start()));
        streams.out().println("Result: " + command.text(result));
        for (int k = 0; k < result.length; k++) {
            streams.out().println("  " + command.parameters().get(k).name() + ": "
                + command.parameters().get(k).value(result[k]) + ", in the last quarter of the path mostly "
                + command.parameters().get(k).value(result[k] - 2 * spread[k]) + " to "
                + command.parameters().get(k).value(result[k] + 2 * spread[k]));
        }
        streams.out().println("Bot:    " + command.with(result));
        if (!choosers.isEmpty()) {
            streams.out().println(streams.outColour().warning(SeedFileOption.flag(choosers)));
        }
        printFailures();
        streams.out().flush();
    }

    /** Tests the result against the start. */
    private int test(Spsa search, long first) throws InterruptedException {
        String result = command.with(search.result());
        String start = command.with(command.start());
        if (testGames == 0 || result.equals(start)) {
            if (!json) {
                streams.out().println(testGames == 0 ? "Not tested." : "The result is the start.");
            }
            return ExitStatus.DONE;
        }
        Contest contest = contest(List.of(RESULT + "=" + bare(result), START + "=" + bare(start)),
            Collections.nCopies(2, folders.of("--bot").get(0)));
        Gsprt test = new Gsprt(0, GAIN, ALPHA, ALPHA, Gsprt.Model.NORMALIZED);
        SprtRun.Ending ending = new SprtRun.Ending(testGames, keepGoing, random);
        Verbosity report = json ? Verbosity.JSON : Verbosity.FULL;
        if (!json) {
            streams.out().println();
        }
        if (into == null) {
            return new SprtRun(streams, contest, test, ending, null, report).flagged(choosers, false)
                .play(list.isGiven() ? ofTest() : Seeds.from(first + games), threads.count(streams), watch);
        }
        try (StoredSeries store = StoredSeries.open(OutputFiles.path(into), contest, factor, sandbox.variables(),
                streams)) {
            return new SprtRun(streams, contest, test, ending, store, report).flagged(choosers, list.isAnyway())
                .play(list.isGiven() ? ofTest() : Seeds.from(store.ownSeed()), threads.count(streams), watch);
        }
    }

    /** The seeds of a list that the search does not use. */
    private Seeds ofTest() {
        return list.seeds().after(list.seeds().count() / 2);
    }

    private static String bare(String text) {
        BotCommand parsed = BotCommand.parse(text);
        return new BotCommand(null, parsed.prefix(), parsed.words()).toString();
    }
}
