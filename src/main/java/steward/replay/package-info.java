/**
 * The replay format: writing a match as it is played, and reading it back, also if it was cut off. It stores the game's
 * own description and knows no particular game. {@code verify}, {@code feed} and {@code page} are built on it.
 *
 * <p>A replay is JSON Lines, UTF-8: one {@code steward-replay} header, one {@code turn} line per turn, one {@code
 * result}, and one {@code signature} if the header names a signer. A turn keeps inputs (commands, faults, messages,
 * stderr) and outcomes (impacts, paths, state and its hash). Everything measured is in the last field of a line, {@code
 * times}; without it two plays of the same game are equal byte for byte. The field before it is the hash of everything
 * before, including fields that have no effect on the game.
 *
 * <p>The format is number 3. Its fields and their order are in {@link steward.replay.LineFields}, the spelling of lines
 * in {@link steward.replay.ReplayLines}, the signed part in {@link steward.replay.sign.LinesDigest}. Each game has
 * fields of its own for a turn, a start and an end. They are written again and compared as a whole, so that a new game,
 * zones that come and go, scores and resources (see {@link steward.game.GameJson#writeProgress}) need no other format.
 */
package steward.replay;
