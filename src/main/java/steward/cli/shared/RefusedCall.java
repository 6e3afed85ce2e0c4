package steward.cli.shared;

import java.util.List;

/** A command whose caller reads the standard output also where the call is refused. */
public interface RefusedCall {

    /** Prints what that caller is to read. @param arguments of the call, also those that are not understood */
    void refuse(List<String> arguments);
}
