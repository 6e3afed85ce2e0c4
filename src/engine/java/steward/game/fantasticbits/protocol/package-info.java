/** Protocol of Fantastic Bits: JSON frames and answers, the site's lines, replays and drawing. */
package steward.game.fantasticbits.protocol;
