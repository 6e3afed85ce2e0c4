/**
 * Protocol of Mean Max: JSON frames and answers, the site's lines, replays and drawing. Other packages see the game as
 * {@link steward.game.meanmax.protocol.MeanMaxType}.
 */
package steward.game.meanmax.protocol;
