/** The bundled bots of the Poker Chip Race; programs of their own, which know nothing but the frames that they read. */
package steward.bots.pokerchiprace;
