package steward.lab.trial;

import java.util.function.Supplier;

/** Told by a case that takes minutes, now and then and in its own thread, how far it is. */
@FunctionalInterface
public interface Progress {

    /** Nobody listens. */
    Progress NONE = (share, soFar) -> { };

    /**
     * So much is done.
     *
     * @param share of all the work, 0..1
     * @param soFar the figures, as they will stand in {@link Finding#text}; only to be asked within the call
     */
    void reached(double share, Supplier<String> soFar);
}
