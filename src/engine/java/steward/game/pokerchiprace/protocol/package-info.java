/**
 * Protocol of the Poker Chip Race: JSON frames and answers, the site's lines, replays and drawing. Other packages see
 * the game as {@link steward.game.pokerchiprace.protocol.PokerChipRaceType}.
 */
package steward.game.pokerchiprace.protocol;
