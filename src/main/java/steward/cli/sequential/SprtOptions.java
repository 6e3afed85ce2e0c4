package steward.cli.sequential;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import picocli.CommandLine.Option;
import steward.cli.options.CallCheck;
import steward.cli.options.OptionSection;
import steward.league.sequential.Gsprt;

/** Options of a sequential test. */
@OptionSection("The test")
public final class SprtOptions {

    private static final double MOST_ELO = 1000;
    private static final double HALF = 0.5;
    private static final double ELO = 10;
    /** Points a game, in Elo of even bots some 7: as much as a change of a good bot brings. */
    private static final double POINTS = 0.02;
    private static final double MOST_POINTS = 0.9;

    private final CallCheck check = CallCheck.withHelp();

    @Option(names = "--elo0", paramLabel = "X", description = "The Elo difference of H0, not enough to accept the "
        + "new bot (default: 0).")
    private Double elo0;

    @Option(names = "--elo1", paramLabel = "X", description = "The Elo difference of H1, a gain (default: 10).")
    private Double elo1;

    @Option(names = "--pool", paramLabel = "DIR|NAMES", description = "Lets both bots meet the same opponents "
        + "instead of each other: bots of a league, programs of a folder, or bots separated by commas.")
    private String pool;

    @Option(names = "--points0", paramLabel = "P", description = "With --pool: the difference of points a game of "
        + "H0 (default: 0).")
    private Double points0;

    @Option(names = "--points1", paramLabel = "P", description = "With --pool: the difference of points a game of "
        + "H1 (default: 0.02).")
    private Double points1;

    @Option(names = "--alpha", paramLabel = "P", defaultValue = "0.05",
        description = "The probability of accepting H1 if H0 is true (default: ${DEFAULT-VALUE}).")
    private double alpha;

    @Option(names = "--beta", paramLabel = "P", defaultValue = "0.05",
        description = "The probability of accepting H0 if H1 is true (default: ${DEFAULT-VALUE}).")
    private double beta;

    @Option(names = "--elo-model", paramLabel = "normalized|logistic", description = "The meaning of Elo. "
            + "normalized (default): by the spread of the scores of a game, 347 points for a standard deviation. "
            + "logistic: by the mean score.")
    private Gsprt.Model model;

    @Option(names = "--games", paramLabel = "N",
        description = "Ends after N games without a decision, stored games included.")
    private Integer games;

    @Option(names = "--keep-going", description = "Goes on when a bot has failed in 10 games in a row.")
    private boolean keepGoing;

    @Option(names = "--random", description = "Says that a bot uses random numbers: equal games are independent, "
        + "and all count. In a league, the bot's mark \"random\" says so, too.")
    private boolean random;

    /** Returns when the test ends without a decision. */
    public SprtRun.Ending ending() {
        return new SprtRun.Ending(games == null ? Long.MAX_VALUE : games, keepGoing, random);
    }

    /** The opponents as they were typed, or {@code null}. */
    String pool() {
        return pool;
    }

    double points0() {
        return points0 == null ? 0 : points0;
    }

    double points1() {
        return points1 == null ? POINTS : points1;
    }

    /** Refuses what cannot be tested; a test against a pool is one of mean scores. */
    public Gsprt test() {
        check.that(pool != null || points0 == null && points1 == null, "--points0 and --points1 are for --pool, "
            + "expected it with them");
        check.that(pool == null || elo0 == null && elo1 == null && model == null, "--elo0, --elo1 and --elo-model are "
            + "for two bots that meet, expected --points0 and --points1 with --pool");
        check.that(alpha > 0 && alpha < HALF, "--alpha: found " + alpha + ", expected more than 0 and less than 0.5");
        check.that(beta > 0 && beta < HALF, "--beta: found " + beta + ", expected more than 0 and less than 0.5");
        check.games(games);
        return pool == null ? testOfElo(elo0 == null ? 0 : elo0, elo1 == null ? ELO : elo1) : testOfPoints();
    }

    private Gsprt testOfPoints() {
        check.that(Math.abs(points0()) <= MOST_POINTS, "--points0: found " + points0() + ", expected -0.9 to 0.9");
        check.that(Math.abs(points1()) <= MOST_POINTS, "--points1: found " + points1() + ", expected -0.9 to 0.9");
        check.that(points0() < points1(), "--points0: found " + points0() + ", expected less than --points1, which is "
            + points1());
        return Gsprt.ofScores((1 + points0()) / 2, (1 + points1()) / 2, alpha, beta);
    }

    private Gsprt testOfElo(double elo0, double elo1) {
        check.that(Math.abs(elo0) <= MOST_ELO, "--elo0: found " + elo0 + ", expected -1000 to 1000");
        check.that(Math.abs(elo1) <= MOST_ELO, "--elo1: found " + elo1 + ", expected -1000 to 1000");
        check.that(elo0 < elo1, "--elo0: found " + elo0 + ", expected less than --elo1, which is " + elo1);
        return new Gsprt(elo0, elo1, alpha, beta, model == null ? Gsprt.Model.NORMALIZED : model);
    }

    /** Two bots, and another on all other seats. @param which what is done with the two */
    public static List<String> withFill(CallCheck check, List<String> bots, String fill, int players,
                                        String which) {
        check.that(fill == null || players > 2, "--fill is for scenes of three and more players, found one of "
            + players);
        check.that(fill != null || players <= 2, "found no --fill, expected one: the scene is for " + players
            + " players, and two " + which);
        List<String> all = new ArrayList<>(bots);
        all.addAll(Collections.nCopies(Math.max(0, players - 2), fill));
        return all;
    }
}
