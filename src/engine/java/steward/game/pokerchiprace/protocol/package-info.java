/** Protocol of the Poker Chip Race: JSON frames and answers, the site's lines, replays and drawing. */
package steward.game.pokerchiprace.protocol;
