/** Whole matches and crowds, measured; with plain ways of doing the same to measure against. */
package steward.bench;
