/**
 * Measures what ratings, tests and pairings promise: plays leagues between made-up bots whose strengths are known, and
 * counts how often the truth was where it was said to be.
 */
@Internal
package steward.lab.statistics;

import steward.Internal;
