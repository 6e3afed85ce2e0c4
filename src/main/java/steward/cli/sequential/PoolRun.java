package steward.cli.sequential;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import steward.cli.play.FailureReport;
import steward.cli.play.StoredSeries;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Verbosity;
import steward.cli.streams.Json;
import steward.cli.streams.Streams;
import steward.contest.Contest;
import steward.contest.FailureCounts;
import steward.contest.FailureKind;
import steward.contest.FailureStreaks;
import steward.contest.Hiccups;
import steward.contest.PairedPlay;
import steward.contest.ProgramWatch;
import steward.contest.Series;
import steward.contest.repeat.Repeats;
import steward.contest.seeds.Seeds;
import steward.league.sequential.Gsprt;
import steward.text.TextFormat;

/**
 * Running test of a new bot and its base against a pool of opponents. Each seed draws one opponent, or as many as there
 * are other seats; both the new bot and the base play it from all seats.
 */
final class PoolRun implements PairedPlay.Tables {

    private static final long TELL_NANOS = TimeUnit.SECONDS.toNanos(10);
    /** More seeds in a row that tell nothing, and something is wrong with the bots or the machine. */
    private static final int MOST_IDLE = 20;

    private final Streams streams;
    private final Gsprt test;
    private final SprtRun.Ending ending;
    private final Verbosity report;
    private final PoolText text;
    private final Seeds seeds;
    private final StoredSeries store;
    /** By opponent: the contest of the new bot, and that of the base. */
    private final List<List<Contest>> contests = new ArrayList<>();
    private final Map<Contest, FailureCounts> failures = new IdentityHashMap<>();
    private final Map<Contest, StoredSeries> stores = new IdentityHashMap<>();
    /** Guarded by this, as is all below. */
    private final PoolScores pool;
    private final FailureStreaks streaks = new FailureStreaks();
    private int taken;
    private long told = System.nanoTime();

    /**
     * A test that is to begin.
     *
     * @param everyone the new bot, the base, then the opponents
     * @param store    where games are stored and found, or {@code null}
     */
    PoolRun(Streams streams, Contest everyone, Gsprt test, SprtRun.Ending ending, PoolText text, Seeds seeds,
            StoredSeries store, Verbosity report) {
        this.streams = streams;
        this.test = test;
        this.ending = ending;
        this.text = text;
        this.seeds = seeds;
        this.store = store;
        this.report = report;
        List<Contest.Entrant> bots = everyone.entrants();
        List<Contest.Entrant> others = bots.subList(2, bots.size());
        List<String> names = new ArrayList<>();
        for (int first = 0; first < others.size(); first++) {
            int from = first;
            List<Contest.Entrant> group = IntStream.range(0, everyone.players() - 1)
                .mapToObj(k -> others.get((from + k) % others.size())).toList();
            contests.add(List.of(contest(everyone, bots.get(0), group), contest(everyone, bots.get(1), group)));
            names.add(group.stream().map(Contest.Entrant::name).collect(Collectors.joining(", ")));
        }
        pool = new PoolScores(contests.get(0).get(0), names, ending.random() || store != null && store.isRandom());
    }

    private Contest contest(Contest everyone, Contest.Entrant tested, List<Contest.Entrant> group) {
        List<Contest.Entrant> bots = new ArrayList<>(List.of(tested));
        bots.addAll(group);
        Contest contest = everyone.between(bots);
        failures.put(contest, new FailureCounts(contest));
        if (store != null) {
            stores.put(contest, store.between(contest));
        }
        return contest;
    }

    @Override
    public PairedPlay.Table at(int place) {
        return place < seeds.count() ? new PairedPlay.Table(seeds.at(place), contests.get(opponent(seeds.at(place))))
            : null;
    }

    @Override
    public PairedPlay.Outcome known(Contest contest, long seed, int rotation) {
        return store == null ? null : stores.get(contest).outcome(seed, rotation);
    }

