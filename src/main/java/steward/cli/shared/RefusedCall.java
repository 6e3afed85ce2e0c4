package steward.cli.shared;

import java.util.List;

/**
 * Interface of a command that prints to the standard output even if its call is refused, since its caller reads that.
 */
public interface RefusedCall {

    /** Prints what that caller is to read. @param arguments of the call, also those that are not understood */
    void refuse(List<String> arguments);
}
