package steward.cli.league;

import java.util.ArrayList;
import java.util.List;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import steward.cli.options.CallCheck;
import steward.cli.options.ThreadsOption;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Lab;
import steward.cli.streams.Streams;

/** {@code steward league --self-check}: what ratings and tests promise, measured on made-up leagues. */
final class SelfCheckOptions {

    /** The parts, in the order in which they are printed. */
    private static final List<String> PARTS = List.of("fixed", "exact", "pairings", "anytime", "rules", "sprt",
        "adaptive");

    /** Leagues of a configuration, if nothing else is said. */
    private static final long USUAL = 20_000;

    private static final long MOST_LEAGUES = 10_000_000;

    private final CallCheck check = CallCheck.withHelp();

    @Option(names = "--self-check", description = "Plays made-up leagues whose strengths are known, and prints how "
        + "often bars and tests held: the tables of docs/tables/rating.md. Takes an hour.")
    private boolean asked;

    @Option(names = "--leagues", paramLabel = "N",
        description = "With --self-check: leagues of each configuration (default: 20000).")
    private Long leagues;

    @Option(names = "--only", paramLabel = "PART", completionCandidates = Parts.class,
        description = "With --self-check: one of ${COMPLETION-CANDIDATES}; can be repeated (default: all).")
    private List<String> only = new ArrayList<>();

    @Mixin
    private final ThreadsOption threads = new ThreadsOption();

    /** Values of {@code --only}. */
    static final class Parts extends ArrayList<String> {

        Parts() {
            super(PARTS);
        }
    }

    boolean isAsked() {
        check.that(asked || leagues == null, "--leagues: expected --self-check with it");
        check.that(asked || only.isEmpty(), "--only: expected --self-check with it");
        check.that(asked || !threads.isGiven(), "--threads: expected --self-check with it, or a command that plays");
        return asked;
    }

    int run(Streams streams) throws InterruptedException {
        check.range("--leagues", leagues, 1, MOST_LEAGUES);
        threads.check();
        List<String> chosen = check.chosen("--only", only, PARTS, name -> name, ", ");
        Lab.of("--self-check").selfCheck(chosen, leagues == null ? USUAL : leagues, threads.count(streams), line -> {
            streams.out().println(line);
            streams.out().flush();
        });
        return ExitStatus.DONE;
    }
}
