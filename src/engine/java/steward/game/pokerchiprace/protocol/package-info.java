/**
 * What bots of the Poker Chip Race read and write: JSON frames and answers, the site's lines; what a replay keeps and
 * draws; and {@link steward.game.pokerchiprace.protocol.PokerChipRaceType}, the game as the other rooms see it.
 */
@Internal
package steward.game.pokerchiprace.protocol;

import steward.Internal;
