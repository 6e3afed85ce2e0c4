/**
 * Rules of the Poker Chip Race, free of JSON, and the published referee's own expressions for its motion. Two to four
 * players have chips that grow by eating smaller ones and move by ejecting a part of themselves ({@link
 * steward.game.pokerchiprace.OfficialPokerChipRace}).
 */
package steward.game.pokerchiprace;
