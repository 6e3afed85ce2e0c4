package steward.scene;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import steward.physics.ImpactLaw;
import steward.scene.json.Block;
import steward.scene.json.JsonTree;
import steward.scene.json.SceneException;

/**
 * Measured position errors and cost of each rung in the states of a scene's calibration. They are read from JSON, to
 * find the rung that meets a demand. Figures belong to a scene by its {@link SceneKey}, and the figures of each rung to
 * its {@link RungLaw} by the {@link PhysicsFingerprint}; figures of a law that has changed since are ignored.
 *
 * <p>The figures of shipped scenes are resources of the program; those of another scene are beside the scene file: for
 * {@code my.json} in {@code my.accuracy.json}.
 *
 * @param source    where the figures were read, for people
 * @param key       of the scene that was measured
 * @param sample    a hash of the results of the first states
 * @param unitNanos time of a turn on {@code event/double}, in nanoseconds; NaN in files that do not say it
 * @param rungs     the figures, cheapest rung first
 */
public record AccuracyFigures(String source, String key, String sample, int states, double unitNanos,
                              List<OfRung> rungs) {

    public static final int FORMAT = 2;
    /**
     * The shares of states for which an error is kept, as fields are named; a demand for a share between two of them is
     * compared with the next higher one.
     */
    public static final List<String> SHARES = List.of("0.5", "0.9", "0.99", "0.999", "0.9999");
    /** The highest of them: no demand may go beyond it. */
    static final double MOST_SHARE = 0.9999;
    /**
     * A rung that costs less than another by no more than this share does not count as cheaper: measurements of the
     * same rung differ by as much.
     */
    public static final double SAME_COST = 0.05;
    /** No figure: there are too few states for this share, or too many runs did not finish (the rung's or oracle's). */
    public static final String UNKNOWN = "unknown";

    /** Name of the file in errors. */
    private static final String WHAT = "the figures of a scene's accuracy";
    private static final String PHYSICS = "physics";
    private static final String SUFFIX = ".json";
    private static final String FIGURES = ".accuracy.json";

    /**
     * Figures of one rung.
     *
     * @param rung    on the ladder
     * @param physics the fingerprint of the law that was measured
     * @param cost    time of a turn, as a multiple of that on {@code event/double}
     * @param work    pair tests and impacts, counted per turn
     * @param errors  in u, for each of {@link #SHARES}: shown with 99% confidence that this share of all states of
     *                seeded play does not exceed it
     * @param largest of all errors that were seen, in u
     */
    public record OfRung(Accuracy rung, String physics, double cost, double work, List<Double> errors, double largest) {

        /** The error at a share up to {@link #MOST_SHARE}, or at the next higher one that is kept. */
        public double error(double share) {
            int k = 0;
            while (Double.parseDouble(SHARES.get(k)) < share) {
                k++;
            }
            return errors.get(k);
        }
    }

    public static Path beside(Path scene) {
        String name = scene.getFileName().toString();
        String base = name.endsWith(SUFFIX) ? name.substring(0, name.length() - SUFFIX.length()) : name;
        return scene.resolveSibling(base + FIGURES);
    }

    public static String resource(String shipped) {
        return "/scenes/" + shipped + FIGURES;
    }

    /**
     * @param text   the file
     * @param source names it in errors
     * @throws SceneException if it does not hold such figures, or is of another format
     */
    public static AccuracyFigures read(String text, String source) {
        Block root = new Block(source, "", JsonTree.read(text, source, WHAT));
        int format = root.integer("format", 0, Integer.MAX_VALUE);
        if (format != FORMAT) {
            throw root.error("format", Integer.toString(format), FORMAT + (format < FORMAT
                ? "; figures of an earlier version have no costs: steward tradeoff --calibrate SCENE --overwrite makes "
                    + "them anew" : ", the one that this version reads"));
        }
        List<OfRung> rungs = new ArrayList<>();
        String all = root.has(PHYSICS) ? root.text(PHYSICS) : null;
        for (Block rung : root.blocks("rungs")) {
            rungs.add(ofRung(rung, all));
        }
        if (rungs.isEmpty()) {
            throw root.error("rungs", "none", "at least one");
        }
        rungs.sort(Comparator.comparingDouble(OfRung::cost));
        return new AccuracyFigures(source, root.text("key"), root.text("sample"),
            root.integer("states", 1, Integer.MAX_VALUE),
            root.number("unitNanos", 0, Double.POSITIVE_INFINITY, Double.NaN), List.copyOf(rungs));
    }

    /** @param physics of all rungs, in a file of before laws had versions; otherwise {@code null} */
    private static OfRung ofRung(Block block, String physics) {
        Block errors = block.block("positionErrors");
        List<Double> values = new ArrayList<>();
        for (String share : SHARES) {
            double least = values.isEmpty() ? 0 : values.get(values.size() - 1);
            values.add(errorOrUnknown(errors, share, least));
        }
        try {
            return new OfRung(Accuracy.parse(block.text("rung")),
                physics == null ? block.text(PHYSICS) : physics,
                block.number("cost", 0, Double.POSITIVE_INFINITY), block.number("work", 0, Double.POSITIVE_INFINITY),
                List.copyOf(values), errorOrUnknown(block, "largestError", 0));
        } catch (IllegalArgumentException problem) {
            throw block.error("rung", block.shown("rung"), "a rung of the ladder");
        }
    }

    private static double errorOrUnknown(Block block, String field, double least) {
        boolean unknown = block.isText(field) && block.choice(field, Map.of(UNKNOWN, true));
        return unknown ? Double.POSITIVE_INFINITY : block.number(field, least, Double.POSITIVE_INFINITY);
    }

    /**
     * The rung that a demand takes, if one meets it. With an error demanded it is the cheapest; of several that cost
     * the same within {@link #SAME_COST}, the most accurate. So no other rung beats it in both cost and error. With a
     * cost alone it is the most accurate, the cheapest of those.
     */
    public Optional<OfRung> cheapest(AccuracyDemand demand) {
        List<OfRung> meeting = meeting(demand);
        double most = demand.hasError() && !meeting.isEmpty() ? meeting.get(0).cost * (1 + SAME_COST)
            : Double.POSITIVE_INFINITY;
        return meeting.stream().filter(rung -> rung.cost <= most)
            .min(Comparator.comparingDouble(rung -> rung.error(demand.share())));
    }

    /** The rungs that meet a demand, cheapest first. */
    List<OfRung> meeting(AccuracyDemand demand) {
        double most = demand.maxNanos() < Double.POSITIVE_INFINITY ? demand.maxNanos() / unitNanos : demand.maxCost();
        return rungs.stream().filter(rung -> rung.error(demand.share()) <= demand.maxPositionError()
            && rung.cost <= most).toList();
    }

    /** The rungs that no other beats in both cost and error at a share, cheapest first. */
    List<OfRung> front(double share) {
        List<OfRung> front = new ArrayList<>();
        for (OfRung rung : rungs) {
            if (front.isEmpty() || rung.error(share) < front.get(front.size() - 1).error(share)) {
                front.add(rung);
            }
        }
        return front;
    }

    /** The rung with the smallest error at a share; of several, the cheapest. */
    OfRung best(double share) {
        return rungs.stream().min(Comparator.comparingDouble(rung -> rung.error(share))).get();
    }

    /** True if bodies may come to rest: nothing drives them apart, and the scene states a restitution somewhere. */
    public static boolean mayRest(ImpactLaw law, String scene) {
        return !(law.minimumImpulse() > 0) && scene.contains("\"restitution\"");
    }

    /**
     * The figures of the rungs whose law is still the one that was measured.
     *
     * @param mayRest whether bodies of the scene {@linkplain #mayRest may come to rest}
     */
    public AccuracyFigures holding(boolean mayRest) {
        Map<RungLaw, String> computed = new EnumMap<>(RungLaw.class);
        return new AccuracyFigures(source, key, sample, states, unitNanos, rungs.stream().filter(each ->
            RungLaw.holds(each.physics, each.rung, mayRest,
                law -> computed.computeIfAbsent(law, PhysicsFingerprint::of))).toList());
    }

    /** Figures with the scene's key: those beside the scene file, else those of a shipped scene with the same key. */
    static AccuracyFigures find(Block scene, Optional<Path> figures) {
        String key = SceneKey.of(scene);
        Optional<AccuracyFigures> own = figures.filter(Files::exists).map(AccuracyFigures::load);
        if (own.isPresent() && own.get().key.equals(key)) {
            return own.get();
        }
        for (String shipped : SceneFiles.shipped()) {
            Optional<AccuracyFigures> figuresOfShipped = loadShipped(shipped).filter(each -> each.key.equals(key));
            if (figuresOfShipped.isPresent()) {
                return figuresOfShipped.get();
            }
        }
        throw unusable(scene, own.isPresent()
            ? "figures in " + own.get().source + " of a scene that says something else" : "a demand without figures",
            figures, own.isPresent());
    }

    static SceneException unusable(Block scene, String found, Optional<Path> figures, boolean exist) {
        return scene.error("accuracy", found, "those of a calibration: steward tradeoff --calibrate "
            + (figures.isEmpty() ? "SCENE" : scene.source()) + (exist ? " --overwrite" : ""));
    }

    private static AccuracyFigures load(Path file) {
        try {
            if (Files.isDirectory(file)) {
                throw new SceneException(file + ": found a folder, expected " + WHAT);
            }
            return read(SceneFiles.decode(SceneFiles.bytes(file, file.toString(), WHAT), file.toString()),
                file.toString());
        } catch (IOException problem) {
            String why = problem instanceof AccessDeniedException ? "no permission" : problem.getMessage();
            throw new SceneException(file + ": found a file that cannot be read (" + why + "), expected " + WHAT);
        }
    }

    /** The figures of a shipped scene, if it has been calibrated. */
    static Optional<AccuracyFigures> loadShipped(String shipped) {
        try (InputStream in = AccuracyFigures.class.getResourceAsStream(resource(shipped))) {
            String source = resource(shipped).substring(1);
            return in == null ? Optional.empty()
                : Optional.of(read(SceneFiles.decode(in.readAllBytes(), source), source));
        } catch (IOException problem) {
            throw new SceneException(shipped + ": found damaged figures (" + problem.getMessage()
                + "), expected the program to be whole");
        }
    }
}
