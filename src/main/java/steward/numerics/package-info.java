/**
 * Small, static, exact things that everything above relies on: the random numbers of a match and the hash of a
 * state. This room knows nothing else of Steward.
 */
package steward.numerics;
