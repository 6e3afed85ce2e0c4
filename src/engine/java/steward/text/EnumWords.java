package steward.text;

import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Words for the constants of an enum, as calls and files have them: their names in lower case. */
public final class EnumWords {

    private EnumWords() { }

    /** Returns the words of these constants, in their order. */
    public static List<String> of(List<? extends Enum<?>> choices) {
        return choices.stream().map(each -> each.name().toLowerCase(Locale.ROOT)).toList();
    }

    /** Returns the constant with a word; empty for an unknown one. */
    public static <E extends Enum<E>> Optional<E> find(List<E> choices, String word) {
        int place = of(choices).indexOf(word);
        return place < 0 ? Optional.empty() : Optional.of(choices.get(place));
    }

    /** Lists two words or more for an error: {@code all, lost or none}. */
    public static String listed(List<? extends Enum<?>> choices) {
        List<String> words = of(choices);
        int last = words.size() - 1;
        return String.join(", ", words.subList(0, last)) + " or " + words.get(last);
    }
}
