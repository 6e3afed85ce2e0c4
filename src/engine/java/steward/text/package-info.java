/**
 * Formatting for people: the nearest known word to a misspelt one, columns, counts and units, the same in every locale;
 * rows of tables for spreadsheets; what may reach a terminal. No files.
 */
package steward.text;
