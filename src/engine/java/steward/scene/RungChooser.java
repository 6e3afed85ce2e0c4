package steward.scene;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import steward.physics.ImpactLaw;
import steward.scene.AccuracyFigures.OfRung;
import steward.scene.json.Block;
import steward.scene.json.Wording;

/**
 * Choice of a rung for a scene that states a demand, by the scene's figures, with the reason.
 *
 * @param without about figures that were passed over, for errors
 */
record RungChooser(AccuracyDemand demand, Block scene, AccuracyFigures found, String without) {

    /**
     * The rung for a scene that states a demand.
     *
     * @param scene   the whole file
     * @param figures where its own figures may be
     * @throws steward.scene.json.SceneException if there are no figures, if they belong to another scene or physics, or
     *                                           if no rung is known to meet the demand
     */
    static AccuracyChoice choose(AccuracyDemand demand, Block scene, ImpactLaw law, Optional<Path> figures) {
        if (demand.share() > AccuracyFigures.MOST_SHARE) {
            throw scene.block("accuracy").error("share", Wording.number(demand.share()), "at most "
                + AccuracyFigures.MOST_SHARE + ": what no state of a sample exceeds, others may");
        }
        AccuracyFigures all = AccuracyFigures.find(scene, figures);
        AccuracyFigures found = all.holding(AccuracyFigures.mayRest(law, scene.json()));
        if (found.rungs().isEmpty()) {
            throw AccuracyFigures.unusable(scene, "figures in " + found.source()
                + " that another version of the physics has measured", figures, true);
        }
        if (demand.maxNanos() < Double.POSITIVE_INFINITY && Double.isNaN(found.unitNanos())) {
            throw AccuracyFigures.unusable(scene, "a cost in time and figures in " + found.source()
                + " that have none", figures, true);
        }
        return new RungChooser(demand, scene, found, found.rungs().size() == all.rungs().size() ? ""
            : ", without those whose law has changed since").choose();
    }

    private AccuracyChoice choose() {
        OfRung best = found.best(demand.share());
        if (best.error(demand.share()) == Double.POSITIVE_INFINITY) {
            throw scene.block("accuracy").error("share", Wording.number(demand.share()), "a smaller one: nothing is "
                + "known of this share from " + found.states() + " states (" + found.source() + ")");
        }
        OfRung rung = found.cheapest(demand).orElseThrow(() -> demand.hasCost() ? outOfBudget() : outOfReach(best));
        List<OfRung> meeting = found.meeting(demand);
        String how = !demand.hasError() ? "the most accurate that costs " + demand.costText()
            : meeting.get(0) == rung ? "the cheapest that is off by " + demand.text()
            : "the most accurate of those within 5% of the cheapest that are off by " + demand.text();
        return new AccuracyChoice(rung.rung(), false, how + ": by " + Wording.number(rung.error(demand.share()))
            + " u, shown by " + found.states() + " (" + found.source() + "), at " + cost(rung)
            + " times the cost of event/double", meeting.stream().map(this::line).toList());
    }

    private RuntimeException outOfReach(OfRung best) {
        return scene.block("accuracy").error("maxPositionError", Wording.number(demand.maxPositionError())
            + ", which no rung meets", "at least " + Wording.number(best.error(demand.share()))
            + ", the error of the best one, " + best.rung().text() + ", in " + AccuracyDemand.percent(demand.share())
            + " of states, shown by " + found.states() + " (" + found.source() + without + "); the best are: "
            + front());
    }

    private RuntimeException outOfBudget() {
        return scene.block("accuracy").error("maxCost", demand.costText() + ", for which no rung meets the demand",
            "one that some rung meets; in " + AccuracyDemand.percent(demand.share()) + " of states (" + found.source()
                + without + ") the best are: " + front());
    }

    private String front() {
        return found.front(demand.share()).stream().map(this::line).collect(Collectors.joining("; "));
    }

    private String line(OfRung rung) {
        double error = rung.error(demand.share());
        return rung.rung().text() + " at " + cost(rung) + ", off by "
            + (error == Double.POSITIVE_INFINITY ? "an unknown length" : Wording.number(error) + " u");
    }

    private static String cost(OfRung rung) {
        return String.format(Locale.ROOT, rung.cost() < 1 ? "%.3f" : "%.2f", rung.cost());
    }
}
