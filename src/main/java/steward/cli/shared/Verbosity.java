package steward.cli.shared;

/** How much is said about matches. */
public enum Verbosity {
    /** What happens while it is watched, and all about the result. */
    FULL,
    /** The line of the result. */
    LINE,
    /** One JSON object. */
    JSON
}
