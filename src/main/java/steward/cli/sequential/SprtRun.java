package steward.cli.sequential;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import steward.cli.options.SeedFileOption;
import steward.cli.play.FailureReport;
import steward.cli.play.StoredSeries;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Verbosity;
import steward.cli.streams.Interruption;
import steward.cli.streams.Json;
import steward.cli.streams.Streams;
import steward.contest.Contest;
import steward.contest.FailureCounts;
import steward.contest.FailureStreaks;
import steward.contest.Hiccups;
import steward.contest.PairedPlay;
import steward.contest.ProgramWatch;
import steward.contest.repeat.Repeats;
import steward.contest.seeds.Seeds;
import steward.league.ChosenSeeds;
import steward.league.sequential.Gsprt;
import steward.league.sequential.ScoreCounts;
import steward.text.TextFormat;

/** Running sequential test of the first bot of a contest against the second. */
public final class SprtRun {

    /** So many seeds belong to a test. */
    private static final long OWN = 1L << 40;
    /** Without a terminal the standing is told so often. */
    private static final long TELL_NANOS = TimeUnit.SECONDS.toNanos(10);
    /** More seeds without a result in a row, and something is wrong with the bots or the machine. */
    private static final int MOST_WITHOUT = 20;

    private final Streams streams;
    private final Contest contest;
    private final Gsprt test;
    private final Ending ending;
    private final StoredSeries store;
    private final Verbosity report;
    private final SprtText text;
    private final boolean random;
    private List<String> choosers = List.of();
    private boolean anyway;
    /** Guarded by this, as is all below. */
    private final ScoreCounts scores;
    private final Repeats seen = new Repeats();
    private int taken;
    private long repeats;
    private int repeatsInARow;
    private final FailureStreaks streaks = new FailureStreaks();
    private final FailureCounts failures;
    private long without;
    private long allFailed;
    private int withoutInARow;
    private long told = System.nanoTime();

    /**
     * Rules by which the test ends without a decision.
     *
     * @param budget    games in all; {@code Long.MAX_VALUE} for no end
     * @param keepGoing true if a bot that fails in every game does not end it
     * @param random    true if a bot draws by lot, so that equal games count and do not end it
     */
    public record Ending(long budget, boolean keepGoing, boolean random) { }

    /**
     * @param ending when it ends without a decision
     * @param store  where games are stored and found, or {@code null}
     */
    public SprtRun(Streams streams, Contest contest, Gsprt test, Ending ending, StoredSeries store,
                   Verbosity report) {
        this.streams = streams;
        this.contest = contest;
        this.test = test;
        this.ending = ending;
        failures = new FailureCounts(contest);
        this.store = store;
        this.report = report;
        random = ending.random() || store != null && store.isRandom();
        scores = new ScoreCounts(contest.isAlone() ? 1 : contest.players());
        text = new SprtText(test, contest.entrants().get(0).name(), contest.entrants().get(1).name());
    }

    /**
     * Flags the result.
     *
     * @param bots  names of those by whose games the seeds were chosen
     * @param isAnyway whether stored games count on seeds that games of the tested bots chose; the result is flagged
     */
    public SprtRun flagged(List<String> bots, boolean isAnyway) {
        choosers = bots;
        anyway = isAnyway;
        return this;
    }

    /** Tells the state of a test whose scores were counted elsewhere. */
    static void compute(Streams streams, Gsprt test, ScoreCounts scores, Verbosity report) {
        SprtText text = new SprtText(test, "the first", "the second");
        SprtText.Unused none = new SprtText.Unused(0, 0, 0);
        switch (report) {
            case JSON -> Json.print(streams, text.fields(scores, none));
            case LINE -> streams.out().println(text.lines(scores, none, streams.outColour()).get(1));
            default -> text.lines(scores, none, streams.outColour()).forEach(streams.out()::println);
        }
    }

    /**
     * Plays.
     *
     * @param seeds the test's own: with a list, games on others do not count
     * @param watch over the programs: when one becomes another, the test ends
     * @return the exit status
     */
    public int play(Seeds seeds, int threads, ProgramWatch watch) throws InterruptedException {
        if (report == Verbosity.FULL) {
            streams.err().println(text.heading());
        }
        PairedPlay play = new PairedPlay(contest, seeds, Hiccups.REPLAY,
            store == null ? (seed, rotation) -> null : store::outcome, store == null ? game -> { } : store::add,
            failures, watch, this::take);
        if (!seeds.isListed() && !takeStored(seeds.at(0))) {
            return end(null, seeds);
        }
        return isPlayed(play, threads, streams, store, this::tell) ? end(watch.changed(), seeds) : ExitStatus.FAILED;
    }

    /**
     * Plays until a test is over.
     *
     * @param store where games are stored, or {@code null}
     * @param tell  tells the standing after an interruption
     * @return false after an interruption: the process is about to end, with the status of its signal
     */
    static boolean isPlayed(PairedPlay play, int threads, Streams streams, StoredSeries store, Runnable tell)
            throws InterruptedException {
        try (Interruption interruption = new Interruption(streams, () -> {
            play.breakOff();
            tell.run();
            streams.out().flush();
            return store == null ? "the games are not kept; with --into they would be"
                : "what was over is stored, and the same command goes on";
        })) {
            play.play(threads);
            return interruption.over();
        }
    }

