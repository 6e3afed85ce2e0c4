/**
 * Measuring whole matches and crowds: sections of contenders, rows of results, meters, and the files and page that
 * store them.
 */
package steward.lab.bench;