    @Override
    public void keep(Contest contest, Series.Played game) {
        if (store != null) {
            stores.get(contest).add(game);
        }
    }

    @Override
    public FailureCounts failures(Contest contest) {
        return failures.get(contest);
    }

    /** Plays. @param watch over the programs: when one becomes another, the test ends */
    int play(int threads, ProgramWatch watch) throws InterruptedException {
        if (report == Verbosity.FULL) {
            streams.err().println(text.heading(contests.size()));
        }
        return SprtRun.isPlayed(new PairedPlay(this, Hiccups.REPLAY, watch, this::take), threads, streams, store,
            this::tell) ? end(watch.changed()) : ExitStatus.FAILED;
    }

    private int opponent(long seed) {
        return PoolScores.opponent(seed, contests.size());
    }

    private synchronized boolean take(PairedPlay.Seed seed) {
        int opponent = opponent(seed.seed());
        taken++;
        pool.add(opponent, seed);
        int first = 0;
        for (Contest contest : contests.get(opponent)) {
            int games = seed.games().length / 2;
            streaks.add(contest, new PairedPlay.Seed(seed.seed(), Arrays.copyOfRange(seed.games(), first,
                first + games)));
            first += games;
        }
        if (report == Verbosity.FULL && System.nanoTime() - told > TELL_NANOS) {
            told = System.nanoTime();
            streams.err().println(text.standing(pool));
        }
        return pool.state(test) == Gsprt.State.OPEN && pool.idleInARow() < MOST_IDLE
            && pool.repeatsInARow() < Repeats.ENOUGH && (ending.keepGoing() || streaks.failing() == null)
            && (pool.played() + 1) * pool.gamesOfSeed() <= ending.budget();
    }

    /** @param changed the file that made a program another one before the test was over, or {@code null} */
    private synchronized int end(String changed) {
        boolean isOpen = pool.state(test) == Gsprt.State.OPEN;
        boolean ended = changed != null && isOpen;
        if (!ended || store == null) {
            tell();
        }
        if (pool.idleInARow() >= MOST_IDLE) {
            return failed("the test ends: " + MOST_IDLE + " seeds in a row tell nothing: their games have no result, "
                + "or all bots failed at once");
        }
        if (ended) {
            return failed("the test ends undecided: " + TextFormat.plain(changed) + " has changed, and a verdict is of "
                + "one version of each bot" + (store == null ? "; with --into the games are kept, and the test begins "
                + "anew with the new one" : ""));
        }
        if (isOpen && !ending.keepGoing() && streaks.failing() != null) {
            return failed(streaks.ending("the test"));
        }
        if (pool.repeatsInARow() >= Repeats.ENOUGH) {
            streams.err().println("steward: the test ends undecided: the last " + Repeats.ENOUGH + " seeds repeat "
                + "games that were played before; with --random, for a bot that draws by lot, they count");
        } else if (isOpen && taken == seeds.count()) {
            streams.err().println("steward: the test ends undecided: all " + TextFormat.count(taken, "seed")
                + " of the list have been played, each against one opponent");
        }
        return ExitStatus.DONE;
    }

    private int failed(String why) {
        streams.err().println("steward: " + why);
        return ExitStatus.FAILED;
    }

    private synchronized void tell() {
        List<Contest> all = contests.stream().flatMap(List::stream).toList();
        switch (report) {
            case JSON -> Json.print(streams, text.fields(pool).with("failures",
                FailureReport.json(all.stream().flatMap(each -> kinds(each).stream()).toList())));
            case LINE -> streams.out().println(text.line(pool));
            default -> {
                text.lines(pool, streams.outColour()).forEach(streams.out()::println);
                all.forEach(each -> FailureReport.print(streams.out(), streams.outColour(), each, kinds(each)));
            }
        }
    }

    private List<FailureKind> kinds(Contest contest) {
        return failures.get(contest).kinds();
    }
}
