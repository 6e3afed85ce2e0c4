package steward.cli.shared;

/** How much is printed about matches. */
public enum Verbosity {
    /** What happens during a match on a terminal, and the whole result. */
    FULL,
    /** One line with the result. */
    LINE,
    /** One JSON object. */
    JSON
}
