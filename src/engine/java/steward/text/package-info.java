/** Formatting for people, the same in every locale: names, columns, counts, tables, terminals. No files. */
package steward.text;
