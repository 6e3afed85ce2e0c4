/**
 * The replay format: writing a match as it is played, and reading it back, also when it was cut off. It stores what the
 * game described and knows no particular game. Above it stand {@code verify}, {@code feed} and {@code page}.
 *
 * <p>A replay is JSON Lines, UTF-8: one {@code steward-replay} header, one {@code turn} line per turn, one
 * {@code result}. A turn keeps what went in (commands, faults, and their hash, because not every command leaves a
 * trace) and what came out (impacts, paths, state and its hash). Everything measured stands in the last field of a
 * line, {@code times}; without it two plays of the same game are equal byte for byte.
 */
package steward.replay;
