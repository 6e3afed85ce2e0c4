/** The bundled bots of the search race; programs of their own, which know nothing but the frames that they read. */
package steward.bots.searchrace;
