/**
 * Small, exact numeric tools that all other packages rely on. They are the random numbers of a match, the hash of a
 * state, correctly rounded sine and cosine, and arithmetic beyond doubles (errors of sums and products, double-doubles,
 * exact sums). This package knows nothing else of Steward.
 */
package steward.numerics;
