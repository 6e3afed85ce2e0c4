package steward.cli.sequential;

import java.util.Iterator;
import java.util.List;
import picocli.CommandLine.Option;
import steward.cli.options.CallCheck;
import steward.cli.options.OptionSection;
import steward.league.sequential.Gsprt;
import steward.text.NearestName;

/** Options of a sequential test. */
@OptionSection("The test")
public final class SprtOptions {

    /** Values of {@code --elo-model}. */
    static final class Models implements Iterable<String> {

        @Override
        public Iterator<String> iterator() {
            return MODELS.iterator();
        }
    }

    private static final List<String> MODELS = List.of("normalized", "logistic");
    private static final double MOST_ELO = 1000;
    private static final double HALF = 0.5;

    private final CallCheck check = CallCheck.withHelp();

    @Option(names = "--elo0", paramLabel = "X", defaultValue = "0",
        description = "What is accepted as not enough, H0 (default: ${DEFAULT-VALUE}).")
    private double elo0;

    @Option(names = "--elo1", paramLabel = "X", defaultValue = "10",
        description = "What is accepted as a gain, H1 (default: ${DEFAULT-VALUE}).")
    private double elo1;

    @Option(names = "--alpha", paramLabel = "P", defaultValue = "0.05",
        description = "How often H1 may be accepted where H0 is true (default: ${DEFAULT-VALUE}).")
    private double alpha;

    @Option(names = "--beta", paramLabel = "P", defaultValue = "0.05",
        description = "How often H0 may be accepted where H1 is true (default: ${DEFAULT-VALUE}).")
    private double beta;

    @Option(names = "--elo-model", paramLabel = "normalized|logistic", defaultValue = "normalized",
        completionCandidates = Models.class, description = "What Elo means: normalized (default), by the spread of the "
            + "scores of a game, 347 points for a standard deviation; or logistic, by the mean score.")
    private String model;

    @Option(names = "--games", paramLabel = "N",
        description = "Ends after N games without a decision; stored ones count too.")
    private Integer games;

    @Option(names = "--keep-going", description = "Goes on when a bot has failed in 10 games in a row.")
    private boolean keepGoing;

    @Option(names = "--random", description = "Says that a bot draws by lot: equal games are independent draws, and "
        + "count. In a league its mark says so, too.")
    private boolean random;

    /** Returns when the test ends without a decision. */
    public SprtRun.Ending ending() {
        return new SprtRun.Ending(games == null ? Long.MAX_VALUE : games, keepGoing, random);
    }

    /** Refuses what cannot be tested. */
    public Gsprt test() {
        check.that(Math.abs(elo0) <= MOST_ELO, "--elo0: found " + elo0 + ", expected -1000 to 1000");
        check.that(Math.abs(elo1) <= MOST_ELO, "--elo1: found " + elo1 + ", expected -1000 to 1000");
        check.that(elo0 < elo1, "--elo0: found " + elo0 + ", expected less than --elo1, which is " + elo1);
        check.that(alpha > 0 && alpha < HALF, "--alpha: found " + alpha + ", expected more than 0 and less than 0.5");
        check.that(beta > 0 && beta < HALF, "--beta: found " + beta + ", expected more than 0 and less than 0.5");
        check.that(MODELS.contains(model), "--elo-model: found '" + model + "', expected normalized or logistic"
            + NearestName.question(model, MODELS, "'"));
        check.games(games);
        return new Gsprt(elo0, elo1, alpha, beta,
            model.equals("logistic") ? Gsprt.Model.LOGISTIC : Gsprt.Model.NORMALIZED);
    }
}
