package steward.replay.verify;

import steward.replay.ReplayException;

/** Exception for a replay that was played by an older law of its rung: it can be watched, but not played again. */
public final class OlderLawException extends ReplayException {

    private final String laws;

    /**
     * @param recorded version of the law that the match was played by
     * @param current  version that this program plays
     */
    OlderLawException(String source, String rung, int recorded, int current) {
        super(source + ":1: law: found " + recorded + ", an older law of " + rung + ", expected " + current
            + ": the match cannot be played again");
        laws = "law " + recorded + " of " + rung + ", this version plays law " + current;
    }

    /** Both versions, for a person. */
    String laws() {
        return laws;
    }
}
