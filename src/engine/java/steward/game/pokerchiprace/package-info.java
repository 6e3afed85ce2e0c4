/**
 * The rules of the Poker Chip Race, free of JSON: two to four players whose chips grow by eating smaller ones and move
 * by ejecting a part of themselves; and the published referee's own expressions for their motion
 * ({@link steward.game.pokerchiprace.OfficialPokerChipRace}).
 */
package steward.game.pokerchiprace;
