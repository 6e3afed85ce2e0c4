/** The bundled bots of Fantastic Bits; programs of their own, which know nothing but the frames that they read. */
package steward.bots.fantasticbits;
