/**
 * Protocol of Mean Max: JSON frames and answers, the site's lines; replays and drawing; and {@link
 * steward.game.meanmax.protocol.MeanMaxType}, the game as the other rooms see it.
 */
package steward.game.meanmax.protocol;
