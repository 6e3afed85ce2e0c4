/**
 * Protocol of Fantastic Bits: JSON frames and answers, the site's lines; replays and drawing; and {@link
 * steward.game.fantasticbits.protocol.FantasticBitsType}, the game as the other rooms see it.
 */
package steward.game.fantasticbits.protocol;
