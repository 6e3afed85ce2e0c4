package steward.numerics;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Collectors;
import steward.Internal;

/**
 * Where a game's sines and cosines come from. A replay names them in its header, because a match can be played again to
 * the last bit only with the same ones.
 */
@Internal
public enum Angles {
    /** {@link SineCosine}: each the double that is nearest to the true value. */
    CORRECTLY_ROUNDED("correctly-rounded"),
    /**
     * {@link StrictAngles}, those of {@link StrictMath}, which is specified by fdlibm 5.3: what replays of formats 1
     * and 2 were made with. A game may give them the former rules of that time too.
     */
    FDLIBM("fdlibm");

    /** What matches are played with. */
    public static final Angles CURRENT = CORRECTLY_ROUNDED;

    private final String word;

    Angles(String word) {
        this.word = word;
    }

    /** As it is written in a replay. */
    public String word() {
        return word;
    }

    /** The angles that a word names, if there are any. */
    public static Optional<Angles> of(String word) {
        return Arrays.stream(values()).filter(angles -> angles.word.equals(word)).findFirst();
    }

    /** All words, for errors. */
    public static String words() {
        return Arrays.stream(values()).map(Angles::word).collect(Collectors.joining(" or "));
    }
}
