package steward.cli.shared;

/** Amount of output about matches. */
public enum Verbosity {
    /** Events during a match on a terminal, and the whole result. */
    FULL,
    /** One line with the result. */
    LINE,
    /** One JSON object. */
    JSON
}
