package steward.lab.trial;

import java.util.function.Supplier;

/** Receiver of the progress of a case that takes minutes, called now and then on the case's own thread. */
@FunctionalInterface
public interface Progress {

    /** Ignores all progress. */
    Progress NONE = (share, soFar) -> { };

    /**
     * Reports progress.
     *
     * @param share of all the work, 0..1
     * @param soFar the figures, as they will stand in {@link Finding#text}; to be read only within the call
     */
    void reached(double share, Supplier<String> soFar);
}
