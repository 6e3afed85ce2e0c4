/**
 * Measures what ratings, tests and pairings promise: plays leagues between made-up bots whose strengths are known, and
 * counts how often the truth was where it was said to be.
 */
package steward.lab.statistics;
