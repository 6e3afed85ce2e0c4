/**
 * The replay format: writing a match as it is played, and reading it back, also when it was cut off. It stores what the
 * game described and knows no particular game. Above it stand {@code verify}, {@code feed} and {@code page}.
 *
 * <p>A replay is JSON Lines, UTF-8: one {@code steward-replay} header, one {@code turn} line per turn, one
 * {@code result}, and one {@code signature} where the header names a signer. A turn keeps what went in (commands,
 * faults, messages, stderr) and what came out (impacts, paths, state and its hash). Everything measured stands in the
 * last field of a line, {@code times}; without it two plays of the same game are equal byte for byte. The field before
 * it is the hash of everything before that, which also covers what has no effect on the game.
 *
 * <p>The format is number 3. Its fields and their order are in {@link steward.replay.LineFields}, how lines are spelled
 * in {@link steward.replay.ReplayLines}, what is signed in {@link steward.replay.sign.LinesDigest}. What a game tells
 * of a turn, a start or an end is its own: it is written again and compared as a whole, so that a new game, zones that
 * come and go, scores and resources (see {@link steward.game.GameJson#writeProgress}) need no other format.
 */
package steward.replay;
