package steward.cli.shared;

import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;
import picocli.CommandLine.TypeConversionException;
import steward.game.GameSetup;
import steward.scene.Accuracy;

/** The option that selects another rung of accuracy than the scene's. */
public final class AccuracyOption {

    @Option(names = "--accuracy", paramLabel = "RUNG", converter = Rung.class,
        description = "Compute the scene on this rung in place of its own: step/1 to step/1024, the cheapest first, or "
            + "official, double, compensated, exact (event/exact is the same). A replay holds it.")
    private Accuracy accuracy;

    /** Opens a scene by its path or shipped name, on the selected rung if there is one. */
    public GameSetup open(String scene) {
        return Games.open(scene, accuracy);
    }

    /** The option as it would be typed, with a blank before it; empty if it was not given. */
    public String words() {
        return accuracy == null ? "" : " --accuracy " + accuracy.text();
    }

    /** Converts the option's value to a rung. */
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
