/** The bundled bots of Mean Max; programs of their own, which know nothing but the frames that they read. */
package steward.bots.meanmax;
