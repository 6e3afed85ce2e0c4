package steward.replay;

import java.util.List;
import steward.files.Remedied;

/**
 * Exception for a file that cannot be used as a replay; the message says where, what was found and what was expected.
 */
public class ReplayException extends RuntimeException implements Remedied {

    private final transient List<Remedy> remedies;

    public ReplayException(String message) {
        this(message, List.of());
    }

    /** @param remedies options of a command that would help */
    public ReplayException(String message, List<Remedy> remedies) {
        super(message);
        this.remedies = List.copyOf(remedies);
    }

    @Override
    public List<Remedy> remedies() {
        return remedies;
    }
}
