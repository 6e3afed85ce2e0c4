/** Protocol of Mean Max: JSON frames and answers, the site's lines, replays and drawing. */
package steward.game.meanmax.protocol;
