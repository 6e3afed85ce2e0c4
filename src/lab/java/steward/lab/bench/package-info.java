/**
 * Measurement of whole matches and crowds: sections of contenders, rows of results, and the files and page that store
 * them.
 */
package steward.lab.bench;
