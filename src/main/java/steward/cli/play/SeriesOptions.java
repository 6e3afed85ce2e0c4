package steward.cli.play;

import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import steward.cli.options.CallCheck;
import steward.cli.options.OptionSection;
import steward.cli.options.ThreadsOption;
import steward.cli.streams.Streams;
import steward.contest.Hiccups;
import steward.contest.KeptReplays;

/** Options of a series of matches. */
@OptionSection("Many games")
final class SeriesOptions {

    private final CallCheck check = CallCheck.withHelp();
    private boolean isListed;

    @Option(names = "--games", paramLabel = "N",
        description = "Plays N games with the seeds SEED, SEED + 1, ... and prints the points of each bot.")
    private Integer games;

    @Option(names = "--swap",
        description = "Plays each seed once for every rotation of the seats. Two bots play each seed from both "
            + "sides, 2 N games in all.")
    private boolean swap;

    @Mixin
    private final ThreadsOption threads = new ThreadsOption();

    @Option(names = "--keep", paramLabel = "all|lost|failed|none",
        description = "Which replays are kept in --out. all (default); lost: games that the first bot lost; "
            + "failed: games in which a bot failed or without a result; none.")
    private KeptReplays keep;

    @Option(names = "--why", description = "Also explains the games that the first bot lost: how they ended, from "
        + "which turn it was behind, and the worst of each kind. Compares its values in lost and won games.")
    private boolean why;

    @Option(names = "--hiccups", paramLabel = "replay|count",
        description = "How a game is treated that a bot lost on time while other programs kept it from a "
            + "processor for a tenth of its limit or more. replay (default): plays it again with the same seed, "
            + "without charging that waiting. count: counts it. Single games, too.")
    private Hiccups hiccups;

    @Option(names = "--random", description = "Says that a bot uses random numbers: equal games are independent, "
        + "and all count.")
    private boolean random;

    @Option(names = "--into", paramLabel = "DIR",
        description = "Stores the games in this league (see 'steward league'). A game that the league has already "
            + "stays unchanged.")
    private String into;

    /**
     * Refuses options that are out of range or do not go together.
     *
     * @param out    whether {@code --out} is there
     * @param listed whether there is a list of seeds: then there are many games
     */
    void check(boolean out, boolean listed) {
        isListed = listed;
        check.games(games);
        threads.check();
        check.that(isAny() || !threads.isGiven(), "--threads is for many games, expected --games or --swap with it");
        check.that(isAny() || into == null, "--into is for many games, expected --games or --swap with it");
        check.that(isAny() || !random, "--random is for many games, expected --games or --swap with it");
        check.that(isAny() || !why, "--why is for many games, expected --games or --swap with it");
        check.that(isAny() || keep == null, "--keep is for many games, expected --games or --swap with it");
        check.that(keep == null || out, "--keep: expected --out with it");
    }

    /** Returns the error of options that do not apply where each bot plays alone, or {@code null}. */
    String problemAlone() {
        return swap ? "--swap: the scene is for one player, and each bot plays alone: there are no sides to change"
            : why ? "--why: the scene is for one player, and a game alone has no loser"
            : keep().equals(KeptReplays.LOST) ? "--keep lost: the scene is for one player, and a game alone has no "
                + "loser, "
                + "expected all, failed or none" : null;
    }

    /** True if there is to be more than one match. */
    boolean isAny() {
        return games != null || swap || isListed;
    }

    /** True if it is said how many seeds. */
    boolean areCounted() {
        return games != null;
    }

    /** Returns how many seeds. */
    int games() {
        return games == null ? 1 : games;
    }

    /** True if a bot draws by lot. */
    boolean random() {
        return random;
    }

    /** True if it is to be said why the first bot lost. */
    boolean why() {
        return why;
    }

    boolean swap() {
        return swap;
    }

    /** The league as it was typed, or {@code null}. */
    String into() {
        return into;
    }

    KeptReplays keep() {
        return keep == null ? KeptReplays.ALL : keep;
    }

    Hiccups hiccups() {
        return hiccups == null ? Hiccups.REPLAY : hiccups;
    }

    /** Returns how many games at the same time; warns if there are too few processors for them. */
    int threads(Streams streams) {
        return threads.count(streams);
    }
}