    /**
     * Takes what the league has besides the test's own seeds, without games on seeds that games of these bots chose;
     * returns whether more is wanted.
     */
    private boolean takeStored(long first) {
        if (store == null) {
            return true;
        }
        ChosenSeeds chosen = store.chosen();
        List<String> by = chosen.choosers(contest.entrants());
        List<Long> seeds = store.seeds().stream().filter(seed -> Long.compareUnsigned(seed - first, OWN) >= 0).toList();
        long refused = seeds.stream().filter(chosen::has).count();
        if (refused > 0 && anyway) {
            choosers = Stream.concat(choosers.stream(), by.stream()).distinct().toList();
        } else if (refused > 0) {
            streams.err().println("steward: stored games on " + TextFormat.count(refused, "seed") + " do not count: "
                + "games of " + TextFormat.plain(String.join(" and ", by)) + " chose " + (refused == 1 ? "it" : "them")
                + "; --anyway counts them and flags the result");
        }
        for (long seed : seeds) {
            if (!anyway && chosen.has(seed)) {
                continue;
            }
            PairedPlay.Outcome[] games = IntStream.range(0, PairedPlay.games(contest))
                .mapToObj(rotation -> store.outcome(seed, rotation)).toArray(PairedPlay.Outcome[]::new);
            if (Arrays.stream(games).allMatch(Objects::nonNull) && !take(new PairedPlay.Seed(seed, games))) {
                return false;
            }
        }
        return true;
    }

    private synchronized boolean take(PairedPlay.Seed seed) {
        taken++;
        if (seed.isWhole() && !random && seed.isRepeat(seen)) {
            repeats++;
            repeatsInARow++;
            withoutInARow = 0;
        } else if (seed.isWhole()) {
            scores.add((1 + seed.difference(contest, 0, 1)) / 2);
            repeatsInARow = 0;
            withoutInARow = 0;
        } else if (seed.allFailed()) {
            allFailed++;
            withoutInARow++;
        } else {
            without++;
            withoutInARow++;
        }
        streaks.add(contest, seed);
        if (report == Verbosity.FULL && System.nanoTime() - told > TELL_NANOS) {
            told = System.nanoTime();
            streams.err().println(text.standing(scores));
        }
        return test.state(scores) == Gsprt.State.OPEN && withoutInARow < MOST_WITHOUT
            && repeatsInARow < Repeats.ENOUGH
            && (ending.keepGoing() || streaks.failing() == null)
            && (scores.observations() + without + allFailed + repeats + 1) * scores.games() <= ending.budget();
    }

    /** @param changed the file that made a program another one before the test was over, or {@code null} */
    private synchronized int end(String changed, Seeds seeds) {
        if (withoutInARow >= MOST_WITHOUT) {
            tell();
            streams.err().println("steward: the test ends: " + MOST_WITHOUT + " seeds in a row tell nothing: their "
                + "games have no result, or all bots failed at once");
            return ExitStatus.FAILED;
        }
        boolean ended = changed != null && test.state(scores) == Gsprt.State.OPEN;
        if (!ended || store == null) {
            tell();
        }
        if (ended) {
            streams.err().println("steward: the test ends undecided after "
                + TextFormat.count(scores.observations() * scores.games(), "game") + ": " + TextFormat.plain(changed)
                + " has changed, and a verdict is of one version of each bot"
                + (store == null ? "; with --into the games are kept, and the test begins anew with the new one" : ""));
            return ExitStatus.FAILED;
        }
        if (repeatsInARow >= Repeats.ENOUGH) {
            streams.err().println("steward: the test ends undecided: the last " + Repeats.ENOUGH + " seeds repeat "
                + "games that were played before. These bots play alike whatever the seed is, so that more games tell "
                + "nothing; with --random, for a bot that draws by lot, they count");
        } else if (test.state(scores) == Gsprt.State.OPEN && !ending.keepGoing() && streaks.failing() != null) {
            streams.err().println("steward: " + streaks.ending("the test"));
            return ExitStatus.FAILED;
        } else if (test.state(scores) == Gsprt.State.OPEN && taken == seeds.count()) {
            streams.err().println("steward: the test ends undecided: all " + TextFormat.count(taken, "seed")
                + " of the list have been played");
        }
        return ExitStatus.DONE;
    }

    private synchronized void tell() {
        SprtText.Unused unused = new SprtText.Unused(without, allFailed, repeats);
        switch (report) {
            case JSON -> Json.print(streams, text.fields(scores, unused).with("choosers", choosers,
                "failures", FailureReport.json(failures.kinds())));
            case LINE -> streams.out().println(text.lines(scores, unused, streams.outColour()).get(1)
                + (choosers.isEmpty() ? "" : "; " + SeedFileOption.flag(choosers)));
            default -> {
                text.lines(scores, unused, streams.outColour()).forEach(streams.out()::println);
                if (!choosers.isEmpty()) {
                    streams.out().println(streams.outColour().warning(SeedFileOption.flag(choosers)));
                }
                FailureReport.print(streams.out(), streams.outColour(), contest, failures.kinds());
            }
        }
    }
}
