/**
 * What bots of Fantastic Bits read and write: JSON frames and answers, the site's lines; what a replay keeps and draws;
 * and {@link steward.game.fantasticbits.protocol.FantasticBitsType}, the game as the other rooms see it.
 */
@Internal
package steward.game.fantasticbits.protocol;

import steward.Internal;
