/**
 * Protocol of the Poker Chip Race: JSON frames and answers, the site's lines; replays and drawing; and {@link
 * steward.game.pokerchiprace.protocol.PokerChipRaceType}, the game as the other rooms see it.
 */
package steward.game.pokerchiprace.protocol;
