/**
 * Formatting for people: the nearest known word to a misspelt one, columns, counts and units, the same in every locale;
 * rows of tables for spreadsheets. No files, no terminals.
 */
@Internal
package steward.text;

import steward.Internal;
