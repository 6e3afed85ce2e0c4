package steward.cli.options;

import java.util.Iterator;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;
import picocli.CommandLine.TypeConversionException;
import steward.cli.shared.Games;
import steward.cli.streams.Streams;
import steward.game.GameSetup;
import steward.scene.Accuracy;

/** Option that replaces the scene's rung of accuracy by another. */
public final class AccuracyOption {

    @Option(names = "--accuracy", paramLabel = "RUNG", converter = Rung.class,
        completionCandidates = Rungs.class,
        description = "Computes the scene on this rung of accuracy instead of its own: step/1 (the cheapest) to "
            + "step/1024, or official, double, compensated, exact (or with event/ before it). A replay stores it.")
    private Accuracy accuracy;

    /** The rungs for completion: those with times of impact, and some of those with steps. */
    static final class Rungs implements Iterable<String> {

        @Override
        public Iterator<String> iterator() {
            return Accuracy.ladder().stream().map(rung -> rung.text().replaceFirst("^event/", "")).iterator();
        }
    }

    /**
     * Opens a scene by its path or shipped name, {@code -} from the standard input, on this rung if one is called
     * for.
     */
    public GameSetup open(String scene, Streams streams) {
        return Games.open(scene, accuracy, streams);
    }

    /** As it would be typed, with a blank before it; nothing where there is no such option. */
    public String words() {
        return accuracy == null ? "" : " --accuracy " + accuracy.text();
    }

    /** Reads a rung. */
    static final class Rung implements ITypeConverter<Accuracy> {

        @Override
        public Accuracy convert(String word) {
            try {
                return Accuracy.parse(word);
            } catch (IllegalArgumentException problem) {
                throw new TypeConversionException(problem.getMessage().replaceFirst("^accuracy: ", ""));
            }
        }
    }
}
