package steward.cli.play;

import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Option;
import steward.cli.options.CallCheck;
import steward.cli.shared.Streams;
import steward.contest.Hiccups;
import steward.contest.KeptReplays;
import steward.text.NearestName;

/** The options of many matches. */
final class SeriesOptions {

    /** What {@code --keep} takes. */
    static final class Keeps implements Iterable<String> {

        @Override
        public Iterator<String> iterator() {
            return KEEPS.iterator();
        }
    }

    /** What {@code --hiccups} takes. */
    static final class HiccupWords implements Iterable<String> {

        @Override
        public Iterator<String> iterator() {
            return Arrays.stream(Hiccups.values()).map(Hiccups::word).iterator();
        }
    }

    /** The word that {@code --threads} takes beside numbers. */
    static final class Auto implements Iterable<String> {

        @Override
        public Iterator<String> iterator() {
            return List.of(AUTO).iterator();
        }
    }

    private static final List<String> KEEPS = Arrays.stream(KeptReplays.values()).map(KeptReplays::word).toList();
    private static final String AUTO = "auto";

    private final CallCheck check = CallCheck.withHelp();

    @Option(names = "--games", paramLabel = "N",
        description = "Plays N games with the seeds SEED, SEED + 1, ... and prints who scored how many points.")
    private Integer games;

    @Option(names = "--swap",
        description = "Plays each seed once for every way to move the bots up: with two bots, once from each side, "
            + "2 N games in all.")
    private boolean swap;

    @Option(names = "--threads", paramLabel = "T|auto", completionCandidates = Auto.class,
        description = "Plays so many games at the same time (default: 1); auto: as many as there are processors, less "
            + "one. The games do not depend on it, but bots that share processors take longer to answer.")
    private String threads;

    @Option(names = "--keep", paramLabel = "all|lost|failed|none", completionCandidates = Keeps.class,
        description = "Keeps, of the replays in --out, all (the default), those of games that the first bot lost "
            + "(lost), in which a bot failed or that have no result (failed), or none.")
    private String keep;

    @Option(names = "--hiccups", paramLabel = "replay|count", completionCandidates = HiccupWords.class,
        description = "What becomes of a game that a bot lost on time while it waited half of its limit for a "
            + "processor that other programs used: it is played again, once, with the same seed (replay, the default), "
            + "or it counts (count).")
    private String hiccups;

    /**
     * Refuses options that are out of range or do not go together.
     *
     * @param out whether {@code --out} is there
     */
    void check(boolean out) {
        check.games(games);
        check.that(threads == null || threads(1) > 0,
            "--threads: found '" + threads + "', expected 1 to " + CallCheck.MOST_THREADS + ", or auto");
        check.that(isAny() || threads == null, "--threads is for many games, expected --games or --swap with it");
        check.that(isAny() || keep == null, "--keep is for many games, expected --games or --swap with it");
        check.that(isAny() || hiccups == null, "--hiccups is for many games, expected --games or --swap with it");
        check.that(hiccups == null || Hiccups.of(hiccups).isPresent(),
            "--hiccups: found '" + hiccups + "', expected replay or count");
        check.that(keep == null || KeptReplays.of(keep).isPresent(),
            "--keep: found '" + keep + "', expected all, lost, failed or none"
                + (keep == null ? "" : NearestName.question(keep, KEEPS, "'")));
        check.that(keep == null || out, "--keep: expected --out with it");
    }

    /** What does not apply where each bot plays alone, or {@code null}. */
    String problemAlone() {
        return swap ? "--swap: the scene is for one player, and each bot plays alone: there are no sides to change"
            : keep().equals(KeptReplays.LOST) ? "--keep lost: the scene is for one player, and a game alone has no "
                + "loser, "
                + "expected all, failed or none" : null;
    }

    /** Whether there is to be more than one match. */
    boolean isAny() {
        return games != null || swap;
    }

    /** How many seeds. */
    int games() {
        return games == null ? 1 : games;
    }

    boolean swap() {
        return swap;
    }

    KeptReplays keep() {
        return Optional.ofNullable(keep).flatMap(KeptReplays::of).orElse(KeptReplays.ALL);
    }

    Hiccups hiccups() {
        return Optional.ofNullable(hiccups).flatMap(Hiccups::of).orElse(Hiccups.REPLAY);
    }

    /** How many games at the same time; warns if there are too few processors for them. */
    int threads(Streams streams) {
        int processors = Runtime.getRuntime().availableProcessors();
        int count = threads(processors);
        if (count > processors) {
            streams.warn("--threads " + count + " are more games at a time than the " + processors
                + " processors here carry: bots will take longer to answer, perhaps too long; --threads auto takes "
                + auto(processors));
        }
        return count;
    }

    /** -1 if it cannot be understood. */
    private int threads(int processors) {
        if (threads == null) {
            return 1;
        }
        if (threads.equals(AUTO)) {
            return auto(processors);
        }
        try {
            int count = Integer.parseInt(threads);
            return CallCheck.isWithin(count, 1, CallCheck.MOST_THREADS) ? count : -1;
        } catch (NumberFormatException problem) {
            return -1;
        }
    }

    /** A game keeps one processor busy, since bots are asked in turns; one is left for everything else. */
    static int auto(int processors) {
        return Math.max(1, Math.min(processors - 1, CallCheck.MOST_THREADS));
    }
}
