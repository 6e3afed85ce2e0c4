package steward.files;

import java.util.List;

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

    /** The parameter, or {@code null}. */
    public String parameter() {
        return parameter;
    }

    @Override
    public List<Remedy> remedies() {
        return remedies;
    }
}
