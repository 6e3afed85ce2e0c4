package steward.files;

import java.util.List;
import java.util.function.Supplier;
import steward.scene.json.SceneException;

/** Exception for a call or an input that cannot be used; the message says what was found and what was expected. */
public final class InputException extends RuntimeException implements Remedied {

    private final String parameter;
    private final transient List<Remedy> remedies;

    public InputException(String message) {
        this(message, List.of());
    }

    /** @param remedies options of a command that would help */
    public InputException(String message, List<Remedy> remedies) {
        super(message);
        parameter = null;
        this.remedies = List.copyOf(remedies);
    }

    /** A problem with a parameter, whose name begins the message; a command may have an option so called. */
    public InputException(String parameter, String problem) {
        super(parameter + ": " + problem);
        this.parameter = parameter;
        remedies = List.of();
    }

    /** Returns what is read; where a reader refuses it, that refusal is this. */
    public static <T> T of(Supplier<T> reader) {
        return of("", reader);
    }

    /** As above. @param before begins the message */
    public static <T> T of(String before, Supplier<T> reader) {
        try {
            return reader.get();
        } catch (IllegalArgumentException | SceneException refusal) {
            throw new InputException(before + refusal.getMessage());
        }
    }

    /** The parameter, or {@code null}. */
    public String parameter() {
        return parameter;
    }

    @Override
    public List<Remedy> remedies() {
        return remedies;
    }
}
