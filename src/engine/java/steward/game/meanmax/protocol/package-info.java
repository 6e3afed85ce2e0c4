/**
 * What bots of Mean Max read and write: JSON frames and answers, the site's lines; what a replay keeps and draws; and
 * {@link steward.game.meanmax.protocol.MeanMaxType}, the game as the other rooms see it.
 */
@Internal
package steward.game.meanmax.protocol;

import steward.Internal;
