/**
 * Formatting for people, the same in every locale. It finds the nearest known word to a misspelt one, and writes
 * columns, counts and units, rows of CSV tables, and safe output to a terminal. No files.
 */
package steward.text;
