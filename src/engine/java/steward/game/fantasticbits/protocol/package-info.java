/**
 * Protocol of Fantastic Bits: JSON frames and answers, the site's lines, replays and drawing. Other packages see the
 * game as {@link steward.game.fantasticbits.protocol.FantasticBitsType}.
 */
package steward.game.fantasticbits.protocol;
