package steward.cli.play;

import java.util.Arrays;
import java.util.Iterator;
import java.util.Optional;
import picocli.CommandLine.Option;
import steward.cli.options.CallCheck;
import steward.cli.shared.Streams;
import steward.contest.Keep;

/** The options of many matches. */
final class SeriesOptions {

    /** What {@code --keep} takes. */
    static final class Keeps implements Iterable<String> {

        @Override
        public Iterator<String> iterator() {
            return Arrays.stream(Keep.values()).map(Keep::word).iterator();
        }
    }

    private static final String AUTO = "auto";

    private final CallCheck check = CallCheck.withHelp();

    @Option(names = "--games", paramLabel = "N",
        description = "Plays N games with the seeds SEED, SEED + 1, ... and prints who scored how many points.")
    private Integer games;

    @Option(names = "--swap",
        description = "Plays each seed once for every way to move the bots up: with two bots, once from each side, "
            + "2 N games in all.")
    private boolean swap;

    @Option(names = "--threads", paramLabel = "T|auto",
        description = "Plays so many games at the same time (default: 1); auto: as many as there are processors, less "
            + "one. The games do not depend on it, but bots that share processors take longer to answer.")
    private String threads;

    @Option(names = "--keep", paramLabel = "all|lost|failed|none", completionCandidates = Keeps.class,
        description = "Keeps, of the replays in --out, all (the default), those of games that the first bot lost "
            + "(lost), in which a bot failed or that have no result (failed), or none.")
    private String keep;

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
        check.that(keep == null || Keep.of(keep).isPresent(),
            "--keep: found '" + keep + "', expected all, lost, failed or none");
        check.that(keep == null || out, "--keep: expected --out with it");
    }

    /** What does not apply where each bot plays alone, or {@code null}. */
    String problemAlone() {
        return swap ? "--swap: the scene is for one player, and each bot plays alone: there are no sides to change"
            : keep().equals(Keep.LOST) ? "--keep lost: the scene is for one player, and a game alone has no loser, "
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

    Keep keep() {
        return Optional.ofNullable(keep).flatMap(Keep::of).orElse(Keep.ALL);
    }

    /** How many games at the same time; says so if these processors will not carry them. */
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

    /** A game keeps one processor busy, since bots are asked in turns; one is left for all else there is to do. */
    static int auto(int processors) {
        return Math.max(1, Math.min(processors - 1, CallCheck.MOST_THREADS));
    }
}
